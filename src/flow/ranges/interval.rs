//! Intervals of numbers, and interval arithmetic.

use shaderlint_text::number::significant;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// How closely values approach a bound of their range.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Tightness {
    /// An open limit that no value attains, as 0 is of `exp(x)`.
    Open,
    /// A conservative bound, which may not be tight.
    Loose,
    /// Values come arbitrarily close to the bound.
    Touched,
    /// Values attain the bound, over whole areas: `max(x, 0.0)` is 0 for all negative `x`.
    Held,
}

/// A bound of an interval.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct End {
    /// The bound, perhaps infinite.
    pub value: f64,
    /// How closely values approach it.
    pub tightness: Tightness,
}

/// Whether a number is the result of arithmetic that rounds.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Rounding {
    /// Never rounded: integers, halves and the like.
    Never,
    /// Not known.
    Unknown,
    /// Always rounded: its last digits differ from the exact result, and between GPUs.
    Always,
}

impl Rounding {
    /// The rounding of a value that is one of two numbers.
    fn join(self, other: Rounding) -> Rounding {
        if self == other {
            self
        } else {
            Rounding::Unknown
        }
    }
}

/// How far rounding may take a result beyond its exact bound: `cos(PI / 2.0)` is slightly below
/// zero.
const STRAY: f64 = 1e-5;
/// The inner interval is empty: no values are known to be attained.
const NOTHING: [f32; 2] = [f32::INFINITY, f32::NEG_INFINITY];
/// The inner interval around zero: both signs occur, by an unknown amount.
const BOTH_SIGNS: [f32; 2] = [-1e-30, 1e-30];

/// The possible values of a number.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Interval {
    /// The lower bound.
    pub lo: End,
    /// The upper bound.
    pub hi: End,
    /// Inner approximation: some values are known to be at most the first, and some at least the
    /// second, although the bounds are further out. Empty if the first is greater.
    pub inner: [f32; 2],
    /// Whether rounding affects it.
    pub rounding: Rounding,
    /// The unknowns that it depends on, as a bit set (a Bloom filter). Numbers with a common source
    /// are correlated, so bounds computed from both may not be attained.
    pub sources: u64,
    /// Whether it merges the arguments of several calls of a function.
    pub mixed: bool,
}

/// The largest `float` less than `value`.
pub fn below(value: f64) -> f64 {
    if value.is_finite() {
        (value as f32).next_down() as f64
    } else {
        value
    }
}

/// The smallest `float` greater than `value`.
pub fn above(value: f64) -> f64 {
    -below(-value)
}

fn bound(value: f64, tightness: Tightness) -> End {
    let tightness = match value.is_finite() {
        true => tightness,
        false => Tightness::Loose,
    };
    // Zero times infinity: nothing is known.
    let value = if value.is_nan() { 0.0 } else { value };
    End { value, tightness }
}

/// The lesser of two bounds; of equal ones, the tighter.
fn least(a: End, b: End) -> End {
    let is_first = a.value < b.value || (a.value == b.value && a.tightness >= b.tightness);
    if is_first { a } else { b }
}

/// The greater of two bounds; of equal ones, the tighter.
fn greatest(a: End, b: End) -> End {
    let is_first = a.value > b.value || (a.value == b.value && a.tightness >= b.tightness);
    if is_first { a } else { b }
}

impl End {
    fn negated(self) -> End {
        // Avoids -0.0, which would sort below 0.0.
        bound(0.0 - self.value, self.tightness)
    }

    /// Whether values come arbitrarily close to the bound.
    pub fn is_reached(self) -> bool {
        self.tightness >= Tightness::Touched
    }

    /// The tightness of a bound derived from a condition.
    fn compared_tightness(self) -> Tightness {
        self.tightness.clamp(Tightness::Loose, Tightness::Touched)
    }

    fn at_most(self, tightness: Tightness) -> End {
        bound(self.value, self.tightness.min(tightness))
    }
}

impl Interval {
    /// The unbounded interval.
    pub const ANY: Interval = Interval {
        lo: End {
            value: f64::NEG_INFINITY,
            tightness: Tightness::Loose,
        },
        hi: End {
            value: f64::INFINITY,
            tightness: Tightness::Loose,
        },
        inner: NOTHING,
        rounding: Rounding::Unknown,
        sources: 0,
        mixed: false,
    };

