//! Interned words: each distinct word of a shader is stored once and identified by an index.

use super::token::TokenKind;
use rustc_hash::FxHasher;
use shaderlint_text::{SetAt, WordIndex};
use std::hash::Hasher;

/// Index of a distinct word of one shader.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Name(pub u32);

macro_rules! type_words {
    ($count:literal: $($word:ident,)*) => {
        /// A word that names a built-in type.
        #[expect(missing_docs, reason = "the variants are standard terms")]
        #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
        #[repr(u8)]
        pub enum TypeWord { $($word),* }

        impl TypeWord {
            /// All type words, indexed by discriminant.
            pub const ALL: [TypeWord; $count] = [$(TypeWord::$word),*];
        }
    };
}

type_words! { 40:
    Bool, Int, Uint, Float,
    Vec2, Vec3, Vec4, Bvec2, Bvec3, Bvec4, Ivec2, Ivec3, Ivec4, Uvec2, Uvec3, Uvec4,
    Mat2, Mat2x3, Mat2x4, Mat3x2, Mat3, Mat3x4, Mat4x2, Mat4x3, Mat4,
    Sampler2D, Sampler3D, SamplerCube, Sampler2DArray,
    Isampler2D, Isampler3D, IsamplerCube, Isampler2DArray,
    Usampler2D, Usampler3D, UsamplerCube, Usampler2DArray,
    Sampler2DShadow, SamplerCubeShadow, Sampler2DArrayShadow,
}

impl TypeWord {
    /// The built-in type named by a word of GLSL ES 3.00.
    pub const fn named(word: &str) -> Option<TypeWord> {
        match classify(word, Version::Es300) {
            WordClass::Type(word) => Some(word),
            _ => None,
        }
    }

    /// The type's name in GLSL.
    pub fn name(self) -> &'static str {
        let row = TYPES.iter().find(|(_, _, word)| *word == self);
        row.map_or("", |(name, ..)| name)
    }
}

/// A version of the language that WebGL2 supports.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Version {
    /// GLSL ES 1.00: `#version 100`, or none.
    Es100,
    /// GLSL ES 3.00: `#version 300 es`.
    Es300,
}

/// Role of a word in one version of the language.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum WordClass {
    /// An ordinary identifier.
    Plain,
    /// A keyword.
    Keyword(TokenKind),
    /// A built-in type.
    Type(TypeWord),
    /// Reserved for future use; using it is an error.
    Reserved,
}

/// Role of a word in each version.
#[derive(Clone, Copy, Debug)]
struct Classes {
    es100: WordClass,
    es300: WordClass,
}

impl Classes {
    const fn of(self, version: Version) -> WordClass {
        match version {
            Version::Es100 => self.es100,
            Version::Es300 => self.es300,
        }
    }
}

/// The role of `word` in `version`.
pub const fn classify(word: &str, version: Version) -> WordClass {
    classes_of(word).of(version)
}

#[expect(
    clippy::indexing_slicing,
    reason = "the index holds positions in the list"
)]
const fn classes_of(word: &str) -> Classes {
    static INDEX: WordIndex<512> = WordIndex::new(&SPECIAL.words);
    static CLASSES: [Classes; SPECIAL_WORDS] = SPECIAL.classes;
    match INDEX.find(word) {
        Some(at) => CLASSES[at],
        None => Classes {
            es100: WordClass::Plain,
            es300: WordClass::Plain,
        },
    }
}

const SPECIAL: SpecialWords = SpecialWords::read();

/// Number of words with a special role in any version.
const SPECIAL_WORDS: usize = count_words(RESERVED_ALWAYS)
    + count_words(RESERVED_SINCE_300)
    + 1
    + KEYWORDS.len()
    + TYPES.len();

