//! Shaders are run here, without a GPU: the middle form becomes register code, which a machine runs
//! for 32 pixels at a time, eight quads of 2x2 neighbours, as a GPU does.
//!
//! A result is the same on every machine: arithmetic is that of IEEE 754, functions are computed the
//! same way everywhere, and what bounds a run is counted in operations, never in time. What cannot be
//! run is refused by name.

mod code;
mod compile;
mod draw;
mod equal;
mod image;
mod inexact;
mod machine;
mod render;
mod row;
mod seen;
#[cfg(test)]
mod tests;

pub use code::{Code, InputSlot, OutputSlot, SamplerSlot, UniformSlot};
pub use compile::compile;
pub use compile::options::{CompileOptions, Lean, Persona, Probe, Refusal, Watch};
pub use draw::{Draw, Stop};
pub use equal::{COMPARED_SIZE, Equality, equality};
pub use image::{Filter, Image, ImageProblem, ImageShape, Sampling, Texels, Texture, Wrap};
pub use render::{Drawn, Sampled, draw, quads_all_over, sample};
pub use row::LANES;
pub use seen::{
    BranchSeen, ComparedSeen, FunctionSeen, Kind, LoopSeen, NumberSeen, Seen, WatchedSeen, Witness,
};
