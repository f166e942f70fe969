//! What was seen in a run: facts about the pixels that ran, and of no others.

use shaderlint_ir::{LoopId, OpId, Provenance};
use shaderlint_semantic::FunctionRef;

/// What was seen.
#[derive(Clone, Default, Debug)]
pub struct Seen {
    /// How many pixels ran.
    pub pixels: u64,
    /// Operations of lanes, those of pixels that did not take part not counted.
    pub operations: u64,
    /// By loop of the module that ran.
    pub loops: Vec<LoopSeen>,
    /// By `if` of the module that ran, each source construct once.
    pub branches: Vec<BranchSeen>,
    /// What each function cost that runs, the initial values of globals first.
    pub functions: Vec<FunctionSeen>,
    /// Numbers that went wrong, the first of each operation; by the time at which they did.
    pub numbers: Vec<NumberSeen>,
    /// The operations at which numbers are watched that any pixel came to.
    pub watched: Vec<WatchedSeen>,
    /// The comparisons of two scalars by `<`, `<=`, `>`, `>=`, and by `step` and `smoothstep` of what is
    /// past the first edge, that any pixel came to.
    pub compared: Vec<ComparedSeen>,
}

/// What was seen of a comparison.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ComparedSeen {
    /// The comparison.
    pub op: OpId,
    /// How often it held.
    pub held: u64,
    /// How often it did not.
    pub failed: u64,
    /// The least and the largest number on its left; a NaN is neither.
    pub left: [f64; 2],
    /// On its right.
    pub right: [f64; 2],
}

/// An operation at which numbers are watched.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct WatchedSeen {
    /// The operation.
    pub op: OpId,
    /// What may go wrong there; an operation may be here more than once.
    pub kind: Kind,
    /// How often pixels came to it.
    pub visits: u64,
}

/// What was seen of a loop.
#[derive(Clone, PartialEq, Debug)]
pub struct LoopSeen {
    /// The loop.
    pub id: LoopId,
    /// Pixels that entered it at least once.
    pub pixels: u64,
    /// How often pixels entered it.
    pub entries: u64,
    /// Turns in all.
    pub turns: u64,
    /// The most turns of one entry.
    pub most: u32,
    /// Entries that ended because the condition was false, and by no jump.
    pub exhausted: u64,
    /// Pixels of which at least one entry ended so.
    pub exhausted_pixels: u64,
    /// How many pixels had this many turns at most in one entry, by number of turns; what lies above
    /// the last is counted there.
    pub histogram: Vec<u32>,
}

/// What a function cost, in operations of lanes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct FunctionSeen {
    /// The function; `None` for the initial values of globals.
    pub function: Option<FunctionRef>,
    /// What it did itself.
    pub own: u64,
    /// That, and what the functions did that it called.
    pub whole: u64,
}

/// What was seen of a condition.
#[derive(Clone, PartialEq, Debug)]
pub struct BranchSeen {
    /// The `if` or `?:`.
    pub at: Provenance,
    /// How often pixels came here and it held.
    pub taken: u64,
    /// How often pixels came here and it did not.
    pub skipped: u64,
}

/// What can go wrong with a number.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Kind {
    /// No operand was a NaN, the result is.
    Nan,
    /// No operand was infinite or a NaN, the result is.
    Infinite,
    /// A division by zero, of whatever type.
    DivisionByZero,
    /// An index outside of its array, matrix or vector.
    OutOfRange,
    /// Operands for which the specification leaves the result undefined: `pow` of a negative base,
    /// `log` of what is not positive, a shift by more bits than there are, a derivative that a neighbour
    /// has no part in.
    Undefined,
}

/// A number that went wrong.
#[derive(Clone, PartialEq, Debug)]
pub struct NumberSeen {
    /// What went wrong.
    pub kind: Kind,
    /// The operation that made it.
    pub op: OpId,
    /// How often pixels met it.
    pub times: u64,
    /// The first of them.
    pub witness: Witness,
}

/// The pixel of a finding, and what its operation worked on.
#[derive(Clone, PartialEq, Debug)]
pub struct Witness {
    /// `gl_FragCoord.xy`, less the half.
    pub pixel: [u32; 2],
    /// The operands as numbers.
    pub operands: Vec<f64>,
}
