//! A shader that is to be checked, and what is found.

use super::builtins::Stage;
use super::dialect::Dialect;
use super::part::{Open, Wholeness};
use super::program::Program;
use shaderlint_diagnostic::{Diagnostic, Severity};
use shaderlint_text::{FileId, Sources};
use std::sync::Arc;

/// What makes up one shader.
pub struct Unit<'a> {
    /// All files.
    pub sources: &'a Arc<Sources>,
    /// Those of the shader, in the order in which they are compiled.
    pub files: &'a [FileId],
    /// The stage it is written for.
    pub stage: Stage,
    /// Who runs it.
    pub dialect: Dialect,
    /// Whether the types of its channels are not known, and are to be what its uses need.
    pub infer_channels: bool,
    /// How much of the shader that is.
    pub wholeness: Wholeness,
}

/// A shader, checked.
pub struct Checked {
    /// What is known of it.
    pub program: Program,
    /// What the browser's compiler would refuse, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
    /// What a part leaves open.
    pub open: Open,
    /// How much of a shader that is.
    pub wholeness: Wholeness,
}

impl Checked {
    /// Whether the browser would refuse it.
    pub fn has_errors(&self) -> bool {
        let mut all = self.diagnostics.iter();
        all.any(|d| d.severity == Severity::Error)
    }
}