/// Words with a special role in any version, and those roles.
struct SpecialWords {
    words: [&'static str; SPECIAL_WORDS],
    classes: [Classes; SPECIAL_WORDS],
    count: usize,
}

#[expect(
    clippy::indexing_slicing,
    reason = "evaluated at compile time, where a wrong index does not compile"
)]
impl SpecialWords {
    const fn read() -> SpecialWords {
        use WordClass::{Plain, Reserved};
        let plain = Classes {
            es100: Plain,
            es300: Plain,
        };
        let mut special = SpecialWords {
            words: [""; SPECIAL_WORDS],
            classes: [plain; SPECIAL_WORDS],
            count: 0,
        };
        special.add_all(RESERVED_ALWAYS, (Reserved, Reserved));
        special.add_all(RESERVED_SINCE_300, (Plain, Reserved));
        special.add("packed", (Reserved, Plain));
        let mut i = 0;
        while i < KEYWORDS.len() {
            let (word, in_100, kind) = KEYWORDS[i];
            special.add(word, in_100.classes(WordClass::Keyword(kind)));
            i += 1;
        }
        let mut i = 0;
        while i < TYPES.len() {
            let (word, in_100, kind) = TYPES[i];
            special.add(word, in_100.classes(WordClass::Type(kind)));
            i += 1;
        }
        special
    }

    const fn add(&mut self, word: &'static str, (es100, es300): (WordClass, WordClass)) {
        self.words[self.count] = word;
        self.classes[self.count] = Classes { es100, es300 };
        self.count += 1;
    }

    const fn add_all(&mut self, text: &'static str, classes: (WordClass, WordClass)) {
        let mut rest = text;
        loop {
            rest = rest.trim_ascii_start();
            let len = word_len(rest);
            if len == 0 {
                return;
            }
            let (word, after) = rest.split_at(len);
            self.add(word, classes);
            rest = after;
        }
    }
}

const fn count_words(text: &str) -> usize {
    let mut rest = text.trim_ascii_start();
    let mut count = 0;
    while !rest.is_empty() {
        rest = rest.split_at(word_len(rest)).1.trim_ascii_start();
        count += 1;
    }
    count
}

/// Length of the word at the start of a text.
#[expect(clippy::indexing_slicing, reason = "the loop ends with the text")]
const fn word_len(text: &str) -> usize {
    let bytes = text.as_bytes();
    let mut len = 0;
    while len < bytes.len() && !bytes[len].is_ascii_whitespace() {
        len += 1;
    }
    len
}

/// Reserved by both GLSL ES 1.00 section 3.7 and 3.00 section 3.8; `samplerExternalOES` needs an
/// extension that WebGL2 does not have.
const RESERVED_ALWAYS: &str = include_str!("reserved_always.txt");

/// Reserved by GLSL ES 3.00 section 3.8 only; the four `image..Shadow` words are reserved by WebGL.
const RESERVED_SINCE_300: &str = include_str!("reserved_since_300.txt");

/// Role in GLSL ES 1.00 of a word that is special in 3.00.
#[derive(Clone, Copy)]
enum In100 {
    Same,
    Plain,
    Reserved,
    Only,
}

impl In100 {
    /// The roles of a word of version 3.00 in both versions.
    const fn classes(self, class: WordClass) -> (WordClass, WordClass) {
        match self {
            In100::Same => (class, class),
            In100::Plain => (WordClass::Plain, class),
            In100::Reserved => (WordClass::Reserved, class),
            In100::Only => (class, WordClass::Reserved),
        }
    }
}

#[rustfmt::skip]
const KEYWORDS: &[(&str, In100, TokenKind)] = {
    use In100::*;
    use TokenKind as T;
    &[
        ("attribute", Only, T::Attribute), ("varying", Only, T::Varying), ("const", Same, T::Const),
        ("uniform", Same, T::Uniform), ("layout", Plain, T::Layout), ("centroid", Plain, T::Centroid),
        ("flat", Reserved, T::Flat), ("smooth", Plain, T::Smooth), ("break", Same, T::Break),
        ("continue", Same, T::Continue), ("do", Same, T::Do), ("for", Same, T::For),
        ("while", Same, T::While), ("switch", Reserved, T::Switch), ("case", Plain, T::Case),
        ("default", Reserved, T::Default), ("if", Same, T::If), ("else", Same, T::Else),
        ("in", Same, T::In), ("out", Same, T::Out), ("inout", Same, T::Inout),
        ("void", Same, T::Void), ("true", Same, T::True), ("false", Same, T::False),
        ("invariant", Same, T::Invariant), ("discard", Same, T::Discard),
        ("return", Same, T::Return), ("lowp", Same, T::Lowp), ("mediump", Same, T::Mediump),
        ("highp", Same, T::Highp), ("precision", Same, T::Precision), ("struct", Same, T::Struct),
    ]
};

