//! How a shader is compiled, and why one is not.

use shaderlint_ir::{OpId, Provenance};
use shaderlint_semantic::{FunctionRef, VariableId};
use shaderlint_text::Span;

/// How a shader is compiled.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct CompileOptions {
    /// What is watched while it runs.
    pub watch: Watch,
    /// The function that runs; that of the shader, unless one is named.
    pub entry: Option<FunctionRef>,
    /// What is given out beside what the shader gives.
    pub probe: Option<Probe>,
    /// The bits of what was never written: zero in the browser.
    pub undefined: u32,
    /// The GPU that is played.
    pub persona: Persona,
    /// How many instructions it may become, where that is fewer than 400,000.
    pub most: Option<usize>,
}

/// A GPU as exact as the conformance suite asks, and no more (VK-GL-CTS, glsBuiltinPrecisionTests).
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Persona {
    /// As exact as it gets.
    #[default]
    Exact,
    /// Off by all that is allowed.
    Inexact(Lean),
    /// Exact, but that `mediump` and `lowp` are numbers of 16 bits.
    Mobile,
}

/// To which side results are off.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Lean {
    /// Away from zero; sines up.
    Out,
    /// Towards zero; sines down.
    In,
    /// Now this, now that, by the bits of the result.
    Either,
}

/// What is looked at while a shader runs: the last moment of a pixel counts. The first four scalars of
/// it become the last but one of [`Code::outputs`](crate::Code::outputs); the last is whether there was such a moment.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Probe {
    /// A variable where it is read or written.
    Variable {
        /// The variable.
        variable: VariableId,
        /// The text in which it is looked at, such as a line.
        within: Span,
    },
    /// What an operation gives.
    Value(OpId),
}

/// What is watched while a shader runs; each holds what stands before it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Debug)]
pub enum Watch {
    /// The picture alone.
    #[default]
    Nothing,
    /// Turns of loops, which branches are taken, and what pixels cost.
    Flow,
    /// Divisors that are zero, operands that leave a result undefined, and indices outside.
    Faults,
    /// The ends of comparisons.
    Comparisons,
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
