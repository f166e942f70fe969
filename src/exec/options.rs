//! Compilation options, and the reason for a refusal.

use shaderlint_ir::{LoopId, OpId, Provenance};
use shaderlint_semantic::{FunctionRef, VariableId};
use shaderlint_text::Span;

/// Compilation options.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct CompileOptions {
    /// The statistics recorded at run time.
    pub watch: Watch,
    /// Whether the cost of pixels and functions is recorded, too.
    pub cost: bool,
    /// The entry point; `None` for that of the shader.
    pub entry: Option<FunctionRef>,
    /// A value that is output in addition to the outputs of the shader.
    pub probe: Option<Probe>,
    /// A loop whose first march is output in addition to the outputs of the shader.
    pub rays: Option<RayProbe>,
    /// Whether [`trace`](crate::trace) can record what a pixel writes.
    pub trace: bool,
    /// Whether a debugger can stop the code before each statement, and read all variables in scope;
    /// also counts how often each statement runs.
    pub steps: bool,
    /// The bits of uninitialised variables; browsers initialise them to zero.
    pub undefined: u32,
    /// The only [`OpKind::Undef`](shaderlint_ir::OpKind::Undef) with these bits, while all others are zero;
    /// `None` for all.
    pub undefined_at: Option<OpId>,
    /// The emulated GPU profile.
    pub gpu_profile: GpuProfile,
    /// Maximum number of instructions, if less than 400,000.
    pub most: Option<usize>,
}

/// A GPU profile, as inexact as the conformance tests permit (VK-GL-CTS, glsBuiltinPrecisionTests).
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum GpuProfile {
    /// Correctly computed results, without additional error.
    #[default]
    Exact,
    /// The maximum permitted error.
    Inexact(ErrorDirection),
    /// Exact, but `mediump` and `lowp` are 16-bit floats.
    Mobile,
}

/// The direction of the error.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum ErrorDirection {
    /// Away from zero; upwards for sines.
    Out,
    /// Towards zero; downwards for sines.
    In,
    /// Either direction, by a hash of the result.
    Either,
}

/// A value to observe. The last time that a pixel executes it counts. Two outputs are appended to
/// [`Bytecode::outputs`](crate::Bytecode::outputs): the first four scalars of the value, and whether it was
/// executed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Probe {
    /// A variable, where it is read or written.
    Variable {
        /// The variable.
        variable: VariableId,
        /// The source range to observe, such as a line.
        within: Span,
    },
    /// The result of an operation.
    Value(OpId),
    /// Four scalars of a result, from an index on: a part of a matrix or an array.
    Part(OpId, u32),
}

/// A loop that marches along a ray, to observe in each pixel when it runs for the first time. Three outputs
/// of four numbers are appended to [`Bytecode::outputs`](crate::Bytecode::outputs); distances from the
/// start of the ray are sums over the scalars that move.
///
/// 1. whether the loop was reached, the largest slope between two evaluations of the distance, and the
///    largest change of the distance between them, relative to the first
/// 2. whether the last test was a hit, the distance from the start at that test, and at the last place that
///    was tested without a hit
/// 3. the point at the last test, and whether it is known
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct RayProbe {
    /// The loop.
    pub looped: LoopId,
    /// The variable that moves.
    pub moved: VariableId,
    /// The scalars of it that move, at most four.
    pub scalars: [Option<u32>; 4],
    /// The sums that move it, with their terms.
    pub steps: [Option<(OpId, OpId)>; RayProbe::STEPS],
    /// The condition that tests for a hit, if it is known.
    pub condition: Option<OpId>,
    /// The value of the condition for a hit.
    pub truth: bool,
    /// Whether the condition tests what the previous iteration has left.
    pub is_late: bool,
    /// The point on the ray, if it is not what moves.
    pub point: Option<OpId>,
    /// The distance that the scene returns: a scalar of a value.
    pub field: Option<(OpId, u32)>,
    /// The length of a step, in thousandths of that of the shader.
    pub thousandths: u32,
    /// The constant that limits the number of iterations, and what it is multiplied by.
    pub limit: Option<(OpId, u32)>,
}

impl RayProbe {
    /// Number of outputs that are appended.
    pub const OUTPUTS: usize = 3;
    /// Largest number of sums.
    pub const STEPS: usize = 6;

    /// The scalars that move.
    pub(super) fn lanes(&self) -> impl Iterator<Item = u32> {
        self.scalars.into_iter().flatten()
    }
}

/// The statistics recorded at run time. Each level includes the previous ones.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Debug)]
pub enum Watch {
    /// Only the image.
    #[default]
    Nothing,
    /// Loop iterations.
    Flow,
    /// Branches taken, zero divisors, operands with undefined results, and indices out of range.
    Faults,
    /// The ranges of comparison operands.
    Comparisons,
    /// All numeric faults: NaN and infinity, too.
    Numbers,
}

/// Why a shader cannot be run.
#[derive(Clone, PartialEq, Debug)]
pub struct Refusal {
    /// The unsupported construct, as it appears in messages.
    pub what: String,
    /// Its location in the source.
    pub at: Provenance,
}