#[rustfmt::skip]
const TYPES: &[(&str, In100, TypeWord)] = {
    use In100::*;
    use TypeWord as T;
    &[
        ("bool", Same, T::Bool), ("int", Same, T::Int), ("uint", Plain, T::Uint),
        ("float", Same, T::Float), ("vec2", Same, T::Vec2), ("vec3", Same, T::Vec3),
        ("vec4", Same, T::Vec4), ("bvec2", Same, T::Bvec2), ("bvec3", Same, T::Bvec3),
        ("bvec4", Same, T::Bvec4), ("ivec2", Same, T::Ivec2), ("ivec3", Same, T::Ivec3),
        ("ivec4", Same, T::Ivec4), ("uvec2", Plain, T::Uvec2), ("uvec3", Plain, T::Uvec3),
        ("uvec4", Plain, T::Uvec4), ("mat2", Same, T::Mat2), ("mat3", Same, T::Mat3),
        ("mat4", Same, T::Mat4), ("mat2x2", Plain, T::Mat2), ("mat2x3", Plain, T::Mat2x3),
        ("mat2x4", Plain, T::Mat2x4), ("mat3x2", Plain, T::Mat3x2), ("mat3x3", Plain, T::Mat3),
        ("mat3x4", Plain, T::Mat3x4), ("mat4x2", Plain, T::Mat4x2), ("mat4x3", Plain, T::Mat4x3),
        ("mat4x4", Plain, T::Mat4), ("sampler2D", Same, T::Sampler2D),
        ("sampler3D", Reserved, T::Sampler3D), ("samplerCube", Same, T::SamplerCube),
        ("sampler2DArray", Plain, T::Sampler2DArray), ("isampler2D", Plain, T::Isampler2D),
        ("isampler3D", Plain, T::Isampler3D), ("isamplerCube", Plain, T::IsamplerCube),
        ("isampler2DArray", Plain, T::Isampler2DArray), ("usampler2D", Plain, T::Usampler2D),
        ("usampler3D", Plain, T::Usampler3D), ("usamplerCube", Plain, T::UsamplerCube),
        ("usampler2DArray", Plain, T::Usampler2DArray),
        ("sampler2DShadow", Reserved, T::Sampler2DShadow),
        ("samplerCubeShadow", Plain, T::SamplerCubeShadow),
        ("sampler2DArrayShadow", Plain, T::Sampler2DArrayShadow),
    ]
};

struct NameEntry {
    key: u64,
    start: u32,
    len: u32,
    classes: Classes,
    is_odd: bool,
}

/// Words longer than this, in bytes, are always classed as odd.
const USUAL_LENGTH: usize = 256;

/// The distinct words of one shader and their roles.
pub struct Names {
    text: String,
    entries: Vec<NameEntry>,
    /// Open-addressing hash table of indices into `entries` plus one; 0 marks an empty slot.
    slots: Vec<u32>,
}

impl Default for Names {
    fn default() -> Names {
        Names {
            text: String::with_capacity(4096),
            entries: Vec::with_capacity(512),
            slots: vec![0; 1024],
        }
    }
}

impl Names {
    /// The name of `word`, interning it if it is new.
    #[inline]
    pub fn intern(&mut self, word: &str) -> Name {
        let key = key(word);
        match self.find(key, word) {
            Ok(name) => name,
            Err(slot) => self.insert(slot, key, word),
        }
    }

    /// A name based on `base` that the shader does not use.
    pub fn unused(&self, base: &str) -> String {
        let mut name = base.to_string();
        let mut number = 2;
        while self.get(&name).is_some() {
            name = format!("{base}{number}");
            number += 1;
        }
        name
    }

    /// The name of `word`, if the shader uses it.
    pub fn get(&self, word: &str) -> Option<Name> {
        self.find(key(word), word).ok()
    }

    /// The name of `word`, or the slot where it would be inserted.
    #[inline]
    fn find(&self, key: u64, word: &str) -> Result<Name, usize> {
        let mask = self.slots.len() - 1;
        let mut slot = slot_of(key) & mask;
        while let Some(index) = self.slots.get(slot).and_then(|s| s.checked_sub(1)) {
            if self.is(index, key, word) {
                return Ok(Name(index));
            }
            slot = (slot + 1) & mask;
        }
        Err(slot)
    }

    /// The text of a name.
    pub fn text(&self, name: Name) -> &str {
        self.entries
            .get(name.0 as usize)
            .and_then(|e| self.text.get(e.start as usize..(e.start + e.len) as usize))
            .unwrap_or("")
    }

