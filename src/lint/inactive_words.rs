//! Words in code that the compiler does not see: a name in a group that `#if` excludes, or in an unused
//! macro, may be needed once a switch is set.

use super::broken::Broken;
use super::words::each_word;
use rustc_hash::FxHashSet;
use shaderlint_semantic::Program;
use shaderlint_syntax::TokenKind;

/// The words in code that the compiler does not see.
#[derive(Default, Debug)]
pub struct InactiveWords<'a>(FxHashSet<&'a str>);

impl<'a> InactiveWords<'a> {
    /// Collects the words of excluded groups, of unused macros, and of items with errors.
    pub fn of(program: &'a Program, broken: &Broken<'a>) -> InactiveWords<'a> {
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
        InactiveWords(words)
    }

    /// Whether a word occurs in code that the compiler does not see.
    pub fn has(&self, word: &str) -> bool {
        self.0.contains(word)
    }
}
