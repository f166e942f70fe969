//! Fields, and what is known of their slopes.

use shaderlint_ir::OpId;
use shaderlint_semantic::{FunctionRef, VariableId};

/// How much steeper than 1 a function may be to count as a distance: what rounding may do.
pub const STEEPEST_DISTANCE: f64 = 1.0001;

/// A function as a field over a point.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct DistanceField {
    /// The function.
    pub function: FunctionRef,
    /// The parameter that is the point.
    pub point: VariableId,
    /// The scalar of the result that is the distance.
    pub scalar: u32,
}

/// A bound of the slope of a field.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Slope {
    /// It is nowhere steeper.
    AtMost(f64),
    /// No bound was found.
    Unknown(Obstacle),
}

/// What prevents a bound.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Obstacle {
    /// The reason.
    pub why: SlopeObstacle,
    /// The operation.
    pub at: Option<OpId>,
}

/// Why no bound was found.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum SlopeObstacle {
    /// There is no body, or no result.
    Body,
    /// A value of which the parts are not known.
    Value,
    /// A loop with an unknown number of iterations.
    Loop,
    /// A jump that cannot be followed.
    Jump,
    /// The function is too large.
    Size,
    /// It may be discontinuous.
    Discontinuity,
    /// The slope of an operation is not bounded.
    Unbounded,
    /// An operation of which nothing is known.
    Operation,
}

impl Slope {
    /// Whether the field is proved not to be steeper than a distance.
    pub fn is_distance(self) -> bool {
        matches!(self, Slope::AtMost(most) if most <= STEEPEST_DISTANCE)
    }
}
