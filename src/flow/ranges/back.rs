//! Backward transfer functions: narrows the operands of a comparison that is known to be true or
//! false.

use super::interval::{Interval, above, below};
use super::node::{GetRange, Node};
use super::{Query, flipped, negated};
use crate::reaching_definitions::Refinement;
use crate::same::is_same;
use shaderlint_ir::{Binary, OpId, OpKind, Unary, length_lane};
use shaderlint_semantic::builtins::Transfer;
use shaderlint_semantic::{BuiltinId, Scalar};

/// The values that a condition permits.
#[derive(Clone, Copy, Debug)]
pub(super) struct RequiredRange {
    lo: f64,
    hi: f64,
    /// An excluded closed interval of values.
    not: Option<(f64, f64)>,
}

impl RequiredRange {
    const ANY: RequiredRange = RequiredRange {
        lo: f64::NEG_INFINITY,
        hi: f64::INFINITY,
        not: None,
    };

    fn between(lo: f64, hi: f64) -> RequiredRange {
        let or = |value: f64, other| if value.is_nan() { other } else { value };
        RequiredRange {
            lo: or(lo, f64::NEG_INFINITY),
            hi: or(hi, f64::INFINITY),
            not: None,
        }
    }

    /// The values that a comparison permits for one of its sides.
    pub(super) fn of(
        query: &Query,
        comparison: OpId,
        truth: bool,
        (is_right, lane): (bool, u32),
        mut get: impl GetRange,
    ) -> RequiredRange {
        let (op, left, right) = match query.module.op(comparison).kind {
            OpKind::Binary(op, left, right) => (Some(op), left, right),
            OpKind::Same {
                negated,
                left,
                right,
            } => (negated.then_some(Binary::Xor), left, right),
            _ => return RequiredRange::ANY,
        };
        let other = if is_right { left } else { right };
        let Some(with) = Node::lane(query.defs, other, lane).and_then(&mut get) else {
            return RequiredRange::ANY;
        };
        if let OpKind::Same { negated, .. } = query.module.op(comparison).kind {
            return match negated != truth {
                true => RequiredRange::between(with.lo.value, with.hi.value),
                false => RequiredRange {
                    not: with.single().map(|v| (v, v)),
                    ..RequiredRange::ANY
                },
            };
        }
        let Some(op) = op else {
            return RequiredRange::ANY;
        };
        let op = if truth { op } else { negated(op) };
        let op = if is_right { flipped(op) } else { op };
        let is_float = query.is_float(left);
        let less = |v: f64| if is_float { below(v) } else { v - 1.0 };
        let more = |v: f64| if is_float { above(v) } else { v + 1.0 };
        let (lo, hi) = (with.lo.value, with.hi.value);
        match op {
            Binary::Less => RequiredRange::between(f64::NEG_INFINITY, less(hi)),
            Binary::LessEqual => RequiredRange::between(f64::NEG_INFINITY, hi),
            Binary::Greater => RequiredRange::between(more(lo), f64::INFINITY),
            Binary::GreaterEqual => RequiredRange::between(lo, f64::INFINITY),
            _ => RequiredRange::ANY,
        }
    }

    /// The values that a refinement permits for the load that it constrains.
    pub(super) fn at_end(query: &Query, by: Refinement, get: &mut impl GetRange) -> RequiredRange {
        let side = (by.is_right, by.lane as u32);
        let mut required = RequiredRange::of(query, by.comparison, by.truth, side, &mut *get);
        for hop in by.way(query.module, query.defs) {
            if let Some(choice) = hop.choice {
                required = required.through(query, hop.op, hop.lane, choice, get);
            }
        }
        required
    }

