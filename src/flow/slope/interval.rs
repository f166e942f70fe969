//! Intervals of real numbers.

use super::form::{ScalarForm, ScalarFunction, ScalarId};
use std::f64::consts::{FRAC_PI_2, PI};

/// All numbers between two.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct RealSpan {
    pub lo: f64,
    pub hi: f64,
}

impl RealSpan {
    pub const ANY: RealSpan = RealSpan {
        lo: f64::NEG_INFINITY,
        hi: f64::INFINITY,
    };
    pub const ZERO: RealSpan = RealSpan { lo: 0.0, hi: 0.0 };

    pub fn new(lo: f64, hi: f64) -> RealSpan {
        match lo.is_nan() || hi.is_nan() {
            true => RealSpan::ANY,
            false => RealSpan { lo, hi },
        }
    }

    pub fn of(value: f64) -> RealSpan {
        RealSpan::new(value, value)
    }

    /// Within a distance of zero.
    pub fn within(most: f64) -> RealSpan {
        RealSpan::new(-most, most)
    }

    pub fn hull(self, other: RealSpan) -> RealSpan {
        RealSpan::new(self.lo.min(other.lo), self.hi.max(other.hi))
    }

    pub fn meet(self, other: RealSpan) -> RealSpan {
        RealSpan::new(self.lo.max(other.lo), self.hi.min(other.hi))
    }

    pub fn is_empty(self) -> bool {
        self.lo > self.hi
    }

    /// The greatest magnitude.
    pub fn most(self) -> f64 {
        self.lo.abs().max(self.hi.abs())
    }

    pub fn add(self, other: RealSpan) -> RealSpan {
        RealSpan::new(self.lo + other.lo, self.hi + other.hi)
    }

    pub fn scale(self, by: f64) -> RealSpan {
        self.multiply(RealSpan::of(by))
    }

    pub fn multiply(self, other: RealSpan) -> RealSpan {
        // Zero times infinity is the limit of products, which are zero.
        let times = |a: f64, b: f64| if a == 0.0 || b == 0.0 { 0.0 } else { a * b };
        let corners = [
            times(self.lo, other.lo),
            times(self.lo, other.hi),
            times(self.hi, other.lo),
            times(self.hi, other.hi),
        ];
        let lo = corners.iter().fold(f64::INFINITY, |a, b| a.min(*b));
        let hi = corners.iter().fold(f64::NEG_INFINITY, |a, b| a.max(*b));
        RealSpan::new(lo, hi)
    }

    pub fn power(self, power: i32) -> RealSpan {
        if power < 0 {
            let inner = self.power(-power);
            return match inner {
                RealSpan { lo, hi } if lo > 0.0 || hi < 0.0 => RealSpan::new(1.0 / hi, 1.0 / lo),
                RealSpan { lo, hi } if lo >= 0.0 => RealSpan::new(1.0 / hi, f64::INFINITY),
                _ => RealSpan::ANY,
            };
        }
        let (a, b) = (self.lo.powi(power), self.hi.powi(power));
        match power % 2 == 0 {
            true if self.lo <= 0.0 && self.hi >= 0.0 => RealSpan::new(0.0, a.max(b)),
            _ => RealSpan::new(a.min(b), a.max(b)),
        }
    }

    fn rising(self, f: impl Fn(f64) -> f64) -> RealSpan {
        RealSpan::new(f(self.lo), f(self.hi))
    }

    pub fn abs(self) -> RealSpan {
        match self.lo <= 0.0 && self.hi >= 0.0 {
            true => RealSpan::new(0.0, self.most()),
            false => RealSpan::new(self.lo.abs().min(self.hi.abs()), self.most()),
        }
    }

    /// Of a function of one number.
    pub fn of_function(self, function: ScalarFunction) -> RealSpan {
        let unit = RealSpan::new(-1.0, 1.0);
        match function {
            ScalarFunction::Same => self,
            ScalarFunction::Abs => self.abs(),
            ScalarFunction::Sqrt => {
                RealSpan::new(self.lo.max(0.0), self.hi.max(0.0)).rising(f64::sqrt)
            }
            ScalarFunction::Floor => self.rising(f64::floor),
            ScalarFunction::Sin | ScalarFunction::Cos => unit,
            ScalarFunction::Tan => RealSpan::ANY,
            ScalarFunction::Asin => self
                .meet(unit)
                .rising(f64::asin)
                .meet(RealSpan::within(FRAC_PI_2)),
            ScalarFunction::Acos => RealSpan::new(0.0, PI),
            ScalarFunction::Atan => self.rising(f64::atan),
            ScalarFunction::Tanh => self.rising(f64::tanh),
            ScalarFunction::Exp => self.rising(f64::exp),
            ScalarFunction::Log => {
                RealSpan::new(self.lo.max(0.0), self.hi.max(0.0)).rising(f64::ln)
            }
        }
    }
}

/// The range of a node, from those of its operands.
pub(super) fn of_node(node: &ScalarForm, of: impl Fn(ScalarId) -> RealSpan) -> RealSpan {
    match node {
        ScalarForm::Const(value) => RealSpan::of(value.get()),
        ScalarForm::Coordinate(_) | ScalarForm::Fixed(_) | ScalarForm::Unknown(_) => RealSpan::ANY,
        ScalarForm::Sum(terms, constant) => {
            let all = terms.iter().map(|(term, by)| of(*term).scale(by.get()));
            all.fold(RealSpan::of(constant.get()), RealSpan::add)
        }
        ScalarForm::Product(factors) => {
            let all = factors.iter().map(|(id, power)| of(*id).power(*power));
            all.fold(RealSpan::of(1.0), RealSpan::multiply)
        }
        ScalarForm::Of(function, a) => of(*a).of_function(*function),
        ScalarForm::Power(a, b) => match (of(*a), of(*b)) {
            (base, by) if base.lo >= 0.0 && by.lo > 0.0 && by.lo == by.hi => {
                base.rising(|x| x.powf(by.lo))
            }
            _ => RealSpan::new(0.0, f64::INFINITY),
        },
        ScalarForm::ArcTangent(..) => RealSpan::within(PI),
        ScalarForm::Min(a, b) => {
            let (a, b) = (of(*a), of(*b));
            RealSpan::new(a.lo.min(b.lo), a.hi.min(b.hi))
        }
        ScalarForm::Max(a, b) => {
            let (a, b) = (of(*a), of(*b));
            RealSpan::new(a.lo.max(b.lo), a.hi.max(b.hi))
        }
        ScalarForm::Select(_, a, b) => of(*a).hull(of(*b)),
        ScalarForm::IsNegative(_) | ScalarForm::Not(_) | ScalarForm::And(..) => {
            RealSpan::new(0.0, 1.0)
        }
    }
}