    /// The role of a name in a version of the language.
    pub fn class(&self, name: Name, version: Version) -> WordClass {
        self.entries
            .get(name.0 as usize)
            .map_or(WordClass::Plain, |e| e.classes.of(version))
    }

    /// Whether a name is very long or contains non-ASCII letters, so that it needs further checks.
    pub fn is_odd(&self, name: Name) -> bool {
        self.entries.get(name.0 as usize).is_some_and(|e| e.is_odd)
    }

    /// Number of distinct words; every [`Name`] is smaller.
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether no word has been interned.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// All words in order of first use.
    pub fn iter(&self) -> impl Iterator<Item = (Name, &str)> {
        (0..self.entries.len() as u32).map(|i| (Name(i), self.text(Name(i))))
    }

    #[inline]
    fn is(&self, index: u32, key: u64, word: &str) -> bool {
        self.entries.get(index as usize).is_some_and(|e| {
            let is_likely = e.key == key && e.len as usize == word.len();
            is_likely && (word.len() <= SHORT || self.text(Name(index)) == word)
        })
    }

    #[cold]
    fn insert(&mut self, slot: usize, key: u64, word: &str) -> Name {
        let index = self.entries.len() as u32;
        let classes = classes_of(word);
        let start = self.text.len() as u32;
        self.text.push_str(word);
        self.entries.push(NameEntry {
            key,
            start,
            len: word.len() as u32,
            classes,
            is_odd: word.len() > USUAL_LENGTH || !word.is_ascii(),
        });
        self.slots.set_at(slot, index + 1);
        if self.entries.len() * 2 > self.slots.len() {
            self.grow();
        }
        Name(index)
    }

    fn grow(&mut self) {
        let mask = self.slots.len() * 2 - 1;
        self.slots = vec![0; mask + 1];
        for (index, entry) in self.entries.iter().enumerate() {
            let mut slot = slot_of(entry.key) & mask;
            while self.slots.get(slot).is_some_and(|&s| s != 0) {
                slot = (slot + 1) & mask;
            }
            self.slots.set_at(slot, index as u32 + 1);
        }
    }
}

/// Longest word, in bytes, that its key and length identify completely.
const SHORT: usize = 8;

/// Hash key of a word: the bytes of a short word, a hash of a longer one.
#[inline]
fn key(word: &str) -> u64 {
    let bytes = word.as_bytes();
    let pair = |first: u32, last: u32| u64::from(first) << 32 | u64::from(last);
    match (bytes.first_chunk(), bytes.last_chunk()) {
        (Some(first), Some(last)) if bytes.len() <= SHORT => {
            pair(u32::from_le_bytes(*first), u32::from_le_bytes(*last))
        }
        (None, _) => bytes.iter().fold(0, |key, b| key << 8 | u64::from(*b)),
        _ => {
            let mut hasher = FxHasher::default();
            hasher.write(bytes);
            hasher.finish()
        }
    }
}

/// First slot to probe for a key.
#[inline]
fn slot_of(key: u64) -> usize {
    (key.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 40) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_of_names_stay_valid_while_the_table_grows() {
        let mut names = Names::default();
        let all: Vec<Name> = (0..5000)
            .map(|i| names.intern(&format!("word{i}")))
            .collect();
        for (i, &name) in all.iter().enumerate() {
            assert_eq!(names.text(name), format!("word{i}"));
            assert_eq!(names.get(&format!("word{i}")), Some(name));
        }
        assert_eq!(names.get("other"), None);
    }

    #[test]
    fn keywords_depend_on_the_version() {
        assert_eq!(classify("sample", Version::Es100), WordClass::Plain);
        assert_eq!(classify("sample", Version::Es300), WordClass::Reserved);
        assert_eq!(classify("packed", Version::Es100), WordClass::Reserved);
        assert_eq!(classify("packed", Version::Es300), WordClass::Plain);
        assert_eq!(classify("varying", Version::Es300), WordClass::Reserved);
        assert_eq!(classify("switch", Version::Es100), WordClass::Reserved);
        assert_eq!(classify("uint", Version::Es100), WordClass::Plain);
        assert_eq!(classify("image", Version::Es300), WordClass::Plain);
        assert_eq!(classify("sampler", Version::Es300), WordClass::Plain);
    }
}
