//! What a shader does, asked of its middle form: each analysis is a short file, made once when it is
//! asked for and never changed.

mod gradients;
mod uniformity;

pub use gradients::{Gradient, Parted, gradients};
pub use uniformity::{Control, ControlId, Parting, PartingId, Turns, Uniformity, Varying};
