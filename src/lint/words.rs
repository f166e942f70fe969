//! Words that stand in the text, those included that the compiler does not see: a name in a group
//! that `#if` left out, or in a macro that nothing calls, may be needed once a switch is set.

use super::broken::Broken;
use crate::semantic::Program;
use crate::syntax::{Lexer, RawKind, TokenKind};
use crate::text::{Role, Span};
use rustc_hash::{FxHashMap, FxHashSet};

/// The words that the compiler does not see.
#[derive(Default, Debug)]
pub struct Unseen<'a>(FxHashSet<&'a str>);

/// How often each word stands in the user's files, comments aside.
#[derive(Default, Debug)]
pub struct Counts<'a>(FxHashMap<&'a str, u32>);

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

impl<'a> Counts<'a> {
    /// Reads the files of a shader.
    pub fn of(program: &'a Program) -> Counts<'a> {
        let mut counts = FxHashMap::default();
        each_text(program, |text| {
            each_word(text, |word| *counts.entry(word).or_insert(0) += 1);
        });
        Counts(counts)
    }

    /// How often a word stands in the user's files.
    pub fn of_word(&self, word: &str) -> u32 {
        self.0.get(word).copied().unwrap_or(0)
    }
}

/// Calls `visit` with the text of each of the user's files.
pub fn each_text<'a>(program: &'a Program, mut visit: impl FnMut(&'a str)) {
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
            visit(&file.text);
        }
    }
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
