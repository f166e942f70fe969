//! Transfer functions of built-in functions, and ranges of variables provided by the host.

use super::interval::{Interval, Rounding, Tightness, below, is_power_of_two};
use shaderlint_semantic::builtins::Transfer;
use std::f64::consts::{PI, TAU};

/// The range of a component of a built-in function's result, given the ranges of that component in
/// the arguments. Unbounded for functions that mix components.
pub fn of_function(transfer: Transfer, args: &[Interval]) -> Interval {
    let mut range = transferred(transfer, args).unwrap_or(Interval::ANY);
    if rounds(transfer) && args.iter().any(|arg| arg.single().is_none()) {
        range.rounding = Rounding::Always;
    }
    args.iter().fold(range, |range, arg| range.like(arg))
}

/// Whether a function always rounds.
const fn rounds(transfer: Transfer) -> bool {
    use Transfer as T;
    matches!(
        transfer,
        T::Rising(_)
            | T::RisingOn(..)
            | T::FallingOn(..)
            | T::Logarithm(_)
            | T::NonNegative
            | T::Sine
            | T::Cosine
            | T::ArcTangent
            | T::Power
            | T::Ramp
    )
}

fn transferred(transfer: Transfer, args: &[Interval]) -> Option<Interval> {
    use Transfer as T;
    let x = *args.first()?;
    let y = || args.get(1).copied();
    let z = || args.get(2).copied();
    Some(match transfer {
        T::Rising(f) => x.rising(f),
        T::RisingOn(from, to, f) => inside(x, from, to).rising(f),
        T::FallingOn(from, to, f) => (-inside(x, from, to)).rising(|v| f(-v)),
        T::Rounded(f) => x.stepped(f).exactly(),
        T::Logarithm(f) if x.lo.value > 0.0 => x.rising(f),
        T::NonNegative => Interval::new(0.0, f64::INFINITY, Tightness::Loose),
        T::Sine => wave(x, 0.5 * PI),
        T::Cosine => wave(x, 0.0),
        T::ArcTangent if args.len() == 2 => angle(x, y()?),
        T::ArcTangent => x.rising(f64::atan),
        T::Power => power(x, y()?)?,
        T::Magnitude => x.abs(),
        T::Signum => x
            .rising(|v| if v == 0.0 { 0.0 } else { v.signum() })
            .exactly(),
        T::Fraction => modulo(x, Interval::constant(1.0))?,
        T::Modulo => modulo(x, y()?)?,
        T::Minimum => x.min(y()?),
        T::Maximum => x.max(y()?),
        T::Between => x.max(y()?).min(z()?),
        T::Blend => blend(x, y()?, z()?)?,
        T::Threshold => Interval::new(0.0, 1.0, Tightness::Held).exactly(),
        T::Ramp => {
            let is_finite = z()?.is_finite();
            let tightness = if is_finite {
                Tightness::Touched
            } else {
                Tightness::Held
            };
            Interval::new(0.0, 1.0, tightness)
        }
        T::Logarithm(_)
        | T::Unknown
        | T::Norm
        | T::Separation
        | T::Product
        | T::Direction
        | T::Reflection
        | T::Texel
        | T::Mixed
        | T::MixedMagnitude => return None,
    })
}

/// `atan(y, x)`: the quadrants that the signs of the arguments permit.
fn angle(y: Interval, x: Interval) -> Interval {
    let mut range = Interval::new(-PI, PI, Tightness::Touched);
    if x.lo.value >= 0.0 {
        range = Interval::new(-0.5 * PI, 0.5 * PI, Tightness::Touched);
    }
    let has_ends = y.is_any() || y.takes_both_signs();
    if y.lo.value >= 0.0 {
        range.raise(0.0);
    } else if y.hi.value <= 0.0 {
        range.lower(0.0);
    } else if !has_ends || !(x.is_any() || x.takes_both_signs() || x.lo.value >= 0.0) {
        range = range.loose();
    }
    range
}