    /// The interval of one number.
    pub fn constant(value: f64) -> Interval {
        let scaled = value * 256.0;
        let range = Interval::new(value, value, Tightness::Held);
        match scaled.fract() == 0.0 && scaled.abs() < 4_294_967_296.0 {
            true => range.exactly(),
            false => range,
        }
    }

    /// The interval from `lo` to `hi`, with the same tightness at both bounds.
    pub fn new(lo: f64, hi: f64, tightness: Tightness) -> Interval {
        Interval {
            lo: bound(lo, tightness),
            hi: bound(hi, tightness),
            ..Interval::ANY
        }
    }

    /// The same interval, computed without rounding.
    pub fn exactly(self) -> Interval {
        Interval {
            rounding: Rounding::Never,
            ..self
        }
    }

    /// The same interval, computed with rounding.
    pub fn rounded(self) -> Interval {
        Interval {
            rounding: Rounding::Always,
            ..self
        }
    }

    /// Whether the sum or product of two numbers is rounded.
    pub fn rounding_with(&self, other: &Interval) -> Rounding {
        use Rounding::{Always, Never, Unknown};
        // A constant that `float` cannot represent, such as 0.1, rounds every result.
        let is_rough = |r: &Interval| r.rounding == Unknown && r.single().is_some();
        match (self.rounding, other.rounding) {
            (Never, Never) => Never,
            (Always, _) | (_, Always) => Always,
            _ if is_rough(self) != is_rough(other) => Always,
            _ => Unknown,
        }
    }

    /// The same interval, which also depends on the sources of `of`.
    pub fn like(self, of: &Interval) -> Interval {
        Interval {
            sources: self.sources | of.sources,
            mixed: self.mixed | of.mixed,
            ..self
        }
    }

    /// The same interval with conservative bounds, neither of which may be attained.
    pub fn loose(self) -> Interval {
        Interval {
            lo: self.lo.at_most(Tightness::Loose),
            hi: self.hi.at_most(Tightness::Loose),
            inner: NOTHING,
            ..self
        }
    }

    /// The same interval, with values known to be at most `lo` and at least `hi`.
    pub fn taking(self, lo: f64, hi: f64) -> Interval {
        Interval {
            inner: [lo as f32, hi as f32],
            ..self
        }
    }

    /// The same interval, known to contain negative and positive values.
    pub fn taking_both_signs(self) -> Interval {
        Interval {
            inner: BOTH_SIGNS,
            ..self
        }
    }

    /// The least and the greatest number that values are known to approach.
    fn taken(&self) -> Option<(f64, f64)> {
        let [least, most] = self.inner;
        let of = |end: End, inner: f32| match end.is_reached() {
            true => end.value,
            false => inner as f64,
        };
        let (lo, hi) = (of(self.lo, least), of(self.hi, most));
        (lo <= hi).then_some((lo, hi))
    }

    /// Whether both negative and positive values are known to occur.
    pub fn takes_both_signs(&self) -> bool {
        self.taken().is_some_and(|(lo, hi)| lo < 0.0 && hi > 0.0)
    }

    /// The same interval with bounds at most [`Tightness::Touched`].
    pub fn touched(self) -> Interval {
        Interval {
            lo: self.lo.at_most(Tightness::Touched),
            hi: self.hi.at_most(Tightness::Touched),
            ..self
        }
    }

    /// Whether it is unbounded on both sides.
    pub fn is_any(&self) -> bool {
        self.lo.value.is_infinite() && self.hi.value.is_infinite()
    }

    /// Whether both bounds are finite.
    pub fn is_finite(&self) -> bool {
        self.lo.value.is_finite() && self.hi.value.is_finite()
    }

    /// The only value, if there is just one.
    pub fn single(&self) -> Option<f64> {
        (self.lo.value == self.hi.value).then_some(self.lo.value)
    }

    /// Whether a value is in the interval.
    pub fn contains(&self, value: f64) -> bool {
        self.lo.value <= value && value <= self.hi.value
    }

    /// Whether all values are less than `value`.
    pub fn is_below(&self, value: f64) -> bool {
        self.hi.value < value
    }

    /// Whether all values are greater than `value`.
    pub fn is_above(&self, value: f64) -> bool {
        self.lo.value > value
    }