    /// The values permitted for an operand, given those permitted for a component of the operation.
    fn through(
        self,
        query: &Query,
        op: OpId,
        lane: u32,
        choice: u8,
        get: &mut impl GetRange,
    ) -> RequiredRange {
        let module = query.module;
        match module.op(op).kind {
            OpKind::Unary(Unary::Negate, _) if length_lane(module.ty(op)) != Some(lane) => {
                RequiredRange {
                    not: self.not.map(|(lo, hi)| (0.0 - hi, 0.0 - lo)),
                    ..RequiredRange::between(-self.hi, -self.lo)
                }
            }
            OpKind::Convert(a) => self.converted(query, op, a),
            OpKind::Binary(kind, a, b) => {
                let other = if choice == 0 { b } else { a };
                let other = Node::lane(query.defs, other, lane).and_then(&mut *get);
                let other = other.unwrap_or(Interval::ANY);
                if kind == Binary::Multiply && is_same(module, query.defs, a, b) {
                    return self.sqrt().magnitude();
                }
                let required = self.operand(kind, choice, other);
                match query.is_integer(op) && matches!(kind, Binary::Divide | Binary::Multiply) {
                    true => RequiredRange::ANY,
                    false => required,
                }
            }
            OpKind::Builtin(function, list) => {
                let args = module.operands(list);
                let other = args.get(1 - choice.min(1) as usize).and_then(|other| {
                    let scalar = module.ty(*other).is_scalar();
                    Node::lane(query.defs, *other, if scalar { 0 } else { lane })
                });
                let other = other.and_then(get).unwrap_or(Interval::ANY);
                let is_scalar = args.first().is_some_and(|a| module.ty(*a).is_scalar());
                self.argument(function, is_scalar, other)
            }
            _ => self,
        }
    }

    fn converted(self, query: &Query, op: OpId, a: OpId) -> RequiredRange {
        let to = query.module.ty(op).scalar_kind();
        let from = query.module.ty(a).scalar_kind();
        match (from, to) {
            (_, Some(Scalar::Bool)) | (Some(Scalar::Bool), _) => RequiredRange::ANY,
            // Conversion truncates towards zero.
            (Some(Scalar::Float), Some(_)) => {
                let lo = if self.lo > 0.0 {
                    self.lo
                } else {
                    self.lo - 1.0
                };
                let hi = if self.hi < 0.0 {
                    self.hi
                } else {
                    self.hi + 1.0
                };
                RequiredRange::between(lo, hi)
            }
            (Some(Scalar::Uint), Some(Scalar::Int)) | (Some(Scalar::Int), Some(Scalar::Uint)) => {
                RequiredRange::ANY
            }
            _ => self,
        }
    }

    /// The values permitted for one operand, given the range of the other.
    fn operand(self, kind: Binary, choice: u8, other: Interval) -> RequiredRange {
        let (lo, hi) = (other.lo.value, other.hi.value);
        match (kind, choice) {
            (Binary::Add, _) => RequiredRange::between(self.lo - hi, self.hi - lo),
            (Binary::Subtract, 0) => RequiredRange::between(self.lo + lo, self.hi + hi),
            (Binary::Subtract, _) => RequiredRange::between(lo - self.hi, hi - self.lo),
            (Binary::Multiply, _) if other.lo.value < 0.0 && other.hi.value > 0.0 => {
                RequiredRange {
                    not: self.is_nonzero().then_some((0.0, 0.0)),
                    ..RequiredRange::ANY
                }
            }
            (Binary::Multiply, _) => self.factor(other),
            (Binary::Divide, 0) if lo >= 0.0 && self.lo > 0.0 => {
                RequiredRange::between(above(0.0), f64::INFINITY)
            }
            // The quotient times the divisor.
            (Binary::Divide, 0) if lo > 0.0 => RequiredRange::between(
                if self.lo < 0.0 {
                    self.lo * hi
                } else {
                    self.lo * lo
                },
                if self.hi < 0.0 {
                    self.hi * lo
                } else {
                    self.hi * hi
                },
            ),
            (Binary::Divide, 0) if hi < 0.0 => {
                let flipped = RequiredRange::between(-self.hi, -self.lo);
                flipped.operand(Binary::Divide, 0, -other)
            }
            _ => RequiredRange::ANY,
        }
    }

