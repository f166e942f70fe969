//! What is asked of the formatter besides a style, and why it may refuse.

use shaderlint_text::Span;

/// What a text is part of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TextExtent {
    /// A file of its own: blank lines at both ends go, the last line is ended.
    File,
    /// A part of a text in another language: what stands around it stays.
    Inside,
}

/// What becomes of line breaks.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Lines {
    /// Statements get lines of their own.
    Free,
    /// Every token stays in its line, as its number is asked for: `__LINE__`.
    Kept,
}

/// Why a text is not formatted.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Unformatted {
    /// Where, in bytes from the start of the text.
    pub span: Span,
    /// What is wrong there.
    pub message: String,
}