    /// Whether some values are known to be less than `value`.
    pub fn reaches_below(&self, value: f64) -> bool {
        let is_reached = self.lo.value < value && self.lo.is_reached();
        self.is_below(value) || is_reached || self.is_split_by(value)
    }

    /// Whether some values are known to be greater than `value`.
    pub fn reaches_above(&self, value: f64) -> bool {
        let is_reached = self.hi.value > value && self.hi.is_reached();
        self.is_above(value) || is_reached || self.is_split_by(value)
    }

    /// Whether `value` is strictly within the inner interval. If all known values are on one
    /// side, the bound on the other side is probably not attained.
    fn is_split_by(&self, value: f64) -> bool {
        let [least, most] = self.inner;
        (least as f64) < value && value < most as f64
    }

    /// Whether some values are known to be less than `value` by more than rounding.
    pub fn strays_below(&self, value: f64) -> bool {
        let is_open = self.hi.tightness == Tightness::Open && self.hi.value <= value;
        self.is_split_by(value)
            || is_open && self.lo.value < value
            || self.reaches_below(value - STRAY)
    }

    /// Whether some values are known to be greater than `value` by more than rounding.
    pub fn strays_above(&self, value: f64) -> bool {
        (-*self).strays_below(-value)
    }

    /// Whether `value` is a bound that is attained over whole areas.
    pub fn holds(&self, value: f64) -> bool {
        [self.lo, self.hi].contains(&End {
            value,
            tightness: Tightness::Held,
        })
    }

    /// The union of two intervals (join).
    pub fn join(self, other: Interval) -> Interval {
        Interval {
            lo: least(self.lo, other.lo),
            hi: greatest(self.hi, other.hi),
            inner: [
                self.inner[0].min(other.inner[0]),
                self.inner[1].max(other.inner[1]),
            ],
            rounding: self.rounding.join(other.rounding),
            sources: self.sources | other.sources,
            mixed: self.mixed | other.mixed,
        }
    }

    /// Raises the lower bound to `lo`, as implied by a condition.
    pub fn raise(&mut self, lo: f64) {
        if lo > self.lo.value {
            self.lo = bound(lo, self.lo.compared_tightness());
            self.inner = NOTHING;
        }
    }

    /// Lowers the upper bound to `hi`, as implied by a condition.
    pub fn lower(&mut self, hi: f64) {
        if hi < self.hi.value {
            self.hi = bound(hi, self.hi.compared_tightness());
            self.inner = NOTHING;
        }
    }

    /// Extends the lower bound to `lo`, which may not be attained.
    pub fn down_to(self, lo: f64) -> Interval {
        Interval {
            lo: bound(lo, Tightness::Loose),
            inner: NOTHING,
            ..self
        }
    }

    /// Extends the upper bound to `hi`, which may not be attained.
    pub fn up_to(self, hi: f64) -> Interval {
        Interval {
            hi: bound(hi, Tightness::Loose),
            inner: NOTHING,
            ..self
        }
    }

    /// The intersection with the result of another computation of the same value.
    pub fn within(mut self, other: &Interval) -> Interval {
        if other.lo.value > self.lo.value {
            self.lo = other.lo;
        }
        if other.hi.value < self.hi.value {
            self.hi = other.hi;
        }
        self
    }

    /// Marks both bounds as approached.
    pub fn touch_ends(&mut self) {
        self.lo = bound(self.lo.value, self.lo.tightness.max(Tightness::Touched));
        self.hi = bound(self.hi.value, self.hi.tightness.max(Tightness::Touched));
    }

    /// An interval computed from two others. The bounds are only tight if the operands are
    /// independent.
    fn made_of(a: &Interval, b: &Interval, lo: End, hi: End) -> Interval {
        let range = Interval {
            lo,
            hi,
            inner: NOTHING,
            rounding: a.rounding_with(b),
            sources: a.sources | b.sources,
            mixed: a.mixed | b.mixed,
        };
        if a.is_free_of(b) {
            range
        } else {
            range.loose()
        }
    }

    /// Whether two numbers are independent: they share no source.
    pub fn is_free_of(&self, other: &Interval) -> bool {
        self.sources & other.sources == 0 && !(self.mixed && other.mixed)
    }

