//! Ray marching loops: what they are for, what their rays hit, and steps that suit them better.

mod hit;
mod limit;
mod longer_steps;
mod loops;
mod step_edit;
mod stepped_over;

pub use hit::{Hit, MarchOutcome, RayCounts};
pub use limit::limit_edit;
pub use longer_steps::{
    LongerSteps, MarchSample, are_clearly_fewer, factor_length, largest_factor, longer_factors,
};
pub use loops::{March, MarchGoal, marches, way};
pub use step_edit::{factor_edits, step_edits, step_factor};
pub use stepped_over::{RayOutcome, StepLength, SteppedOver, ray_probe, slope_probe};
