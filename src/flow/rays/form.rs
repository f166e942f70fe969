//! What is known of a ray loop.

use shaderlint_ir::{LoopId, OpId, Provenance};
use shaderlint_semantic::{FunctionRef, VariableId};
use shaderlint_syntax::ast::StmtId;

/// How a ray loop moves its point.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RayKind {
    /// By a multiple of the distance that the scene returns.
    Distance,
    /// From one cell of a grid to the next.
    Grid,
    /// By steps that do not depend on the scene.
    Fixed,
}

/// The condition with which a ray loop ends because the scene was hit.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct HitTest {
    /// The comparison of the distance, or the condition of a grid loop.
    pub condition: OpId,
    /// Its value for a hit.
    pub truth: bool,
    /// The `if` that consists of the condition; `None` for a comparison or a loop condition.
    pub branch: Option<Provenance>,
    /// Whether the first test is of a value from before the loop, not of the scene.
    pub is_late: bool,
}

/// The call of a scene in a ray loop.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SceneCall {
    /// The function.
    pub function: FunctionRef,
    /// The component of its result that the step is computed from, as a lane.
    pub lane: u32,
    /// The index of the parameter that is the point on the ray; `None` if it is passed in another way.
    pub point: Option<u32>,
}

/// A loop that provably moves along a ray.
#[derive(Clone, Debug)]
pub struct RayLoop {
    /// The loop.
    pub looped: LoopId,
    /// Its statement.
    pub stmt: StmtId,
    /// The function that contains it.
    pub function: FunctionRef,
    /// How it moves.
    pub kind: RayKind,
    /// The function that is evaluated at each step; `None` if the distance is computed in the loop.
    pub scene: Option<SceneCall>,
    /// The condition that ends the loop at a hit; `None` if there is none, or several.
    pub hit: Option<HitTest>,
    /// Whether another condition on the ray ends the loop, such as a maximum distance.
    pub ends_far: bool,
    /// Whether the loop sums up something along the ray, such as a glow.
    pub accumulates: bool,
    /// Where rays start, if they do not start at a point that another ray loop found: the components
    /// of the position, in the function that computes them. Empty for rays from the origin.
    pub start: Option<Vec<(OpId, u32)>>,
    /// How it moves, for loops that move by a distance.
    pub motion: RayMotion,
}

/// What a ray loop moves, and by which operations.
#[derive(Clone, Default, Debug)]
pub struct RayMotion {
    /// The ray parameter or point: its variable, and the scalars of it that move.
    pub moved: Option<(VariableId, Vec<u32>)>,
    /// The sums of the ray parameter or point and a step.
    pub steps: Vec<RayStep>,
    /// The point on the ray, if it is not what moves.
    pub point: Option<OpId>,
    /// The distance that the scene returns: a component of a value.
    pub field: Option<(OpId, u32)>,
    /// Whether the test for a hit depends on the number of steps.
    pub is_counted: bool,
}

/// A sum of a ray parameter or point and a step.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct RayStep {
    /// The sum.
    pub sum: OpId,
    /// The step: its right operand, or its left one.
    pub term: OpId,
}