    /// Whether the bounds of a result overestimate the values that its operands are known to take.
    fn is_partly_taken(&self, a: &Interval, b: &Interval) -> bool {
        let is_inner = |r: &Interval| r.inner[0] <= r.inner[1];
        (is_inner(a) || is_inner(b)) && a.is_free_of(b)
    }

    /// Derives the inner interval of a product or quotient from a factor or dividend.
    fn scale(&mut self, of: &Interval, by: &Interval) {
        let is_crossing = of.lo.value < 0.0 && of.hi.value > 0.0;
        if !is_crossing && of.inner[0] > of.inner[1] {
            return;
        }
        let is_open = |end: End| end.value == 0.0 && end.tightness == Tightness::Open;
        let is_positive = by.lo.value > 0.0 || is_open(by.lo);
        let is_signed = is_positive || by.hi.value < 0.0 || is_open(by.hi);
        let Some((least, most)) = of.taken().filter(|_| is_signed) else {
            return;
        };
        match by.single() {
            Some(factor) if of.inner[0] <= of.inner[1] => {
                let (a, b) = ((least * factor) as f32, (most * factor) as f32);
                self.inner = [a.min(b), a.max(b)];
            }
            _ if least < 0.0 && most > 0.0 && !self.takes_both_signs() => self.inner = BOTH_SIGNS,
            _ => {}
        }
    }

    /// `a * a`
    pub fn square(self) -> Interval {
        let (a, b) = (self.lo.value * self.lo.value, self.hi.value * self.hi.value);
        let (mut lo, hi) = if a <= b {
            (bound(a, self.lo.tightness), bound(b, self.hi.tightness))
        } else {
            (bound(b, self.hi.tightness), bound(a, self.lo.tightness))
        };
        if self.contains(0.0) && lo.value > 0.0 {
            lo = bound(0.0, self.inner_reach());
        }
        Interval {
            lo,
            hi,
            inner: NOTHING,
            ..self
        }
    }

    /// How closely a value between the bounds is approached: [`Tightness::Touched`] if both bounds
    /// are.
    fn inner_reach(&self) -> Tightness {
        self.lo
            .tightness
            .min(self.hi.tightness)
            .min(Tightness::Touched)
    }

    /// `abs(a)`
    pub fn abs(self) -> Interval {
        if self.lo.value >= 0.0 {
            return self;
        }
        if self.hi.value <= 0.0 {
            return self.neg();
        }
        Interval {
            lo: bound(0.0, self.inner_reach()),
            hi: greatest(self.hi, self.lo.negated()),
            inner: NOTHING,
            ..self
        }
    }

    /// `min(a, b)`
    pub fn min(self, other: Interval) -> Interval {
        self.neg().max(other.neg()).neg()
    }

    /// `max(a, b)`
    pub fn max(self, other: Interval) -> Interval {
        let (low, high) = if self.lo.value <= other.lo.value {
            (self.lo, other.lo)
        } else {
            (other.lo, self.lo)
        };
        // The result attains the higher of the lower bounds where the other operand is below it.
        // Whoever writes `max` expects that to happen.
        let is_below = low.is_reached() || low.value < high.value;
        let tightness = if is_below {
            high.tightness
        } else {
            Tightness::Loose
        };
        let inner = match (self.single(), other.single(), self.inner, other.inner) {
            (_, Some(least), [lo, hi], _) | (Some(least), _, _, [lo, hi]) if lo <= hi => {
                [lo.max(least as f32), hi.max(least as f32)]
            }
            _ => NOTHING,
        };
        Interval {
            lo: bound(high.value, tightness),
            hi: greatest(self.hi, other.hi),
            inner,
            // A constant operand is only visible as the bound of the result.
            rounding: match (self.single(), other.single()) {
                (None, Some(_)) => self.rounding,
                (Some(_), None) => other.rounding,
                _ => self.rounding.join(other.rounding),
            },
            sources: self.sources | other.sources,
            mixed: self.mixed | other.mixed,
        }
    }

    /// The range of a non-decreasing step function, which is constant over whole stretches.
    pub fn stepped(self, f: impl Fn(f64) -> f64) -> Interval {
        let part = (self.hi.value - self.lo.value) * 1e-6;
        // If a bound is approached, so are the values next to it, and a flat step there is attained
        // over an area.
        let at = |end: End, beside: f64| {
            let value = f(end.value);
            let is_flat = end.is_reached() && part > 0.0 && f(beside) == value;
            let tightness = if is_flat {
                Tightness::Held
            } else {
                end.tightness
            };
            bound(value, tightness)
        };
        Interval {
            lo: at(self.lo, self.lo.value + part),
            hi: at(self.hi, self.hi.value - part),
            ..self.rising(&f)
        }
    }

