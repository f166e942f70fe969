//! The words of a text in any language.

use rustc_hash::{FxHashMap, FxHasher};
use std::hash::Hasher;

/// Extensions of GLSL files.
pub const GLSL: &[&str] = &[
    "glsl", "vert", "frag", "vs", "fs", "vsh", "fsh", "geom", "comp", "tesc", "tese",
];
/// Whether files with this extension are GLSL.
pub fn is_glsl(extension: &str) -> bool {
    GLSL.contains(&extension)
}

/// The bytes that words consist of, as a bit set.
const IN_WORD: u128 = {
    let mut bits = 1 << b'_';
    let mut byte = 0;
    while byte < 128 {
        bits |= ((byte as u8).is_ascii_alphanumeric() as u128) << byte;
        byte += 1;
    }
    bits
};

/// The identifiers of a text and similar words. Letters outside of ASCII separate words.
pub fn words(text: &str) -> impl Iterator<Item = &str> {
    let in_word = |&byte: &u8| byte < 128 && IN_WORD >> byte & 1 == 1;
    let mut at = 0;
    let next = move || {
        let rest = text.as_bytes().get(at..)?;
        let start = at + rest.iter().position(in_word)?;
        let word = text.as_bytes().get(start..)?;
        let length = word.iter().position(|byte| !in_word(byte));
        at = start + length.unwrap_or(word.len());
        text.get(start..at)
    };
    std::iter::from_fn(next)
}

/// How often each word of a text appears, by hash.
pub fn counts(text: &str) -> FxHashMap<u64, usize> {
    let mut found = FxHashMap::default();
    for word in words(text) {
        *found.entry(hash(word)).or_default() += 1;
    }
    found
}

/// The hash of a word.
pub fn hash(word: &str) -> u64 {
    let mut hasher = FxHasher::default();
    hasher.write(word.as_bytes());
    hasher.finish()
}
