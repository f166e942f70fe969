//! Dataflow and control-flow analyses over the IR: call graph, reaching definitions, definite
//! assignment, liveness, value ranges, uniformity, loop bounds and static cost. Each analysis is
//! computed on demand, once, and is immutable afterwards.

mod calls;
pub mod defs;
mod effects;
mod gradients;
mod jumps;
mod live;
mod loops;
mod paths;
pub mod ranges;
mod same;
#[cfg(test)]
mod sample;
mod trace;
mod uniformity;
mod work;
mod writes;

pub use calls::{CallSite, Calls};
pub use effects::Effects;
pub use gradients::{Gradient, Parted, gradients};
pub use jumps::{Jump, jump};
pub use live::Live;
pub use loops::{Bound, LoopFacts, Loops};
pub use paths::{Findings, Parts, Paths, Unset};
pub use same::is_same;
pub use trace::{Start, origin, trace};
pub use uniformity::{Control, ControlId, Parting, PartingId, Turns, Uniformity, Varying};
pub use work::{Nest, Work};
pub use writes::Writes;