    /// The range of a non-decreasing function.
    pub fn rising(self, f: impl Fn(f64) -> f64) -> Interval {
        let at = |end: End| {
            let value = f(end.value);
            let is_limit = end.value.is_infinite() && value.is_finite();
            let tightness = if is_limit {
                Tightness::Open
            } else {
                end.tightness
            };
            bound(value, tightness)
        };
        let [least, most] = self.inner;
        let inner = match least <= most {
            true => [f(least as f64) as f32, f(most as f64) as f32],
            false => NOTHING,
        };
        Interval {
            lo: at(self.lo),
            hi: at(self.hi),
            inner,
            rounding: match self.single() {
                Some(_) => Rounding::Unknown,
                None => Rounding::Always,
            },
            ..self
        }
    }
}

/// `-a`
impl Neg for Interval {
    type Output = Interval;

    fn neg(self) -> Interval {
        Interval {
            lo: self.hi.negated(),
            hi: self.lo.negated(),
            inner: [-self.inner[1], -self.inner[0]],
            ..self
        }
    }
}

/// `a + b`
impl Add for Interval {
    type Output = Interval;

    fn add(self, other: Interval) -> Interval {
        let sum = |a: End, b: End| bound(a.value + b.value, a.tightness.min(b.tightness));
        let (lo, hi) = (sum(self.lo, other.lo), sum(self.hi, other.hi));
        let mut range = Interval::made_of(&self, &other, lo, hi);
        if range.is_partly_taken(&self, &other)
            && let (Some((a, b)), Some((c, d))) = (self.taken(), other.taken())
        {
            range.inner = [(a + c) as f32, (b + d) as f32];
        }
        range
    }
}

/// `a - b`
impl Sub for Interval {
    type Output = Interval;

    fn sub(self, other: Interval) -> Interval {
        self + -other
    }
}

/// `a * b`
impl Mul for Interval {
    type Output = Interval;

    fn mul(self, other: Interval) -> Interval {
        let (lo, hi) = ends(&self, &other, |a, b| {
            if a == 0.0 || b == 0.0 { 0.0 } else { a * b }
        });
        let mut range = Interval::made_of(&self, &other, lo, hi);
        // If one operand is held at zero, the product is zero, whatever the other is.
        if !(self.mixed && other.mixed) && (self.holds(0.0) || other.holds(0.0)) {
            for end in [&mut range.lo, &mut range.hi] {
                if end.value == 0.0 {
                    end.tightness = Tightness::Held;
                }
            }
        }
        range.scale(&self, &other);
        range.scale(&other, &self);
        range
    }
}

/// `a / b`; unbounded if `b` may have either sign.
impl Div for Interval {
    type Output = Interval;

    fn div(self, other: Interval) -> Interval {
        let crosses = other.lo.value < 0.0 && other.hi.value > 0.0;
        if crosses || other.single() == Some(0.0) {
            return Interval::ANY.like(&self).like(&other);
        }
        let sign = if other.hi.value <= 0.0 { -1.0 } else { 1.0 };
        let (lo, hi) = ends(&self, &other, |a, b| match (a, b) {
            (0.0, _) => 0.0,
            (_, 0.0) => a * sign * f64::INFINITY,
            (a, b) if a.is_infinite() && b.is_infinite() => a * sign,
            (a, b) => a / b,
        });
        let mut range = Interval::made_of(&self, &other, lo, hi);
        // Zero divided by any number is zero.
        if self.is_free_of(&other) && sign > 0.0 && self.lo.value == 0.0 {
            range.lo.tightness = self.lo.tightness;
        }
        // An unbounded divisor takes the quotient arbitrarily close to zero.
        if sign > 0.0 && self.lo.value > 0.0 && other.hi.value.is_infinite() {
            range.lo.tightness = Tightness::Open;
        }
        let inverse = other.single().map(|v| Interval::constant(1.0 / v));
        range.scale(&self, &inverse.unwrap_or(other));
        // Only division by a power of two is exact.
        let divisor = other.single().unwrap_or(3.0).abs();
        let divides = is_power_of_two(divisor) && divisor <= 256.0;
        range.rounding = match (other.single(), range.rounding) {
            (Some(_), _) if divides => self.rounding,
            // The quotients of multiples of the divisor are exact.
            (Some(_), Rounding::Never) => Rounding::Unknown,
            (None, Rounding::Never) => Rounding::Always,
            (_, rounding) => rounding,
        };
        range
    }
}

