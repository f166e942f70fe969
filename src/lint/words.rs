//! Words in a text.

use rustc_hash::FxHashMap;
use shaderlint_semantic::Program;
use shaderlint_syntax::{Lexer, RawKind};
use shaderlint_text::{Role, Span};

/// Number of occurrences of each word in the user's files, without comments.
pub fn counts(program: &Program) -> FxHashMap<&str, u32> {
    let mut counts = FxHashMap::default();
    let mut done = Span::default();
    for token in &program.tokens.tokens {
        // Tokens come file by file.
        if !done.is_empty() && done.contains(token.span) {
            continue;
        }
        let Some(file) = program.sources.file_at(token.span.start) else {
            continue;
        };
        done = file.span();
        if file.role == Role::User {
            each_word(&file.text, |word| *counts.entry(word).or_default() += 1);
        }
    }
    counts
}

/// Calls `visit` with each word of a text, without comments.
pub fn each_word<'a>(text: &'a str, mut visit: impl FnMut(&'a str)) {
    let mut lexer = Lexer::new(text, 0);
    loop {
        let token = lexer.next_token();
        match token.kind {
            RawKind::End => return,
            RawKind::Word => {
                let Span { start, end } = token.span;
                if let Some(word) = text.get(start as usize..end as usize) {
                    visit(word);
                }
            }
            _ => {}
        }
    }
}
