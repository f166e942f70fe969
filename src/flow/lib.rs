//! Dataflow and control-flow analyses over the IR: call graph, reaching definitions, definite
//! assignment, liveness, value ranges, uniformity, loop bounds and static cost. Each analysis is
//! computed on demand, once, and is immutable afterwards.

mod angles;
mod calls;
mod columns;
mod definite_assignment;
mod distance_field;
mod effects;
mod equivalence;
mod gradients;
mod jumps;
mod liveness;
mod loops;
pub mod ranges;
mod rays;
pub mod reaching_definitions;
mod same;
mod slice;
#[cfg(test)]
mod test_shader;
mod trace;
mod uniformity;
mod work;
mod writes;

pub use angles::{AngleUse, angle_uses, period};
pub use calls::{CallSite, Calls};
pub use columns::{ColumnReads, column_reads};
pub use definite_assignment::{
    AssignmentFindings, DefiniteAssignment, PartMask, UnassignedVariable,
};
pub use distance_field::{DistanceField, fields};
pub use effects::Effects;
pub use equivalence::{ImageEntry, ShaderVersion, is_equivalent};
pub use gradients::{DivergenceCause, Gradient, gradients};
pub use jumps::{Jump, jump};
pub use liveness::Liveness;
pub use loops::{Bound, LoopFacts, Loops};
pub use rays::{HitTest, RayKind, RayLoop, RayMotion, RayStep, SceneCall, ray_loops};
pub use same::is_same;
pub use slice::backward_slice;
pub use trace::{Start, origin, trace};
pub use uniformity::{
    Control, ControlId, Divergence, DivergenceId, LoopControls, Uniformity, Varying,
};
pub use work::{CostPart, Nest, Work};
pub use writes::Writes;
