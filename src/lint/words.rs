//! Words that stand in the text, those included that the compiler does not see: a name in a group
//! that `#if` left out, or in a macro that nothing calls, may be needed once a switch is set.

use super::broken::Broken;
use crate::semantic::Program;
use crate::syntax::{Lexer, RawKind, TokenKind};
use crate::text::{Role, SourceFile, Span};
use rustc_hash::FxHashSet;

/// The words that the compiler does not see.
#[derive(Default, Debug)]
pub struct Unseen<'a>(FxHashSet<&'a str>);

impl<'a> Unseen<'a> {
    /// Reads what `#if` left out, the macros that are never expanded, and what has errors.
    pub fn of(program: &'a Program, broken: &Broken<'a>) -> Unseen<'a> {
        let mut words: FxHashSet<&'a str> = broken.words().collect();
        let tokens = &program.tokens;
        for &span in &tokens.inactive {
            each_word(program.sources.text(span), |word| {
                words.insert(word);
            });
        }
        let called: FxHashSet<u32> = tokens.expansions.iter().map(|e| e.definition.0).collect();
        for (i, definition) in tokens.macros.iter().enumerate() {
            if definition.predefined || called.contains(&(i as u32)) {
                continue;
            }
            for piece in &definition.body {
                if piece.token.kind == TokenKind::Identifier && piece.token.is_direct() {
                    words.insert(program.sources.text(piece.token.span));
                }
            }
        }
        Unseen(words)
    }

    /// Whether a word stands where the compiler does not see it.
    pub fn has(&self, word: &str) -> bool {
        self.0.contains(word)
    }
}

/// How often a word stands in the user's files, comments aside.
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
            let behind = at(start + word.len());
            let is_whole = !before.is_some_and(is_part) && !behind.is_some_and(is_part);
            is_whole && !is_comment(file.base + *start as u32)
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

/// Calls `visit` with each word of a text, comments aside.
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
