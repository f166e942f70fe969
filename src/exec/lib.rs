//! Runs shaders without a GPU: the IR is compiled to bytecode, which a SIMD virtual machine
//! executes for 32 pixels at a time, eight quads of 2x2 neighbours, as a GPU does.
//!
//! Results are deterministic and do not depend on the host: arithmetic follows IEEE 754, built-in
//! functions are computed by the same code everywhere, and runs are limited by fuel (counted
//! operations), not by time. Constructs that cannot be run are refused with a reason.

mod bytecode;
mod compile;
mod draw;
mod equal;
mod gpu_profile;
mod image;
mod observations;
mod options;
mod render;
mod replay;
mod row;
mod trace;
mod vm;

pub use bytecode::{
    Bytecode, InputSlot, Location, MAX_TRACED, OutputSlot, SamplerSlot, StopKind, StopSite,
    TraceSite, TracedValue, UniformSlot,
};
pub use compile::statements::statements;
pub use compile::{compile, start};
pub use draw::{Draw, DrawInputs, Stop};
pub use equal::{COMPARED_SIZE, Equality, equality};
pub use image::{Filter, Image, ImageProblem, ImageShape, Sampling, Texels, Texture, Wrap};
pub use observations::{
    BranchObservation, ComparisonObservation, FaultKind, FunctionObservation, LoopObservation,
    NumberObservation, Observations, OperationCost, SiteObservation, StatementObservation, Witness,
};
pub use options::{CompileOptions, ErrorDirection, GpuProfile, Probe, RayProbe, Refusal, Watch};
pub use render::{Drawn, Sampled, draw, quads_all_over, sample, sample_cases};
pub use replay::{Pause, Replay, ReplayCheckpoint, lane_of};
pub use row::{LANES, QUAD};
pub use trace::{PixelTrace, trace};
pub use vm::{Fault, TraceStep};
