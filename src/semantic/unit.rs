//! Input and result of the analysis of one shader.

use super::builtins::Stage;
use super::chunk::{Completeness, Open};
use super::dialect::Dialect;
use super::program::Program;
use shaderlint_diagnostic::{Diagnostic, Severity};
use shaderlint_text::{FileId, Sources};
use std::sync::Arc;

/// A shader to analyse.
pub struct Unit<'a> {
    /// All source files.
    pub sources: &'a Arc<Sources>,
    /// The files of the shader, in compilation order.
    pub files: &'a [FileId],
    /// Vertex or fragment.
    pub stage: Stage,
    /// Host that runs the shader.
    pub dialect: Dialect,
    /// Whether the types of its channels are unknown and inferred from their uses.
    pub infer_channels: bool,
    /// How much of a shader the files contain.
    pub completeness: Completeness,
}

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
