//! What is seen of a text before and after fixes.

use super::judged::Judged;
use shaderlint_diagnostic::Diagnostic;
use shaderlint_semantic::Program;
use shaderlint_text::Span;
use std::sync::Arc;

/// What the findings in a text are, and where the text lies among the addresses.
pub struct Look {
    /// The findings.
    pub diagnostics: Vec<Diagnostic>,
    /// Addresses of the text.
    pub span: Span,
    /// What of the text was judged; `None` stands for all of it.
    pub judged: Option<Judged>,
    /// How many tokens and macro calls were read.
    pub size: usize,
    /// Its shaders, where pictures are compared.
    pub shaders: Vec<Shown>,
}

/// A shader of a text.
pub struct Shown {
    /// What it means.
    pub program: Arc<Program>,
    /// Whether it is whole and compiles, so that it has a picture.
    pub is_drawn: bool,
}
