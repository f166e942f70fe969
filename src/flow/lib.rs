//! What a shader does, asked of its middle form: each analysis is a short file, made once when it is
//! asked for and never changed.

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
