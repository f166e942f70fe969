//! How likely a name is at a place: how often this text uses it, and shaders in general.

use rustc_hash::FxHashMap;
use shaderlint_syntax::{RawKind, RawToken, TokenKind, tokenize};
use std::sync::OnceLock;

/// What the grammar allows at a word.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum WordPlace {
    /// The start of a declaration outside of functions.
    Global,
    /// The start of a parameter.
    Parameter,
    /// The start of a statement or of a declaration in a function.
    Statement,
    /// In an expression.
    Expression,
}

/// The use of words in a text, as seen from a place in it.
pub(super) struct Usage<'t> {
    /// What the grammar allows at the place.
    pub place: WordPlace,
    /// The first character of the token after the place, on the same line.
    pub next: Option<char>,
    weights: FxHashMap<&'t str, f32>,
}

/// Weight of a use in the text.
const USE: f32 = 1.0;
/// Additional weight of a use that is near, at distance 0.
const NEAR: f32 = 4.0;
/// The distance in words at which this is halved.
const NEARNESS: f32 = 60.0;
/// Factor of a use at another kind of place.
const ELSEWHERE: f32 = 0.3;
/// Additional weight of a use after the same token.
const AFTER: f32 = 4.0;
/// Additional weight of a use after the same two tokens.
const AFTER_TWO: f32 = 20.0;
/// Additional weight of a use after the same word, whatever is between.
const AFTER_WORD: f32 = 5.0;
/// Additional weight of a use after the same two words.
const AFTER_TWO_WORDS: f32 = 20.0;
/// Additional weight of a use before the same token.
const BEFORE: f32 = 6.0;
/// Additional weight of a name that is declared before the place and not used yet.
const UNUSED: f32 = 15.0;
/// Weight of one use per 1,000 words in shaders in general.
const GENERAL: f32 = 0.3;
/// Weight of a name that was not seen.
const LEAST: f32 = 0.05;

impl<'t> Usage<'t> {
    /// The use of the words of a text around an offset, at which a word starts.
    pub fn of(text: &'t str, offset: u32) -> Usage<'t> {
        let mut seen: Vec<SeenWord> = Vec::new();
        let mut state = PlaceState::default();
        let mut before = WordContext::default();
        // What is at the offset: its place, the tokens before, and the number of words before.
        let mut here = None;
        let mut next: Option<&str> = None;
        for token in tokenize(text, 0) {
            let span = token.span;
            let word = text.get(span.start as usize..span.end as usize);
            let word = word.unwrap_or("");
            if here.is_none() && span.end > offset {
                here = Some((state.place(), before, seen.len()));
            }
            if is_blank(&token) {
                state.pass_blank(&token);
                // A token on a later line does not continue the expression of an incomplete line.
                if here.is_some() && token.kind == RawKind::Newline {
                    next = next.or(Some(""));
                }
                continue;
            }
            let is_word = token.kind == RawKind::Word;
            let is_hole = is_word && span.start <= offset && offset < span.end;
            if let Some(last) = seen.last_mut().filter(|seen| seen.next.is_empty()) {
                last.next = word;
            }
            if here.is_some() && !is_hole {
                next = next.or(Some(word));
            }
            if is_word && !is_hole {
                seen.push(SeenWord {
                    word,
                    before,
                    next: "",
                    place: state.place(),
                });
            }
            state.pass(token.kind, word);
            before.tokens = [before.tokens[1], word];
            if is_word && !is_hole {
                before.words = [before.words[1], word];
            }
        }
        let (place, before, at) = here.unwrap_or((state.place(), before, seen.len()));
        let next = next.unwrap_or("");
        Usage {
            place,
            next: next.chars().next(),
            weights: weights(&seen, place, before, next, at),
        }
    }

    /// A number that is greater for a more likely name.
    pub fn likelihood(&self, name: &str) -> f32 {
        let [outside, start, value] = general(name);
        let general = match self.place {
            WordPlace::Expression => value,
            WordPlace::Statement => start,
            _ => outside,
        };
        LEAST + general * GENERAL + self.weights.get(name).copied().unwrap_or(0.0)
    }
}

/// The weights of the words for a place of this kind, between these tokens, after `at` words.
fn weights<'t>(
    seen: &[SeenWord<'t>],
    place: WordPlace,
    before: WordContext,
    next: &str,
    at: usize,
) -> FxHashMap<&'t str, f32> {
    let mut counts: FxHashMap<&str, u32> = FxHashMap::default();
    for used in seen {
        *counts.entry(used.word).or_default() += 1;
    }
    let mut weights: FxHashMap<&str, f32> = FxHashMap::default();
    for (used, i) in seen.iter().zip(0..) {
        let distance = at.abs_diff(i) as f32;
        let mut weight = USE + NEAR * NEARNESS / (NEARNESS + distance);
        if used.place != place {
            weight *= ELSEWHERE;
        }
        if used.before.tokens[1] == before.tokens[1] {
            weight += AFTER;
            if used.before.tokens[0] == before.tokens[0] {
                weight += AFTER_TWO;
            }
        }
        if used.before.words[1] == before.words[1] {
            weight += AFTER_WORD;
            if used.before.words[0] == before.words[0] {
                weight += AFTER_TWO_WORDS;
            }
        }
        if !next.is_empty() && used.next == next {
            weight += BEFORE;
        }
        if i < at && counts.get(used.word) == Some(&1) {
            weight += UNUSED;
        }
        *weights.entry(used.word).or_default() += weight;
    }
    weights
}