/// The least and greatest value of a function at the bounds of two intervals.
fn ends(a: &Interval, b: &Interval, f: impl Fn(f64, f64) -> f64) -> (End, End) {
    let at = |a: End, b: End| bound(f(a.value, b.value), a.tightness.min(b.tightness));
    let corners = [
        at(a.lo, b.lo),
        at(a.lo, b.hi),
        at(a.hi, b.lo),
        at(a.hi, b.hi),
    ];
    let first = corners[0];
    let lo = corners.iter().fold(first, |x, &y| least(x, y));
    let hi = corners.iter().fold(first, |x, &y| greatest(x, y));
    (lo, hi)
}

/// Whether a number is 1, 2, 4 and so on.
pub fn is_power_of_two(value: f64) -> bool {
    value >= 1.0 && value <= 2f64.powi(52) && value.fract() == 0.0 && {
        (value as u64).is_power_of_two()
    }
}

/// The form used in messages: `-3.0..=-1.0`, `-1.0 or more`.
impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let (lo, hi) = (self.lo.value, self.hi.value);
        match (lo.is_finite(), hi.is_finite()) {
            _ if lo == hi => number(lo, f),
            (true, true) => {
                number(lo, f)?;
                f.write_str("..=")?;
                number(hi, f)
            }
            (true, false) => {
                number(lo, f)?;
                f.write_str(" or more")
            }
            (false, true) => {
                number(hi, f)?;
                f.write_str(" or less")
            }
            (false, false) if self.inner[0] <= self.inner[1] => {
                if self.inner == BOTH_SIGNS {
                    return f.write_str("negative or positive");
                }
                number(self.inner[0] as f64, f)?;
                f.write_str("..=")?;
                number(self.inner[1] as f64, f)?;
                f.write_str(" and beyond")
            }
            (false, false) => f.write_str("any number"),
        }
    }
}

impl Interval {
    /// The form used in messages for integers: `-3..=-1`, `4 or more`.
    pub fn of_integer(&self) -> String {
        self.to_string().replace(".0", "")
    }

    /// `is` if all values satisfy the predicate, `may be` otherwise.
    pub fn may_or_is(&self, is_all: impl Fn(&Interval) -> bool) -> &'static str {
        if is_all(self) { "is" } else { "may be" }
    }
}

/// Writes a number with four significant digits.
fn number(value: f64, f: &mut fmt::Formatter) -> fmt::Result {
    f.write_str(&significant(value, 4))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arithmetic_on_intervals_bounds_the_result() {
        let unit = Interval::new(-1.0, 1.0, Tightness::Touched);
        let two = Interval::constant(2.0);
        assert_eq!(unit.sub(two).to_string(), "-3.0..=-1.0");
        assert_eq!(unit.mul(two.neg()).to_string(), "-2.0..=2.0");
        assert_eq!(unit.square().to_string(), "0.0..=1.0");
        assert_eq!(two.div(unit).to_string(), "any number");
        assert_eq!(Interval::ANY.max(two).to_string(), "2.0 or more");
        assert_eq!(Interval::constant(0.1 + 0.2).to_string(), "0.3");
        assert_eq!(Interval::constant(12345.678).to_string(), "12350.0");
        assert_eq!(Interval::constant(-5.9604645e-8).to_string(), "-5.96e-8");
    }

    #[test]
    fn bounds_are_reached_only_by_independent_operands() {
        let sine = Interval {
            sources: 1,
            ..Interval::new(-1.0, 1.0, Tightness::Touched)
        };
        let other = Interval { sources: 2, ..sine };
        assert!(sine.add(other).reaches_below(-1.5));
        assert!(!sine.add(sine).reaches_below(-1.5));
        assert!(Interval::ANY.max(Interval::constant(0.0)).holds(0.0));
        assert!(!sine.abs().holds(0.0));
    }
}
