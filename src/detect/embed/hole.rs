//! A part of a shader that is inserted at run time.

use shaderlint_syntax::{Version, WordClass, classify};
use std::ops::Range;

/// A part of a shader that is inserted at run time.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Hole {
    /// Range in the code.
    pub range: Range<usize>,
    /// What is inserted.
    pub content: HoleContent,
    /// The first and the last byte of the text that may be inserted there.
    pub inserted: Option<(u8, u8)>,
}

/// What is inserted.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum HoleContent {
    /// The value of this expression.
    Expression(String),
    /// This text.
    Known(String),
    /// One of several texts, of which this is one; of the expression only the name of a chunk is known
    /// well enough.
    Chosen(String, String),
    /// Nothing: a control construct of a template.
    Nothing,
}

/// Whether a word is a keyword at the start of declarations or statements, or a type.
pub(super) fn is_keyword(word: &str) -> bool {
    let is_in = |version| {
        let class = classify(word, version);
        matches!(class, WordClass::Keyword(_) | WordClass::Type(_))
    };
    !matches!(word, "true" | "false") && (is_in(Version::Es100) || is_in(Version::Es300))
}
