//! Result of the analysis of one shader.

use super::chunk::Open;
use shaderlint_diagnostic::{Diagnostic, Severity};
use shaderlint_semantic::{Completeness, Program};

/// An analysed shader.
pub struct Checked {
    /// The checked program.
    pub program: Program,
    /// Errors and warnings of the browser's compiler, in source order.
    pub diagnostics: Vec<Diagnostic>,
    /// What cannot be resolved in a shader fragment.
    pub open: Open,
    /// How much of a shader the text contains.
    pub completeness: Completeness,
}

impl Checked {
    /// Whether the browser would reject it.
    pub fn has_errors(&self) -> bool {
        let mut all = self.diagnostics.iter();
        all.any(|d| d.severity == Severity::Error)
    }
}
