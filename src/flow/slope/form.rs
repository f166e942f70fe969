//! The values of a function as scalar expressions, as data.

/// Index of a node.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) struct ScalarId(pub u32);

/// A number, comparable by its bits.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) struct ScalarBits(u64);

impl ScalarBits {
    pub const ZERO: ScalarBits = ScalarBits(0);

    pub fn of(value: f64) -> ScalarBits {
        // Both zeros are the same number.
        ScalarBits((value + 0.0).to_bits())
    }

    pub fn get(self) -> f64 {
        f64::from_bits(self.0)
    }
}

/// A function of one number.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum ScalarFunction {
    /// The number itself, as one that other sums do not merge with.
    Same,
    Abs,
    Sqrt,
    Floor,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Tanh,
    Exp,
    Log,
}

/// An expression. Conditions are numbers: 1 if they hold, 0 if not.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(super) enum ScalarForm {
    Const(ScalarBits),
    /// A coordinate of the point.
    Coordinate(u32),
    /// A number that does not depend on the point.
    Fixed(u32),
    /// A number that depends on the point in an unknown way.
    Unknown(u32),
    /// Multiples of other nodes, and a constant.
    Sum(Vec<(ScalarId, ScalarBits)>, ScalarBits),
    /// Powers of other nodes.
    Product(Vec<(ScalarId, i32)>),
    Of(ScalarFunction, ScalarId),
    Power(ScalarId, ScalarId),
    ArcTangent(ScalarId, ScalarId),
    Min(ScalarId, ScalarId),
    Max(ScalarId, ScalarId),
    Select(ScalarId, ScalarId, ScalarId),
    /// Whether a node is less than zero.
    IsNegative(ScalarId),
    Not(ScalarId),
    And(ScalarId, ScalarId),
}

impl ScalarFunction {
    pub fn value(self, x: f64) -> f64 {
        match self {
            ScalarFunction::Same => x,
            ScalarFunction::Abs => x.abs(),
            ScalarFunction::Sqrt => x.sqrt(),
            ScalarFunction::Floor => x.floor(),
            ScalarFunction::Sin => x.sin(),
            ScalarFunction::Cos => x.cos(),
            ScalarFunction::Tan => x.tan(),
            ScalarFunction::Asin => x.asin(),
            ScalarFunction::Acos => x.acos(),
            ScalarFunction::Atan => x.atan(),
            ScalarFunction::Tanh => x.tanh(),
            ScalarFunction::Exp => x.exp(),
            ScalarFunction::Log => x.ln(),
        }
    }
}
