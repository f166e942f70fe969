//! Columns of the table of built-in functions.

use crate::fold::Folding;
use crate::undefined::Undefined;

/// Row of the table of built-in functions.
#[derive(Debug)]
pub(super) struct BuiltinRow {
    /// Name in GLSL.
    pub name: &'static str,
    /// What the function does.
    pub kind: BuiltinKind,
    /// Cost of a call, relative to one instruction.
    pub cost: u8,
    /// How the range of the result depends on the arguments.
    pub transfer: Transfer,
    /// Arguments for which the result is undefined.
    pub undefined: Undefined,
    /// How it is evaluated for constant arguments.
    pub fold: Folding,
}

/// Category of a built-in function.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum BuiltinKind {
    /// A computation; constant if its arguments are and it writes nothing.
    Math,
    /// A derivative between neighbouring pixels.
    Derivative(Axis),
    /// A texture lookup.
    Lookup(Lookup),
    /// A query of a texture's size.
    Size,
}

impl BuiltinKind {
    /// Whether it accesses a texture.
    pub const fn is_texture(self) -> bool {
        matches!(self, BuiltinKind::Lookup(_) | BuiltinKind::Size)
    }

    /// Whether it computes implicit derivatives, which require that neighbouring pixels call it
    /// together.
    pub const fn takes_derivatives(self) -> bool {
        match self {
            BuiltinKind::Derivative(_) => true,
            BuiltinKind::Lookup(lookup) => matches!(lookup.level, Level::Implicit),
            BuiltinKind::Math | BuiltinKind::Size => false,
        }
    }
}

/// Direction of a derivative.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Axis {
    /// Horizontal: `dFdx`.
    X,
    /// Vertical: `dFdy`.
    Y,
    /// Sum of the absolute values of both: `fwidth`.
    Both,
}

/// How a lookup reads its texture. Depth comparison follows from the sampler type, and a bias from
/// the overload.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Lookup {
    /// How the level of detail is determined.
    pub level: Level,
    /// Whether the coordinates are divided by the last one.
    pub is_projective: bool,
    /// Whether it has an offset in texels.
    pub has_offset: bool,
}

/// How a lookup determines the level of detail.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Level {
    /// From implicit derivatives of the coordinates.
    Implicit,
    /// From an argument.
    Explicit,
    /// From derivatives passed as arguments.
    Gradient,
    /// From an argument; the coordinates are integers and there is no filtering.
    Fetch,
}

pub(super) const fn lookup(level: Level) -> BuiltinKind {
    BuiltinKind::Lookup(Lookup {
        level,
        is_projective: false,
        has_offset: false,
    })
}

/// A projective lookup.
pub(super) const fn projected(level: Level) -> BuiltinKind {
    BuiltinKind::Lookup(Lookup {
        level,
        is_projective: true,
        has_offset: false,
    })
}

/// A lookup with an offset.
pub(super) const fn shifted(level: Level) -> BuiltinKind {
    BuiltinKind::Lookup(Lookup {
        level,
        is_projective: false,
        has_offset: true,
    })
}

/// A projective lookup with an offset.
pub(super) const fn projected_shifted(level: Level) -> BuiltinKind {
    BuiltinKind::Lookup(Lookup {
        level,
        is_projective: true,
        has_offset: true,
    })
}

/// How the range of a result follows from the ranges of the arguments; implemented in `flow`.
#[derive(Clone, Copy, Debug)]
pub enum Transfer {
    /// Only the arguments that it depends on are known.
    Unknown,
    /// A non-decreasing function.
    Rising(fn(f64) -> f64),
    /// A non-decreasing function on a domain between two bounds.
    RisingOn(f64, f64, fn(f64) -> f64),
    /// A non-increasing function on a domain between two bounds.
    FallingOn(f64, f64, fn(f64) -> f64),
    /// A non-decreasing function with integer results.
    Rounded(fn(f64) -> f64),
    /// A non-decreasing function; the result is unknown if the argument may not be positive.
    Logarithm(fn(f64) -> f64),
    /// Zero or more for any argument.
    NonNegative,
    /// `sin`
    Sine,
    /// `cos`
    Cosine,
    /// `atan` with one or two arguments.
    ArcTangent,
    /// `pow`
    Power,
    /// `abs`
    Magnitude,
    /// `sign`
    Signum,
    /// `fract`
    Fraction,
    /// `mod`
    Modulo,
    /// `min`
    Minimum,
    /// `max`
    Maximum,
    /// `clamp`
    Between,
    /// `mix`
    Blend,
    /// `step`
    Threshold,
    /// `smoothstep`
    Ramp,
    /// Length of a vector.
    Norm,
    /// Length of a difference.
    Separation,
    /// `dot`
    Product,
    /// `normalize`
    Direction,
    /// `reflect`
    Reflection,
    /// A texture value: anything.
    Texel,
    /// Anything; every component depends on all components of the arguments.
    Mixed,
    /// Zero or more; every component depends on all components of the arguments.
    MixedMagnitude,
}
