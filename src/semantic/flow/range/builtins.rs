//! Ranges of built-in functions and of what hosts provide.

use super::interval::{Range, Reach, below, is_power_of_two};
use std::f64::consts::{PI, TAU};

/// The range of a component of a built-in function's result, given those of the arguments at that
/// component. Functions that mix components are not here.
pub fn of_function(name: &str, args: &[Range]) -> Range {
    let range = match *args {
        [x] => of_one(name, x),
        [x, y] => of_two(name, x, y),
        [x, y, z] => of_three(name, x, y, z),
        _ => None,
    };
    let mut range = range.unwrap_or(Range::ANY);
    for arg in args {
        range = range.like(arg);
    }
    range
}

fn of_one(name: &str, x: Range) -> Option<Range> {
    Some(match name {
        "sin" => wave(x, 0.5 * PI),
        "cos" => wave(x, 0.0),
        "atan" => x.rising(f64::atan),
        "asin" => inside(x, -1.0, 1.0).rising(f64::asin),
        "acos" => (-inside(x, -1.0, 1.0)).rising(|v| (-v).acos()),
        "tanh" => x.rising(f64::tanh),
        "abs" => x.abs(),
        "sign" => x
            .rising(|v| if v == 0.0 { 0.0 } else { v.signum() })
            .exactly(),
        "floor" => x.rising(f64::floor).exactly(),
        "ceil" => x.rising(f64::ceil).exactly(),
        "trunc" => x.rising(f64::trunc).exactly(),
        "round" | "roundEven" => x.rising(f64::round_ties_even).exactly(),
        "fract" => of_two("mod", x, Range::constant(1.0))?,
        "exp" => x.rising(f64::exp),
        "exp2" => x.rising(f64::exp2),
        "log" if x.lo.value > 0.0 => x.rising(f64::ln),
        "log2" if x.lo.value > 0.0 => x.rising(f64::log2),
        "sqrt" => inside(x, 0.0, f64::INFINITY).rising(f64::sqrt),
        "inversesqrt" => Range::new(0.0, f64::INFINITY, Reach::Loose),
        "radians" => x.rising(|v| v * PI / 180.0),
        "degrees" => x.rising(|v| v * 180.0 / PI),
        _ => return None,
    })
}

fn of_two(name: &str, x: Range, y: Range) -> Option<Range> {
    Some(match name {
        "min" => x.min(y),
        "max" => x.max(y),
        "step" => Range::new(0.0, 1.0, Reach::Held).exactly(),
        "atan" => Range::new(-PI, PI, Reach::Touched),
        "mod" => {
            let divisor = y.single().filter(|d| *d > 0.0)?;
            if x.lo.value >= 0.0 && x.hi.value < divisor {
                return Some(x);
            }
            let reach = if x.is_finite() && !x.lo.is_reached() {
                Reach::Loose
            } else {
                Reach::Touched
            };
            let mut range = Range::new(0.0, below(divisor), reach);
            // The division inside rounds, unless it is by a power of two.
            range.exact = x.exact && is_power_of_two(divisor);
            range
        }
        "pow" => {
            let exponent = y.single()?;
            let base = inside(x, 0.0, f64::INFINITY);
            if x.lo.value < 0.0 {
                return None;
            }
            if exponent >= 0.0 {
                base.rising(|v| v.powf(exponent))
            } else {
                (-base).rising(|v| (0.0 - v).powf(exponent))
            }
        }
        _ => return None,
    })
}

fn of_three(name: &str, x: Range, y: Range, z: Range) -> Option<Range> {
    Some(match name {
        "clamp" => x.max(y).min(z),
        "smoothstep" => {
            let reach = if z.is_finite() {
                Reach::Touched
            } else {
                Reach::Held
            };
            Range::new(0.0, 1.0, reach)
        }
        "mix" if z.lo.value >= 0.0 && z.hi.value <= 1.0 => {
            let range = x.join(y);
            let is_reached = z.lo.is_reached() && z.hi.is_reached();
            let is_free = (x.sources & z.sources) | (y.sources & z.sources) == 0;
            let mut range = if is_reached && is_free {
                range.touched()
            } else {
                range.loose()
            };
            range.exact &= z.exact;
            range
        }
        _ => return None,
    })
}

/// The part of a range between two numbers; a function is not defined beyond.
fn inside(x: Range, lo: f64, hi: f64) -> Range {
    let mut part = x;
    part.raise(lo);
    part.lower(hi);
    part
}

/// A sine wave with a crest at `crest`.
fn wave(x: Range, crest: f64) -> Range {
    let full = Range::new(-1.0, 1.0, Reach::Touched);
    if !x.is_finite() {
        return full;
    }
    let (lo, hi) = (x.lo.value, x.hi.value);
    let is_reached = x.lo.is_reached() && x.hi.is_reached();
    let passes = |at: f64| ((lo - at) / TAU).ceil() * TAU + at <= hi;
    let (a, b) = ((lo - crest).cos(), (hi - crest).cos());
    let low = if passes(crest + PI) { -1.0 } else { a.min(b) };
    let high = if passes(crest) { 1.0 } else { a.max(b) };
    let range = Range::new(low, high, Reach::Touched);
    if is_reached { range } else { range.loose() }
}

/// What is known of a variable that ShaderToy's player or the language fills in, by component.
pub fn of_host(name: &str, component: u8) -> Option<Range> {
    let from = |lo, reach| Range::new(lo, f64::INFINITY, reach);
    Some(match (name, component) {
        ("iTime" | "iTimeDelta", _) => from(0.0, Reach::Touched),
        ("iFrame" | "gl_VertexID" | "gl_InstanceID", _) => from(0.0, Reach::Held).exactly(),
        ("iResolution", _) => from(1.0, Reach::Loose).exactly(),
        ("iChannelResolution", _) => from(0.0, Reach::Loose).exactly(),
        ("iChannelTime" | "iSampleRate" | "iFrameRate", _) => from(0.0, Reach::Loose),
        ("iMouse", _) => Range::ANY.exactly(),
        ("iDate", 1) => Range::new(0.0, 11.0, Reach::Touched).exactly(),
        ("iDate", 2) => Range::new(1.0, 31.0, Reach::Touched).exactly(),
        ("iDate", 3) => Range::new(0.0, 86_400.0, Reach::Touched),
        ("iDate", _) => from(1970.0, Reach::Loose).exactly(),
        ("gl_FragCoord", 0 | 1) => from(0.5, Reach::Loose).exactly(),
        ("gl_FragCoord", 2) => Range::new(0.0, 1.0, Reach::Loose),
        ("gl_PointCoord", _) => Range::new(0.0, 1.0, Reach::Touched),
        _ => return None,
    })
}
