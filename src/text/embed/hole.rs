//! A part of a shader that is put in when the program runs.

use std::ops::Range;

/// A part of a shader that is put in.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Hole {
    /// Where it stands.
    pub range: Range<usize>,
    /// What is put in.
    pub content: HoleContent,
}

/// What is put in.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum HoleContent {
    /// What an expression says, whose text this is.
    Expression(String),
    /// This text.
    Known(String),
    /// Nothing: it steers the program that writes the shader.
    Nothing,
}
