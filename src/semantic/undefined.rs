//! Operations with undefined results (GLSL ES 3.00 sections 5.4.1, 5.9 and 8) as data, used by
//! constant folding and at run time.

/// The operands for which a result is undefined, by component: any of these cases, each with
/// comparisons that must all hold. NaN is in no case.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Undefined(pub &'static [&'static [OperandTest]]);

/// A comparison of an operand.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct OperandTest {
    /// Index of the operand.
    pub operand: usize,
    /// Comparison operator.
    pub relation: Comparing,
    /// Right-hand side of the comparison.
    pub with: ComparedWith,
}

/// Comparison operators.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Comparing {
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `==`
    Equal,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
}

/// Right-hand side of a comparison.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum ComparedWith {
    /// A number that every scalar type can represent.
    Number(i64),
    /// Another operand.
    Operand(usize),
}

use Comparing::{Equal, Greater, GreaterEqual, Less, LessEqual};

/// A comparison of an operand with a number.
const fn is(operand: usize, relation: Comparing, number: i64) -> OperandTest {
    OperandTest {
        operand,
        relation,
        with: ComparedWith::Number(number),
    }
}

/// A comparison of two operands.
const fn are(operand: usize, relation: Comparing, other: usize) -> OperandTest {
    OperandTest {
        operand,
        relation,
        with: ComparedWith::Operand(other),
    }
}

impl Undefined {
    /// Defined for all operands.
    pub const NEVER: Undefined = Undefined(&[]);
    /// `sqrt`
    pub const NEGATIVE: Undefined = Undefined(&[&[is(0, Less, 0)]]);
    /// `log`, `log2`, `inversesqrt`
    pub const NOT_POSITIVE: Undefined = Undefined(&[&[is(0, LessEqual, 0)]]);
    /// `asin`, `acos`
    pub const BEYOND_ONE: Undefined = Undefined(&[&[is(0, Less, -1)], &[is(0, Greater, 1)]]);
    /// `atanh`
    pub const FROM_ONE_ON: Undefined =
        Undefined(&[&[is(0, LessEqual, -1)], &[is(0, GreaterEqual, 1)]]);
    /// `acosh`
    pub const BELOW_ONE: Undefined = Undefined(&[&[is(0, Less, 1)]]);
    /// `atan` of two numbers
    pub const NO_DIRECTION: Undefined = Undefined(&[&[is(0, Equal, 0), is(1, Equal, 0)]]);
    /// `pow`
    pub const NO_POWER: Undefined =
        Undefined(&[&[is(0, Less, 0)], &[is(0, Equal, 0), is(1, LessEqual, 0)]]);
    /// `clamp`
    pub const NOTHING_BETWEEN: Undefined = Undefined(&[&[are(1, Greater, 2)]]);
    /// `smoothstep`
    pub const NO_RISE: Undefined = Undefined(&[&[are(0, GreaterEqual, 1)]]);
    /// `%` of `int`
    pub const NEGATIVE_REMAINDER: Undefined = Undefined(&[&[is(0, Less, 0)], &[is(1, Less, 0)]]);
    /// `<<`, `>>`
    pub const BEYOND_BITS: Undefined = Undefined(&[&[is(1, Less, 0)], &[is(1, GreaterEqual, 32)]]);
    /// `int` of a `float`
    pub const NO_INT: Undefined =
        Undefined(&[&[is(0, Less, -(1 << 31))], &[is(0, GreaterEqual, 1 << 31)]]);
    /// `uint` of a `float`
    pub const NO_UINT: Undefined = Undefined(&[&[is(0, Less, 0)], &[is(0, GreaterEqual, 1 << 32)]]);

    /// Whether the result is undefined for these operands; `None` stands for a missing operand.
    pub fn holds(self, operand: impl Fn(usize) -> Option<f64>) -> bool {
        let is = |test: &OperandTest| {
            let with = match test.with {
                ComparedWith::Number(number) => Some(number as f64),
                ComparedWith::Operand(other) => operand(other),
            };
            operand(test.operand)
                .zip(with)
                .is_some_and(|(a, b)| match test.relation {
                    Less => a < b,
                    LessEqual => a <= b,
                    Equal => a == b,
                    Greater => a > b,
                    GreaterEqual => a >= b,
                })
        };
        self.0.iter().any(|case| case.iter().all(is))
    }

    /// Whether the result may be undefined for operands in these closed ranges.
    pub fn may_hold(self, range: impl Fn(usize) -> Option<(f64, f64)>) -> bool {
        let is = |test: &OperandTest| {
            let with = match test.with {
                ComparedWith::Number(number) => Some((number as f64, number as f64)),
                ComparedWith::Operand(other) => range(other),
            };
            range(test.operand)
                .zip(with)
                .is_none_or(|((lo, hi), (least, most))| match test.relation {
                    Less => lo < most,
                    LessEqual => lo <= most,
                    Equal => lo <= most && least <= hi,
                    Greater => hi > least,
                    GreaterEqual => hi >= least,
                })
        };
        self.0.iter().any(|case| case.iter().all(is))
    }
}