    /// The values permitted for a factor, given the range of the other.
    fn factor(self, other: Interval) -> RequiredRange {
        let (lo, hi) = (other.lo.value, other.hi.value);
        if hi < 0.0 {
            return RequiredRange::between(-self.hi, -self.lo).factor(-other);
        }
        if lo <= 0.0 {
            return match self.lo > 0.0 {
                true => RequiredRange::between(above(0.0), f64::INFINITY),
                false => RequiredRange {
                    not: self.is_nonzero().then_some((0.0, 0.0)),
                    ..RequiredRange::ANY
                },
            };
        }
        RequiredRange::between(
            if self.lo < 0.0 {
                self.lo / lo
            } else {
                self.lo / hi
            },
            if self.hi < 0.0 {
                self.hi / hi
            } else {
                self.hi / lo
            },
        )
    }

    /// The values permitted for an argument of a built-in function, given the range of another
    /// argument.
    fn argument(self, function: BuiltinId, is_scalar: bool, other: Interval) -> RequiredRange {
        match function.transfer() {
            Transfer::Magnitude => self.magnitude(),
            // The length of a scalar is its absolute value.
            Transfer::Norm if is_scalar => self.magnitude(),
            Transfer::Product if is_scalar => self.sqrt().magnitude(),
            Transfer::Norm => RequiredRange {
                not: self.not,
                ..RequiredRange::between(self.lo.max(0.0), self.hi)
            },
            // The dot product of a vector with itself is its squared length.
            Transfer::Product => self.sqrt(),
            Transfer::Minimum if other.lo.value > self.hi => {
                RequiredRange::between(self.lo, self.hi)
            }
            Transfer::Minimum => RequiredRange::between(self.lo, f64::INFINITY),
            Transfer::Maximum if other.hi.value < self.lo => {
                RequiredRange::between(self.lo, self.hi)
            }
            Transfer::Maximum => RequiredRange::between(f64::NEG_INFINITY, self.hi),
            Transfer::Rounded(_) => RequiredRange::between(self.lo - 1.0, self.hi + 1.0),
            _ if function == BuiltinId::Sqrt => {
                let lo = if self.lo > 0.0 {
                    self.lo * self.lo
                } else {
                    f64::NEG_INFINITY
                };
                RequiredRange::between(lo, self.hi.max(0.0) * self.hi.max(0.0))
            }
            _ => RequiredRange::ANY,
        }
    }

    /// The values permitted for `abs(x)`, given those permitted for `x * x`.
    fn sqrt(self) -> RequiredRange {
        RequiredRange {
            not: self.not.filter(|_| self.is_nonzero()).map(|_| (0.0, 0.0)),
            ..RequiredRange::between(self.lo.max(0.0).sqrt(), self.hi.max(0.0).sqrt())
        }
    }

    /// The values permitted for `x`, given those permitted for `abs(x)`.
    pub(super) fn magnitude(self) -> RequiredRange {
        let hole = match self.lo > 0.0 {
            true => Some((-below(self.lo), below(self.lo))),
            false => self.not.filter(|_| self.is_nonzero()).map(|_| (0.0, 0.0)),
        };
        RequiredRange {
            not: hole,
            ..RequiredRange::between(-self.hi, self.hi)
        }
    }

    /// Whether zero is excluded.
    fn is_nonzero(self) -> bool {
        let is_out = self.not.is_some_and(|(lo, hi)| lo <= 0.0 && hi >= 0.0);
        self.lo > 0.0 || self.hi < 0.0 || is_out
    }

    /// Intersects a range with the permitted values.
    pub(super) fn narrow(self, range: &mut Interval, is_float: bool) {
        let (lo, hi) = match is_float {
            true => (self.lo, self.hi),
            false => (self.lo.ceil(), self.hi.floor()),
        };
        range.raise(lo);
        range.lower(hi);
        if let Some((lo, hi)) = self.not {
            if (lo..=hi).contains(&range.lo.value) {
                range.raise(if is_float {
                    above(hi)
                } else {
                    hi.floor() + 1.0
                });
            }
            if (lo..=hi).contains(&range.hi.value) {
                range.lower(if is_float { below(lo) } else { lo.ceil() - 1.0 });
            }
        }
    }
}