/// What precedes a word.
#[derive(Clone, Copy, Default)]
struct WordContext<'t> {
    /// The last two tokens.
    tokens: [&'t str; 2],
    /// The last two words.
    words: [&'t str; 2],
}

/// A word of the text.
struct SeenWord<'t> {
    word: &'t str,
    before: WordContext<'t>,
    /// The token after.
    next: &'t str,
    place: WordPlace,
}

fn is_blank(token: &RawToken) -> bool {
    token.kind == RawKind::Newline || token.kind.is_blank()
}

/// What precedes a token.
#[derive(Default)]
struct PlaceState {
    braces: u32,
    parens: u32,
    /// Whether the next word starts a statement or declaration.
    is_middle: bool,
    is_directive: bool,
    /// The keyword before the open parenthesis.
    control: Option<u32>,
    was_for: bool,
}

impl PlaceState {
    fn place(&self) -> WordPlace {
        match (
            self.is_middle || self.is_directive,
            self.braces,
            self.parens,
        ) {
            (true, ..) => WordPlace::Expression,
            (false, 0, 0) => WordPlace::Global,
            (false, 0, _) => WordPlace::Parameter,
            (false, ..) => WordPlace::Statement,
        }
    }

    fn pass_blank(&mut self, token: &RawToken) {
        if token.kind == RawKind::Newline {
            self.is_directive = false;
        }
    }

    fn pass(&mut self, kind: RawKind, word: &str) {
        if kind == RawKind::Hash {
            self.is_directive = true;
        }
        if self.is_directive {
            return;
        }
        let was_for = std::mem::take(&mut self.was_for);
        match kind {
            RawKind::Operator(TokenKind::LeftBrace) => {
                self.braces += 1;
                self.parens = 0;
                self.is_middle = false;
            }
            RawKind::Operator(TokenKind::RightBrace) => {
                self.braces = self.braces.saturating_sub(1);
                self.parens = 0;
                self.is_middle = false;
            }
            RawKind::Operator(TokenKind::Semicolon) => {
                // The condition and the step of a `for`.
                self.is_middle = self.parens > 0;
            }
            RawKind::Operator(TokenKind::LeftParen) => {
                self.parens += 1;
                // Parameters, or the initial declaration of a `for`.
                self.is_middle = !was_for && self.braces > 0;
            }
            RawKind::Operator(TokenKind::RightParen) => {
                self.parens = self.parens.saturating_sub(1);
                let is_control = self.control == Some(self.parens);
                self.is_middle = !is_control;
                if is_control {
                    self.control = None;
                }
            }
            RawKind::Operator(TokenKind::Comma) if self.braces == 0 && self.parens > 0 => {
                self.is_middle = false;
            }
            RawKind::Operator(TokenKind::Colon) => self.is_middle = false,
            RawKind::Word => match word {
                "if" | "for" | "while" | "switch" => {
                    self.control = Some(self.parens);
                    self.was_for = word == "for";
                    self.is_middle = true;
                }
                "else" | "do" | "const" | "in" | "out" | "inout" | "uniform" | "varying"
                | "attribute" | "highp" | "mediump" | "lowp" | "flat" => self.is_middle = false,
                _ => self.is_middle = true,
            },
            _ => self.is_middle = true,
        }
    }
}

/// How often shaders use a name outside of functions, at the start of statements, and in expressions,
/// per 1,000 words.
fn general(name: &str) -> [f32; 3] {
    static COUNTS: OnceLock<FxHashMap<&'static str, [f32; 3]>> = OnceLock::new();
    let counts = COUNTS.get_or_init(|| {
        let lines = include_str!("usage.txt").lines();
        let lines = lines.filter(|line| !line.starts_with('#'));
        let read = |line: &'static str| {
            let mut words = line.split(' ');
            let name = words.next()?;
            let mut count = || words.next()?.parse::<f32>().ok();
            Some((name, [count()? / 100.0, count()? / 100.0, count()? / 100.0]))
        };
        lines.filter_map(read).collect()
    });
    counts.get(name).copied().unwrap_or([0.0; 3])
}
