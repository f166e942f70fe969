//! Mutates shaders: by tokens, so that the result is nearly valid, and sometimes by bytes.

use shaderlint::syntax::tokenize;

/// Maximum length of a mutated text, in bytes.
const MAX_TEXT: usize = 64 * 1024;

/// Pseudorandom numbers that depend only on the seed (xorshift).
pub struct Random(u64);

impl Random {
    /// The generator for a seed.
    pub fn new(seed: u64) -> Random {
        Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    /// A number less than `limit`; 0 if the limit is 0.
    pub fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 16) as usize % limit.max(1)
    }

    fn pick<'a, T>(&mut self, all: &'a [T]) -> Option<&'a T> {
        all.get(self.below(all.len()))
    }
}

/// The tokens of a text, including white space and comments.
pub fn split(text: &str) -> Vec<String> {
    let text_of = |start: u32, end: u32| text[start as usize..end as usize].to_string();
    let tokens = tokenize(text, 0);
    tokens
        .iter()
        .map(|t| text_of(t.span.start, t.span.end))
        .collect()
}

/// A text made of one seed text, or of two, with 1 to 16 mutations.
pub fn mutate(random: &mut Random, seeds: &[String]) -> String {
    let seed = |random: &mut Random| random.pick(seeds).map_or(Vec::new(), |s| split(s));
    let mut tokens = seed(random);
    let other = seed(random);
    for _ in 0..1 << random.below(5) {
        change(random, &mut tokens, &other);
    }
    let mut text = tokens.concat();
    if random.below(8) == 0 {
        text = change_bytes(random, text);
    }
    let mut end = text.len().min(MAX_TEXT);
    while !text.is_char_boundary(end) {
        end -= 1;
    }
    text.truncate(end);
    text
}

fn change(random: &mut Random, tokens: &mut Vec<String>, other: &[String]) {
    let at = random.below(tokens.len() + 1);
    let len = 1 << random.below(6);
    let end = (at + len).min(tokens.len());
    match random.below(7) {
        0 => drop(tokens.drain(at..end)),
        1 => {
            let again = tokens[at..end].to_vec();
            tokens.splice(at..at, again);
        }
        2 => {
            let from = random.below(other.len());
            let piece = other
                .get(from..(from + len).min(other.len()))
                .unwrap_or(&[])
                .to_vec();
            tokens.splice(at..end, piece);
        }
        3 => {
            if let Some(token) = random.pick(other) {
                tokens.insert(at, token.clone());
            }
        }
        4 => {
            if let (Some(token), Some(slot)) = (random.pick(other), tokens.get_mut(at)) {
                slot.clone_from(token);
            }
        }
        5 => {
            let to = random.below(tokens.len());
            if at < tokens.len() {
                tokens.swap(at, to);
            }
        }
        _ => {
            let count = 1 << random.below(9);
            if let Some(token) = tokens.get(at).cloned() {
                tokens.splice(at..at, std::iter::repeat_n(token, count));
            }
        }
    }
}

fn change_bytes(random: &mut Random, text: String) -> String {
    let mut bytes = text.into_bytes();
    for _ in 0..1 << random.below(4) {
        let at = random.below(bytes.len());
        if let Some(byte) = bytes.get_mut(at) {
            *byte = random.below(256) as u8;
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}
