//! Words in a text.

use shaderlint_semantic::Program;
use shaderlint_syntax::{Lexer, RawKind};
use shaderlint_text::{Role, SourceFile, Span};

/// Number of occurrences of a word in the user's files, without comments.
pub fn count(program: &Program, word: &str) -> usize {
    let tokens = &program.tokens;
    let is_comment = |address: u32| {
        let next = tokens.comments.partition_point(|c| c.start <= address);
        let before = next.checked_sub(1).and_then(|i| tokens.comments.get(i));
        before.is_some_and(|c| address < c.end)
    };
    let in_file = |file: &SourceFile| {
        let is_part = |c: u8| c.is_ascii_alphanumeric() || c == b'_' || c >= 0x80;
        let at = |i: usize| file.text.as_bytes().get(i).copied();
        let found = file.text.match_indices(word).filter(|(start, _)| {
            let before = start.checked_sub(1).and_then(at);
            let after = at(start + word.len());
            let is_word = !before.is_some_and(is_part) && !after.is_some_and(is_part);
            is_word && !is_comment(file.base + *start as u32)
        });
        found.count()
    };
    let mut total = 0;
    let mut done = Span::default();
    for token in &tokens.tokens {
        // Tokens come file by file.
        if !done.is_empty() && done.contains(token.span) {
            continue;
        }
        let Some(file) = program.sources.file_at(token.span.start) else {
            continue;
        };
        done = file.span();
        if file.role == Role::User {
            total += in_file(file);
        }
    }
    total
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
