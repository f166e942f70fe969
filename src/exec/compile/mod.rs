//! From the middle form to register code.

use super::code::Code;
use crate::ir::{Module, Provenance};
use crate::semantic::Program;

/// How a shader is compiled.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct CompileOptions {
    /// What is watched while it runs.
    pub watch: Watch,
}

/// What is watched while a shader runs; each holds what stands before it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Debug)]
pub enum Watch {
    /// The picture alone.
    #[default]
    Nothing,
    /// Turns of loops, and which branches are taken.
    Flow,
    /// Numbers that go wrong.
    Numbers,
}

/// Why a shader is not run.
#[derive(Clone, PartialEq, Debug)]
pub struct Refusal {
    /// What cannot be run, in words.
    pub what: String,
    /// Where that stands.
    pub at: Provenance,
}

/// Compiles a shader from its entry on.
///
/// # Errors
/// What cannot be run, by name.
pub fn compile(
    _program: &Program,
    _module: &Module,
    _options: &CompileOptions,
) -> Result<Code, Refusal> {
    Err(Refusal {
        what: "the shader".to_string(),
        at: Provenance::Language,
    })
}
