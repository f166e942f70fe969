//! What a shader does, asked of its middle form: each analysis is a short file, made once when it is
//! asked for and never changed.

pub mod defs;
mod gradients;
mod layout;
pub mod ranges;
mod same;
mod uniformity;

pub use gradients::{Gradient, Parted, gradients};
pub use same::is_same;
pub use uniformity::{Control, ControlId, Parting, PartingId, Turns, Uniformity, Varying};
