//! What a shader does, asked of its middle form: each analysis is a short file, made once when it is
//! asked for and never changed.

pub mod defs;
mod gradients;
mod layout;
mod loops;
pub mod ranges;
mod same;
#[cfg(test)]
mod sample;
mod uniformity;

pub use gradients::{Gradient, Parted, gradients};
pub use loops::{Bound, Loop, Loops};
pub use same::is_same;
pub use uniformity::{Control, ControlId, Parting, PartingId, Turns, Uniformity, Varying};
