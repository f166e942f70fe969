//! Detects typos lexically: suggests the declared name that a word is closest to.

use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_syntax::{Lexer, RawKind, Version, WordClass, classify};
use std::cell::Cell;

/// Minimum length in bytes of names that are compared; in shorter names each letter matters.
const SHORTEST: usize = 4;
/// Maximum number of letters of names that may differ by one edit only; longer ones may differ by
/// two.
const MOST_OF_ONE: usize = 9;
/// Number of names that all words of a text together are compared with.
const MAX_COMPARED: usize = 50_000;

/// The words of a text.
pub struct Vocabulary<'t> {
    counts: FxHashMap<&'t str, usize>,
    declared: FxHashSet<&'t str>,
    /// Number of names that may still be compared.
    budget: Cell<usize>,
}

impl<'t> Vocabulary<'t> {
    /// Collects the words of a text, without comments.
    pub fn of(code: &'t str) -> Vocabulary<'t> {
        let mut found = Vocabulary {
            counts: FxHashMap::default(),
            declared: FxHashSet::default(),
            budget: Cell::new(MAX_COMPARED),
        };
        let mut before = "";
        for (_, token) in TextTokens::of(code) {
            if token.is_word {
                *found.counts.entry(token.text).or_default() += 1;
                let is_type = matches!(classify(before, Version::Es300), WordClass::Type(_));
                if is_type || before == "define" {
                    found.declared.insert(token.text);
                }
            }
            before = if token.is_word { token.text } else { "" };
        }
        found
    }

    /// How often a word appears.
    pub fn count(&self, word: &str) -> usize {
        self.counts.get(word).copied().unwrap_or(0)
    }

    /// Whether a word follows a type.
    pub fn declares(&self, word: &str) -> bool {
        self.declared.contains(word)
    }

    /// The declared name that is closest to a word, if the word looks like a typo of it. `None` after
    /// as many comparisons as a text with thousands of names needs.
    pub fn nearest(&self, word: &str) -> Option<&'t str> {
        self.budget
            .set(self.budget.get().checked_sub(self.declared.len())?);
        let near = self.declared.iter().copied().filter(|n| is_typo(word, n));
        let by_distance = near.map(|n| (strsim::damerau_levenshtein(n, word), n));
        by_distance.min().map(|(_, name)| name)
    }
}

/// Whether a name looks like a typo of another: within one edit, or two if it is long, ignoring
/// case. Digits and first letters distinguish names on purpose: `uv1` and `uv2`, `normal` and
/// `vNormal`.
pub fn is_typo(word: &str, name: &str) -> bool {
    if word.len().max(name.len()) < SHORTEST || word == name {
        return false;
    }
    let (word, name) = (word.to_ascii_lowercase(), name.to_ascii_lowercase());
    if word == name {
        return true;
    }
    let letters = |w: &str| w.chars().filter(char::is_ascii_alphabetic).count();
    let limit = 1 + usize::from(letters(&word).min(letters(&name)) > MOST_OF_ONE);
    let part = |w: &str, digits: bool| -> String {
        let of_kind = |c: &char| c.is_ascii_digit() == digits;
        w.chars().filter(of_kind).collect()
    };
    // Names that differ in their number are different names.
    let is_other_number =
        part(&word, false) == part(&name, false) && part(&word, true) != part(&name, true);
    let first_two = |w: &str| -> Vec<char> { w.chars().take(2).collect() };
    let (from, to) = (first_two(&word), first_two(&name));
    let starts_alike = from.first() == to.first() || from.iter().rev().eq(&to);
    starts_alike
        && !is_other_number
        && word.len().abs_diff(name.len()) <= limit
        && strsim::damerau_levenshtein(&word, &name) <= limit
}

/// The words of a text that may be variables, with their offsets: no members, directives, keywords
/// or built-in functions.
pub fn variables(code: &str) -> Vec<(usize, &str)> {
    let mut found = Vec::new();
    let mut before = ' ';
    let mut in_directive = false;
    for (at, token) in TextTokens::of(code) {
        in_directive = match token.text {
            "#" => true,
            "\n" => false,
            _ => in_directive,
        };
        let is_plain = || {
            let versions = [Version::Es100, Version::Es300];
            versions
                .iter()
                .all(|v| classify(token.text, *v) == WordClass::Plain)
        };
        if token.is_word && !in_directive && before != '.' && is_plain() {
            found.push((at, token.text));
        }
        before = token.text.chars().next_back().unwrap_or(' ');
    }
    found
}

/// The tokens of a text with their offsets: words, punctuation and line breaks.
struct TextTokens<'t> {
    code: &'t str,
    lexer: Lexer<'t>,
}

struct TextToken<'t> {
    text: &'t str,
    is_word: bool,
}

impl<'t> TextTokens<'t> {
    fn of(code: &'t str) -> TextTokens<'t> {
        TextTokens {
            code,
            lexer: Lexer::new(code, 0),
        }
    }
}

impl<'t> Iterator for TextTokens<'t> {
    type Item = (usize, TextToken<'t>);

    fn next(&mut self) -> Option<(usize, TextToken<'t>)> {
        loop {
            let token = self.lexer.next_token();
            let range = token.span.start as usize..token.span.end as usize;
            let text = self.code.get(range.clone()).unwrap_or("");
            return match token.kind {
                RawKind::End => None,
                RawKind::Whitespace | RawKind::LineComment | RawKind::BlockComment => continue,
                RawKind::Newline => Some((
                    range.start,
                    TextToken {
                        text: "\n",
                        is_word: false,
                    },
                )),
                kind => Some((
                    range.start,
                    TextToken {
                        text,
                        is_word: kind == RawKind::Word,
                    },
                )),
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn typos_are_matched_to_the_intended_name() {
        for (word, name) in [
            ("opcaity", "opacity"),
            ("colr", "color"),
            ("coloor", "color"),
            ("Color", "color"),
            ("u_tme", "u_time"),
            ("u_isplain", "u_is_plain"),
            ("radiu2s", "radius2"),
        ] {
            assert!(is_typo(word, name), "{word}");
        }
        for (word, name) in [
            ("uv1", "uv2"),
            ("color1", "color2"),
            ("abs", "abz"),
            ("cameraFar", "cameraNear"),
            ("vNormal", "normal"),
            ("v_normal", "normal"),
            ("log_fp64", "exp_fp64"),
        ] {
            assert!(!is_typo(word, name), "{word}");
        }
    }

    #[test]
    fn names_of_a_text_are_candidates_for_typos() {
        let code = "uniform float opacity; // opcaity\n#define SCALE 2.0\nfloat f(vec2 at) {\n\
            return opcaity * SCALE * at.opcty;\n}";
        let found = Vocabulary::of(code);
        assert_eq!(found.count("opcaity"), 1);
        assert_eq!(found.nearest("opcaity"), Some("opacity"));
        assert_eq!(found.nearest("SCLAE"), Some("SCALE"));
        let words: Vec<&str> = variables(code).into_iter().map(|(_, w)| w).collect();
        assert_eq!(words, ["opacity", "f", "at", "opcaity", "SCALE", "at"]);
    }
}
