//! Words that stand in the text, those included that the compiler does not see: a name in a group
//! that `#if` left out, or in a macro that nothing calls, may be needed once a switch is set.

use crate::semantic::Program;
use crate::syntax::{Lexer, RawKind, TokenKind};
use crate::text::{Role, Span};
use rustc_hash::{FxHashMap, FxHashSet};

/// The words of a shader's files.
#[derive(Default, Debug)]
pub struct Words<'p> {
    /// How often each stands in the user's files, comments aside.
    counts: FxHashMap<&'p str, u32>,
    /// Those that the compiler does not see.
    unseen: FxHashSet<&'p str>,
}

impl<'p> Words<'p> {
    /// Reads the files of a shader.
    pub fn of(program: &Program<'p>) -> Words<'p> {
        let mut words = Words::default();
        let tokens = &program.tokens;
        let sources = program.sources;
        let mut seen_files = FxHashSet::default();
        let first_and_last = tokens.tokens.iter().map(|t| t.span.start);
        let mut last_base = None;
        for address in first_and_last {
            // Tokens come file by file.
            let Some(file) = (match last_base {
                Some((base, end)) if (base..=end).contains(&address) => None,
                _ => sources.file_at(address),
            }) else {
                continue;
            };
            last_base = Some((file.base, file.span().end));
            if file.role == Role::User && seen_files.insert(file.base) {
                each_word(&file.text, |word| {
                    *words.counts.entry(word).or_insert(0) += 1;
                });
            }
        }
        for &span in &tokens.inactive {
            each_word(sources.text(span), |word| {
                words.unseen.insert(word);
            });
        }
        words.read_uncalled_macros(program);
        words
    }

    /// Notes the words of macros that are never expanded.
    fn read_uncalled_macros(&mut self, program: &Program<'p>) {
        let tokens = &program.tokens;
        let called: FxHashSet<u32> = tokens.expansions.iter().map(|e| e.definition.0).collect();
        for (i, definition) in tokens.macros.iter().enumerate() {
            if definition.predefined || called.contains(&(i as u32)) {
                continue;
            }
            for piece in &definition.body {
                if piece.token.kind == TokenKind::Identifier && piece.token.is_direct() {
                    self.unseen.insert(program.sources.text(piece.token.span));
                }
            }
        }
    }

    /// How often a word stands in the user's files.
    pub fn count(&self, word: &str) -> u32 {
        self.counts.get(word).copied().unwrap_or(0)
    }

    /// Whether a word stands where the compiler does not see it.
    pub fn is_unseen(&self, word: &str) -> bool {
        self.unseen.contains(word)
    }
}

fn each_word<'a>(text: &'a str, mut visit: impl FnMut(&'a str)) {
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
