//! Formatter requests other than style, and the reason for a refusal.

use shaderlint_text::{Edit, Span};

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

/// The result of formatting a text.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct FormattedText {
    /// The edits in order, with spans relative to the start of the text.
    pub edits: Vec<Edit>,
    /// Why functions, or all of the text, are left as they are.
    pub left: Vec<Unformatted>,
}

/// Why a text or a function cannot be formatted.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Unformatted {
    /// The byte range in the text.
    pub span: Span,
    /// The error message.
    pub message: String,
}
