//! Result of a check, for the comparison before and after fixes.

use crate::checked_spans::CheckedSpans;
use shaderlint_diagnostic::Diagnostic;
use shaderlint_semantic::Program;
use shaderlint_text::Span;
use std::sync::Arc;

/// The findings in a text, and its addresses.
pub struct Look {
    /// The findings, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
    /// Addresses of the text.
    pub span: Span,
    /// Which code was checked; `None` means all of it.
    pub checked_spans: Option<CheckedSpans>,
    /// Number of tokens and macro calls.
    pub size: usize,
    /// The shaders, if images are compared.
    pub shaders: Vec<Shown>,
}

/// A shader in a text.
pub struct Shown {
    /// The checked shader.
    pub program: Arc<Program>,
    /// Whether it is complete and compiles, so that it can be drawn.
    pub is_drawn: bool,
}
