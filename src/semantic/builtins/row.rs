//! The columns of the table of built-in functions.

use crate::fold::Folding;
use crate::undefined::Undefined;

/// What the table says of a built-in function.
#[derive(Debug)]
pub(super) struct Row {
    /// As it is written.
    pub name: &'static str,
    /// What it does.
    pub kind: BuiltinKind,
    /// What a call costs.
    pub cost: u8,
    /// What is known of its result's range.
    pub transfer: Transfer,
    /// For which arguments its result is undefined.
    pub undefined: Undefined,
    /// How it is computed of constants.
    pub fold: Folding,
}

/// What a built-in function does, as far as the checks ask.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum BuiltinKind {
    /// Computes; constant if its arguments are and nothing is written.
    Math,
    /// Compares an expression between neighbouring pixels.
    Derivative(Axis),
    /// Reads a texture.
    Lookup(Lookup),
    /// Tells the size of a texture.
    Size,
}

impl BuiltinKind {
    /// Whether it asks a texture.
    pub const fn is_texture(self) -> bool {
        matches!(self, BuiltinKind::Lookup(_) | BuiltinKind::Size)
    }

    /// Whether it takes derivatives without being given any, which neighbouring pixels must do
    /// together.
    pub const fn takes_derivatives(self) -> bool {
        match self {
            BuiltinKind::Derivative(_) => true,
            BuiltinKind::Lookup(lookup) => matches!(lookup.level, Level::Implicit),
            BuiltinKind::Math | BuiltinKind::Size => false,
        }
    }
}

/// Between which neighbours a derivative is taken.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Axis {
    /// Side by side: `dFdx`.
    X,
    /// One above the other: `dFdy`.
    Y,
    /// The sum of both without signs: `fwidth`.
    Both,
}

/// How a lookup reads its texture. Whether it compares depths is told by the sampler's type, and
/// whether it takes a bias by the overload.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Lookup {
    /// What tells the level.
    pub level: Level,
    /// Whether the coordinates are divided by the last.
    pub is_projective: bool,
    /// Whether it takes an offset in texels.
    pub has_offset: bool,
}

/// What tells the level of detail that a lookup reads.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Level {
    /// Derivatives of the coordinates that the lookup takes itself.
    Implicit,
    /// An argument.
    Explicit,
    /// Derivatives that are arguments.
    Gradient,
    /// An argument; the coordinates are whole numbers, and nothing is filtered.
    Fetch,
}

/// The kind of a plain lookup.
pub(super) const fn lookup(level: Level) -> BuiltinKind {
    BuiltinKind::Lookup(Lookup {
        level,
        is_projective: false,
        has_offset: false,
    })
}

/// The kind of a lookup that divides its coordinates.
pub(super) const fn projected(level: Level) -> BuiltinKind {
    BuiltinKind::Lookup(Lookup {
        level,
        is_projective: true,
        has_offset: false,
    })
}

/// The kind of a lookup with an offset.
pub(super) const fn shifted(level: Level) -> BuiltinKind {
    BuiltinKind::Lookup(Lookup {
        level,
        is_projective: false,
        has_offset: true,
    })
}

/// The kind of a lookup that divides its coordinates, with an offset.
pub(super) const fn projected_shifted(level: Level) -> BuiltinKind {
    BuiltinKind::Lookup(Lookup {
        level,
        is_projective: true,
        has_offset: true,
    })
}

/// How the range of a result follows from the ranges of the arguments; the ranges of `flow` carry it
/// out.
#[derive(Clone, Copy, Debug)]
pub enum Transfer {
    /// Nothing is known but which arguments it depends on.
    Unknown,
    /// A function that never falls.
    Rising(fn(f64) -> f64),
    /// A function that never falls and is defined between two arguments.
    RisingOn(f64, f64, fn(f64) -> f64),
    /// A function that never rises and is defined between two arguments.
    FallingOn(f64, f64, fn(f64) -> f64),
    /// A function that never falls and yields whole numbers.
    Rounded(fn(f64) -> f64),
    /// A function that never falls; nothing is known where the argument may not be positive.
    Logarithm(fn(f64) -> f64),
    /// Zero or more, whatever the argument.
    NonNegative,
    /// `sin`
    Sine,
    /// `cos`
    Cosine,
    /// `atan`, of one argument or two.
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
    /// The length of a vector.
    Norm,
    /// The length of a difference.
    Separation,
    /// `dot`
    Product,
    /// `normalize`
    Direction,
    /// `reflect`
    Reflection,
    /// What a texture holds: anything.
    Texel,
    /// Anything; every component depends on all components of the arguments.
    Mixed,
    /// Zero or more; every component depends on all components of the arguments.
    MixedMagnitude,
}