fn modulo(x: Interval, y: Interval) -> Option<Interval> {
    let divisor = y.single().filter(|d| *d > 0.0)?;
    if x.lo.value >= 0.0 && x.hi.value < divisor {
        return Some(x);
    }
    let tightness = if x.is_finite() && !x.lo.is_reached() {
        Tightness::Loose
    } else {
        Tightness::Touched
    };
    let mut range = Interval::new(0.0, below(divisor), tightness);
    // Integers counted from zero hit multiples of the divisor repeatedly.
    if x.holds(0.0) && x.rounding == Rounding::Never {
        range.lo.tightness = Tightness::Held;
    }
    // `mod` of halves and the like by an integer is exact, except at multiples of the divisor,
    // where some GPUs return the divisor instead of zero.
    let is_exact = Interval::constant(divisor).rounding == Rounding::Never;
    range.rounding = match (is_power_of_two(divisor), x.rounding) {
        (true, rounding) => rounding,
        (false, Rounding::Never) if is_exact => Rounding::Never,
        _ => Rounding::Always,
    };
    Some(range)
}

fn power(x: Interval, y: Interval) -> Option<Interval> {
    let exponent = y.single()?;
    let base = inside(x, 0.0, f64::INFINITY);
    if x.lo.value < 0.0 {
        return None;
    }
    Some(if exponent >= 0.0 {
        base.rising(|v| v.powf(exponent))
    } else {
        (-base).rising(|v| (0.0 - v).powf(exponent))
    })
}

/// `mix` with a weight in 0..1.
fn blend(x: Interval, y: Interval, share: Interval) -> Option<Interval> {
    if share.lo.value < 0.0 || share.hi.value > 1.0 {
        return None;
    }
    let range = x.join(y);
    let is_reached = share.lo.is_reached() && share.hi.is_reached();
    let is_free = (x.sources & share.sources) | (y.sources & share.sources) == 0;
    let mut range = if is_reached && is_free {
        range.touched()
    } else {
        range.loose()
    };
    if share.rounding != Rounding::Never {
        range.rounding = share.rounding;
    }
    Some(range)
}

/// The part of a range in the domain of a function.
fn inside(x: Interval, lo: f64, hi: f64) -> Interval {
    let mut part = x;
    part.raise(lo);
    part.lower(hi);
    part
}

/// A sine wave with a crest at `crest`.
fn wave(x: Interval, crest: f64) -> Interval {
    let full = Interval::new(-1.0, 1.0, Tightness::Touched);
    if !x.is_finite() {
        return full;
    }
    let (lo, hi) = (x.lo.value, x.hi.value);
    let is_reached = x.lo.is_reached() && x.hi.is_reached();
    let passes = |at: f64| ((lo - at) / TAU).ceil() * TAU + at <= hi;
    let (a, b) = ((lo - crest).cos(), (hi - crest).cos());
    let low = if passes(crest + PI) { -1.0 } else { a.min(b) };
    let high = if passes(crest) { 1.0 } else { a.max(b) };
    let range = Interval::new(low, high, Tightness::Touched);
    if is_reached { range } else { range.loose() }
}

/// The range of a component of a variable set by ShaderToy's player or the language; `None` for
/// other names.
pub fn of_host(name: &str, component: u8) -> Option<Interval> {
    let from = |lo, tightness| Interval::new(lo, f64::INFINITY, tightness);
    Some(match (name, component) {
        ("iTime" | "iTimeDelta", _) => from(0.0, Tightness::Touched),
        ("iFrame" | "gl_VertexID" | "gl_InstanceID", _) => from(0.0, Tightness::Held).exactly(),
        ("iResolution", _) => from(1.0, Tightness::Loose).exactly(),
        ("iChannelResolution", _) => from(0.0, Tightness::Loose).exactly(),
        ("iChannelTime" | "iSampleRate" | "iFrameRate", _) => from(0.0, Tightness::Loose),
        // Zero until the first click.
        ("iMouse", 0 | 1) => from(0.0, Tightness::Touched).exactly(),
        ("iMouse", _) => Interval::ANY.exactly(),
        ("iDate", 1) => Interval::new(0.0, 11.0, Tightness::Touched).exactly(),
        ("iDate", 2) => Interval::new(1.0, 31.0, Tightness::Touched).exactly(),
        ("iDate", 3) => Interval::new(0.0, 86_400.0, Tightness::Touched),
        ("iDate", _) => from(1970.0, Tightness::Loose).exactly(),
        // 0.5 is the coordinate of the first pixel; no value is taken over a whole area.
        ("gl_FragCoord", 0 | 1) => from(0.5, Tightness::Touched).exactly(),
        ("gl_FragCoord", 2) => Interval::new(0.0, 1.0, Tightness::Loose),
        ("gl_PointCoord", _) => Interval::new(0.0, 1.0, Tightness::Touched),
        _ => return None,
    })
}
