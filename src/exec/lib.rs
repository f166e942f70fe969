//! Runs shaders without a GPU: the IR is compiled to bytecode, which a SIMD virtual machine
//! executes for 32 pixels at a time, eight quads of 2x2 neighbours, as a GPU does.
//!
//! Results are deterministic and do not depend on the host: arithmetic follows IEEE 754, built-in
//! functions are computed by the same code everywhere, and runs are limited by fuel (counted
//! operations), not by time. Constructs that cannot be run are refused with a reason.

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
