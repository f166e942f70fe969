//! Formatter requests other than style, and the reason for a refusal.

use shaderlint_text::Span;

/// What a text is part of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TextExtent {
    /// A file: empty lines at both ends are removed, and the last line is terminated.
    File,
    /// Code embedded in another text, which is not changed.
    Inside,
}

/// How line breaks are treated.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Lines {
    /// Every statement starts a new line.
    Free,
    /// Every token stays on its line, because `__LINE__` is used.
    Kept,
}

/// Why a text cannot be formatted.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Unformatted {
    /// The byte range in the text.
    pub span: Span,
    /// The error message.
    pub message: String,
}
