//! Statistics of a run: facts about the pixels that were executed, not about others.

use shaderlint_ir::{LoopId, OpId, Provenance};
use shaderlint_semantic::FunctionRef;

/// The statistics of a run.
#[derive(Clone, Default, Debug)]
pub struct Observations {
    /// The number of pixels executed.
    pub pixels: u64,
    /// Operations summed over pixels, without inactive lanes.
    pub operations: u64,
    /// One entry per loop that was executed.
    pub loops: Vec<LoopObservation>,
    /// One entry per `if` or `?:` that was executed.
    pub branches: Vec<BranchObservation>,
    /// By statement of [`Bytecode::statements`](crate::Bytecode::statements): how often it ran.
    pub statements: Vec<StatementObservation>,
    /// The cost of each function that was executed; global initialisers come first.
    pub functions: Vec<FunctionObservation>,
    /// By charge of the bytecode: its operations, summed over pixels.
    pub(super) charged: Vec<u64>,
    /// Numeric faults, the first occurrence per operation, in order of occurrence.
    pub numbers: Vec<NumberObservation>,
    /// The checked operations that at least one pixel executed.
    pub watched: Vec<SiteObservation>,
    /// The scalar comparisons (`<`, `<=`, `>`, `>=`, `step` and the lower edge of `smoothstep`)
    /// that at least one pixel executed.
    pub compared: Vec<ComparisonObservation>,
}

/// The statistics of a comparison.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ComparisonObservation {
    /// The comparison, or the call of `step` or `smoothstep`.
    pub op: OpId,
    /// How often it was true.
    pub held: u64,
    /// How often it was false.
    pub failed: u64,
    /// Minimum and maximum of the left operand, NaN excluded.
    pub left: [f64; 2],
    /// Minimum and maximum of the right operand.
    pub right: [f64; 2],
}

/// A checked operation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SiteObservation {
    /// The operation.
    pub op: OpId,
    /// The fault that is checked for; an operation may have several entries.
    pub kind: FaultKind,
    /// How often pixels executed it.
    pub visits: u64,
}

/// The statistics of a loop.
#[derive(Clone, PartialEq, Debug)]
pub struct LoopObservation {
    /// The loop.
    pub id: LoopId,
    /// The number of pixels that entered it at least once.
    pub pixels: u64,
    /// How often it was entered, summed over pixels.
    pub entries: u64,
    /// The number of iterations, summed over pixels.
    pub iterations: u64,
    /// Maximum number of iterations of one entry.
    pub most: u32,
    /// The number of entries that ended because the condition was false, not by a jump.
    pub exhausted: u64,
    /// The number of pixels with at least one such entry.
    pub exhausted_pixels: u64,
    /// The number of pixels by their maximum iterations per entry; the last bucket also counts all
    /// above.
    pub histogram: Vec<u32>,
}

/// The cost of a function, in operations summed over pixels.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct FunctionObservation {
    /// The function; `None` for global initialisers.
    pub function: Option<FunctionRef>,
    /// Operations of its own code.
    pub own: u64,
    /// Operations including the functions that it calls.
    pub inclusive: u64,
}

/// What an operation cost, for one path of calls.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct OperationCost {
    /// The operation.
    pub at: Provenance,
    /// The calls that lead to it, innermost first.
    pub calls: Vec<OpId>,
    /// The cost, summed over pixels.
    pub operations: u64,
}

/// The statistics of a condition.
#[derive(Clone, PartialEq, Debug)]
pub struct BranchObservation {
    /// The `if` or `?:`.
    pub at: Provenance,
    /// How often it was true, summed over pixels.
    pub taken: u64,
    /// How often it was false, summed over pixels.
    pub skipped: u64,
}

/// How often a statement ran, or the condition or step of a construct.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct StatementObservation {
    /// How often, summed over pixels.
    pub times: u64,
    /// The number of pixels that ran it.
    pub pixels: u64,
}

/// The kinds of numeric faults.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum FaultKind {
    /// The result is NaN, although no operand is.
    Nan,
    /// The result is infinite, although no operand is infinite or NaN.
    Infinite,
    /// A division by zero, of any type.
    DivisionByZero,
    /// An index outside an array, matrix or vector.
    OutOfRange,
    /// Operands for which the specification leaves the result undefined: `pow` of a negative base,
    /// `log` of a non-positive number, a shift by the bit width or more, a derivative with inactive
    /// neighbours.
    Undefined,
}

/// A numeric fault.
#[derive(Clone, PartialEq, Debug)]
pub struct NumberObservation {
    /// The kind of fault.
    pub kind: FaultKind,
    /// The operation that caused it.
    pub op: OpId,
    /// How often it occurred, summed over pixels.
    pub times: u64,
    /// The first occurrence.
    pub witness: Witness,
}

/// The pixel of an occurrence, with the operands.
#[derive(Clone, PartialEq, Debug)]
pub struct Witness {
    /// `gl_FragCoord.xy` minus 0.5.
    pub pixel: [u32; 2],
    /// The operands, converted to numbers.
    pub operands: Vec<f64>,
}
