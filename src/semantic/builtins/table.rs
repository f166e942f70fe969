//! Table of built-in functions: one row per function, one column per property. A row with a missing
//! column does not compile. The overloads of each version and stage are prototypes in
//! `functions_*.glsl`; the table describes what the functions do.

use super::row::BuiltinKind::{Derivative, Math, Size};
use super::row::Level::{Explicit, Fetch, Gradient, Implicit};
use super::row::Transfer::*;
use super::row::{Axis, BuiltinRow, lookup, projected, projected_shifted, shifted};
use crate::constant::Value;
use crate::fold::Folding::{ByColumns, Never, Values};
use crate::fold::*;
use crate::undefined::Undefined;
use shaderlint_math as math;
use shaderlint_math::{bits_of, half_bits, half_value, of_one, of_two};
use shaderlint_text::WordIndex;
use std::f32::consts::PI;
use std::f64;

/// A single instruction, the unit of cost.
const ONE: u8 = 1;
/// A special function unit, or several instructions.
const SPECIAL: u8 = 4;
const TEXTURE: u8 = 8;

macro_rules! table {
    ($($id:ident $name:literal $kind:expr, $cost:expr, $range:expr, $undefined:ident, $fold:expr;)*) => {
        /// A built-in function, identified by its name; the lookups of GLSL ES 1.00 are separate
        /// functions.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        #[repr(u8)]
        pub enum BuiltinId {
            $(#[doc = concat!("`", $name, "`")] $id,)*
        }

        impl BuiltinId {
            /// All built-in functions, in table order.
            pub const ALL: &[BuiltinId] = &[$(BuiltinId::$id),*];

            /// The function of this name in any version.
            #[expect(clippy::indexing_slicing, reason = "both lists are the table")]
            pub const fn named(name: &str) -> Option<BuiltinId> {
                static NAMES: WordIndex<512> = WordIndex::new(&[$($name),*]);
                match NAMES.find(name) {
                    Some(at) => Some(BuiltinId::ALL[at]),
                    None => None,
                }
            }

            /// The table row of the function.
            pub(super) const fn row(self) -> &'static BuiltinRow {
                match self {
                    $(BuiltinId::$id => const {
                        &BuiltinRow {
                            name: $name,
                            kind: $kind,
                            cost: $cost,
                            transfer: $range,
                            undefined: Undefined::$undefined,
                            fold: $fold,
                        }
                    },)*
                }
            }
        }
    };
}

table! {
    // 8.1 Angle and trigonometry
    Radians              "radians"               Math, ONE,     Rising(|v| v * f64::consts::PI / 180.0), NEVER,           Values(|a| map(a, |x| x * (PI / 180.0)));
    Degrees              "degrees"               Math, ONE,     Rising(|v| v * 180.0 / f64::consts::PI), NEVER,           Values(|a| map(a, |x| x * (180.0 / PI)));
    Sin                  "sin"                   Math, SPECIAL, Sine,                        NEVER,           Values(|a| map(a, |x| of_one(math::sin, x)));
    Cos                  "cos"                   Math, SPECIAL, Cosine,                      NEVER,           Values(|a| map(a, |x| of_one(math::cos, x)));
    Tan                  "tan"                   Math, SPECIAL, Unknown,                     NEVER,           Values(|a| map(a, |x| of_one(math::tan, x)));
    Asin                 "asin"                  Math, SPECIAL, RisingOn(-1.0, 1.0, f64::asin), BEYOND_ONE,      Values(|a| map(a, |x| of_one(math::asin, x)));
    Acos                 "acos"                  Math, SPECIAL, FallingOn(-1.0, 1.0, f64::acos), BEYOND_ONE,      Values(|a| map(a, |x| of_one(math::acos, x)));
    Atan                 "atan"                  Math, SPECIAL, ArcTangent,                  NO_DIRECTION,    Values(arc_tangent);
    Sinh                 "sinh"                  Math, SPECIAL, Unknown,                     NEVER,           Values(|a| map(a, |x| of_one(math::sinh, x)));
    Cosh                 "cosh"                  Math, SPECIAL, Unknown,                     NEVER,           Values(|a| map(a, |x| of_one(math::cosh, x)));
    Tanh                 "tanh"                  Math, SPECIAL, Rising(f64::tanh),           NEVER,           Values(|a| map(a, |x| of_one(math::tanh, x)));
    Asinh                "asinh"                 Math, SPECIAL, Unknown,                     NEVER,           Values(|a| map(a, |x| of_one(math::asinh, x)));
    Acosh                "acosh"                 Math, SPECIAL, Unknown,                     BELOW_ONE,       Values(|a| map(a, |x| of_one(math::acosh, x)));
    Atanh                "atanh"                 Math, SPECIAL, Unknown,                     FROM_ONE_ON,     Values(|a| map(a, |x| of_one(math::atanh, x)));

    // 8.2 Exponential
    Pow                  "pow"                   Math, SPECIAL, Power,                       NO_POWER,        Values(|a| map2(a, |x, y| of_two(math::pow, x, y)));
    Exp                  "exp"                   Math, SPECIAL, Rising(f64::exp),            NEVER,           Values(|a| map(a, |x| of_one(math::exp, x)));
    Log                  "log"                   Math, SPECIAL, Logarithm(f64::ln),          NOT_POSITIVE,    Values(|a| map(a, |x| of_one(math::log, x)));
    Exp2                 "exp2"                  Math, SPECIAL, Rising(f64::exp2),           NEVER,           Values(|a| map(a, |x| of_one(math::exp2, x)));
    Log2                 "log2"                  Math, SPECIAL, Logarithm(f64::log2),        NOT_POSITIVE,    Values(|a| map(a, |x| of_one(math::log2, x)));
    Sqrt                 "sqrt"                  Math, SPECIAL, RisingOn(0.0, f64::INFINITY, f64::sqrt), NEGATIVE,        Values(|a| map(a, f32::sqrt));
    InverseSqrt          "inversesqrt"           Math, SPECIAL, NonNegative,                 NOT_POSITIVE,    Values(|a| map(a, |x| 1.0 / x.sqrt()));

    // 8.3 Common
    Abs                  "abs"                   Math, ONE,     Magnitude,                   NEVER,           Values(absolute);
    Sign                 "sign"                  Math, ONE,     Signum,                      NEVER,           Values(signum);
    Floor                "floor"                 Math, ONE,     Rounded(f64::floor),         NEVER,           Values(|a| map(a, f32::floor));
    Trunc                "trunc"                 Math, ONE,     Rounded(f64::trunc),         NEVER,           Values(|a| map(a, f32::trunc));
    Round                "round"                 Math, ONE,     Rounded(f64::round_ties_even), NEVER,           Values(|a| map(a, f32::round));
    RoundEven            "roundEven"             Math, ONE,     Rounded(f64::round_ties_even), NEVER,           Values(|a| map(a, f32::round_ties_even));
    Ceil                 "ceil"                  Math, ONE,     Rounded(f64::ceil),          NEVER,           Values(|a| map(a, f32::ceil));
    Fract                "fract"                 Math, ONE,     Fraction,                    NEVER,           Values(|a| map(a, |x| x - x.floor()));
    Mod                  "mod"                   Math, ONE,     Modulo,                      NEVER,           Values(|a| map2(a, |x, y| x - y * (x / y).floor()));
    Modf                 "modf"                  Math, ONE,     Unknown,                     NEVER,           Never;
    Min                  "min"                   Math, ONE,     Minimum,                     NEVER,           Values(|a| pair(a, |x, y| if less(y, x) { y } else { x }));
    Max                  "max"                   Math, ONE,     Maximum,                     NEVER,           Values(|a| pair(a, |x, y| if less(x, y) { y } else { x }));
    Clamp                "clamp"                 Math, ONE,     Between,                     NOTHING_BETWEEN, Values(clamp);
    Mix                  "mix"                   Math, ONE,     Blend,                       NEVER,           Values(mix);
    Step                 "step"                  Math, ONE,     Threshold,                   NEVER,           Values(|a| map2(a, |edge, x| if x < edge { 0.0 } else { 1.0 }));
    Smoothstep           "smoothstep"            Math, SPECIAL, Ramp,                        NO_RISE,         Values(smoothstep);
    IsNan                "isnan"                 Math, ONE,     Unknown,                     NEVER,           Values(|a| each(a, |x| Value::Bool(x.as_float().is_nan())));
    IsInf                "isinf"                 Math, ONE,     Unknown,                     NEVER,           Values(|a| each(a, |x| Value::Bool(x.as_float().is_infinite())));
    FloatBitsToInt       "floatBitsToInt"        Math, ONE,     Unknown,                     NEVER,           Values(|a| each(a, |x| Value::Int(bits_of(x.as_float()) as i32)));
    FloatBitsToUint      "floatBitsToUint"       Math, ONE,     Unknown,                     NEVER,           Values(|a| each(a, |x| Value::Uint(bits_of(x.as_float()))));
    IntBitsToFloat       "intBitsToFloat"        Math, ONE,     Unknown,                     NEVER,           Values(float_of_bits);
    UintBitsToFloat      "uintBitsToFloat"       Math, ONE,     Unknown,                     NEVER,           Values(float_of_bits);

    // 8.4 Packing
    PackSnorm2x16        "packSnorm2x16"         Math, ONE,     Unknown,                     NEVER,           Values(|a| pack(a, snorm_bits));
    UnpackSnorm2x16      "unpackSnorm2x16"       Math, ONE,     Unknown,                     NEVER,           Values(|a| unpack(a, |x| (x as i16 as f32 / 32767.0).clamp(-1.0, 1.0)));
    PackUnorm2x16        "packUnorm2x16"         Math, ONE,     Unknown,                     NEVER,           Values(|a| pack(a, |x| (x.clamp(0.0, 1.0) * 65535.0).round() as u16));
    UnpackUnorm2x16      "unpackUnorm2x16"       Math, ONE,     Unknown,                     NEVER,           Values(|a| unpack(a, |x| x as f32 / 65535.0));
    PackHalf2x16         "packHalf2x16"          Math, ONE,     Unknown,                     NEVER,           Values(|a| pack(a, half_bits));
    UnpackHalf2x16       "unpackHalf2x16"        Math, ONE,     Unknown,                     NEVER,           Values(|a| unpack(a, half_value));

    // 8.5 Geometry
    Length               "length"                Math, SPECIAL, Norm,                        NEVER,           Values(length);
    Distance             "distance"              Math, SPECIAL, Separation,                  NEVER,           Values(distance);
    Dot                  "dot"                   Math, ONE,     Product,                     NEVER,           Values(|a| scalar(zip(a)?.map(|(x, y)| x * y).sum()));
    Cross                "cross"                 Math, ONE,     Mixed,                       NEVER,           Values(cross);
    Normalize            "normalize"             Math, SPECIAL, Direction,                   NEVER,           Values(normalize);
    FaceForward          "faceforward"           Math, ONE,     Mixed,                       NEVER,           Values(face_forward);
    Reflect              "reflect"               Math, SPECIAL, Reflection,                  NEVER,           Values(reflect);
    Refract              "refract"               Math, SPECIAL, Mixed,                       NEVER,           Values(refract);

    // 8.6 Matrices
    MatrixCompMult       "matrixCompMult"        Math, ONE,     Unknown,                     NEVER,           Values(|a| map2(a, |x, y| x * y));
    OuterProduct         "outerProduct"          Math, ONE,     Unknown,                     NEVER,           Values(outer_product);
    Transpose            "transpose"             Math, ONE,     Unknown,                     NEVER,           ByColumns(transpose);
    Determinant          "determinant"           Math, SPECIAL, Unknown,                     NEVER,           Values(|a| scalar(determinant(&square(a.first()?)?)));
    Inverse              "inverse"               Math, SPECIAL, Unknown,                     NEVER,           Values(inverse);

    // 8.7 Vector relations
    LessThan             "lessThan"              Math, ONE,     Unknown,                     NEVER,           Values(|a| pair(a, |x, y| Value::Bool(less(x, y))));
    LessThanEqual        "lessThanEqual"         Math, ONE,     Unknown,                     NEVER,           Values(|a| pair(a, |x, y| Value::Bool(less(x, y) || x == y)));
    GreaterThan          "greaterThan"           Math, ONE,     Unknown,                     NEVER,           Values(|a| pair(a, |x, y| Value::Bool(less(y, x))));
    GreaterThanEqual     "greaterThanEqual"      Math, ONE,     Unknown,                     NEVER,           Values(|a| pair(a, |x, y| Value::Bool(less(y, x) || x == y)));
    Equal                "equal"                 Math, ONE,     Unknown,                     NEVER,           Values(|a| pair(a, |x, y| Value::Bool(x == y)));
    NotEqual             "notEqual"              Math, ONE,     Unknown,                     NEVER,           Values(|a| pair(a, |x, y| Value::Bool(x != y)));
    Any                  "any"                   Math, ONE,     Unknown,                     NEVER,           Values(|a| Some(vec![Value::Bool(a.first()?.iter().any(|v| v.as_bool()))]));
    All                  "all"                   Math, ONE,     Unknown,                     NEVER,           Values(|a| Some(vec![Value::Bool(a.first()?.iter().all(|v| v.as_bool()))]));
    Not                  "not"                   Math, ONE,     Unknown,                     NEVER,           Values(|a| each(a, |x| Value::Bool(!x.as_bool())));

    // 8.8 Texture lookup
    TextureSize          "textureSize"           Size,                       TEXTURE, Unknown,                     NEVER,           Never;
    Texture              "texture"               lookup(Implicit),           TEXTURE, Texel,                       NEVER,           Never;
    TextureOffset        "textureOffset"         shifted(Implicit),          TEXTURE, Texel,                       NEVER,           Never;
    TextureLod           "textureLod"            lookup(Explicit),           TEXTURE, Texel,                       NEVER,           Never;
    TextureLodOffset     "textureLodOffset"      shifted(Explicit),          TEXTURE, Texel,                       NEVER,           Never;
    TextureGrad          "textureGrad"           lookup(Gradient),           TEXTURE, Texel,                       NEVER,           Never;
    TextureGradOffset    "textureGradOffset"     shifted(Gradient),          TEXTURE, Texel,                       NEVER,           Never;
    TextureProj          "textureProj"           projected(Implicit),        TEXTURE, Texel,                       NEVER,           Never;
    TextureProjOffset    "textureProjOffset"     projected_shifted(Implicit), TEXTURE, Texel,                       NEVER,           Never;
    TextureProjLod       "textureProjLod"        projected(Explicit),        TEXTURE, Texel,                       NEVER,           Never;
    TextureProjLodOffset "textureProjLodOffset"  projected_shifted(Explicit), TEXTURE, Texel,                      NEVER,           Never;
    TextureProjGrad      "textureProjGrad"       projected(Gradient),        TEXTURE, Texel,                       NEVER,           Never;
    TextureProjGradOffset "textureProjGradOffset" projected_shifted(Gradient), TEXTURE, Texel,                      NEVER,           Never;
    TexelFetch           "texelFetch"            lookup(Fetch),              TEXTURE, Texel,                       NEVER,           Never;
    TexelFetchOffset     "texelFetchOffset"      shifted(Fetch),             TEXTURE, Texel,                       NEVER,           Never;

    // 8.7 of GLSL ES 1.00: lookups named after the sampler
    Texture2D            "texture2D"             lookup(Implicit),           TEXTURE, Texel,                       NEVER,           Never;
    Texture2DProj        "texture2DProj"         projected(Implicit),        TEXTURE, Texel,                       NEVER,           Never;
    Texture2DLod         "texture2DLod"          lookup(Explicit),           TEXTURE, Texel,                       NEVER,           Never;
    Texture2DProjLod     "texture2DProjLod"      projected(Explicit),        TEXTURE, Texel,                       NEVER,           Never;
    TextureCube          "textureCube"           lookup(Implicit),           TEXTURE, Texel,                       NEVER,           Never;
    TextureCubeLod       "textureCubeLod"        lookup(Explicit),           TEXTURE, Texel,                       NEVER,           Never;

    // EXT_shader_texture_lod
    Texture2DLodExt      "texture2DLodEXT"       lookup(Explicit),           TEXTURE, Texel,                       NEVER,           Never;
    Texture2DProjLodExt  "texture2DProjLodEXT"   projected(Explicit),        TEXTURE, Texel,                       NEVER,           Never;
    TextureCubeLodExt    "textureCubeLodEXT"     lookup(Explicit),           TEXTURE, Texel,                       NEVER,           Never;
    Texture2DGradExt     "texture2DGradEXT"      lookup(Gradient),           TEXTURE, Texel,                       NEVER,           Never;
    Texture2DProjGradExt "texture2DProjGradEXT"  projected(Gradient),        TEXTURE, Texel,                       NEVER,           Never;
    TextureCubeGradExt   "textureCubeGradEXT"    lookup(Gradient),           TEXTURE, Texel,                       NEVER,           Never;

    // 8.9 Fragment processing
    DFdx                 "dFdx"                  Derivative(Axis::X),        ONE,     Mixed,                       NEVER,           Never;
    DFdy                 "dFdy"                  Derivative(Axis::Y),        ONE,     Mixed,                       NEVER,           Never;
    Fwidth               "fwidth"                Derivative(Axis::Both),     ONE,     MixedMagnitude,              NEVER,           Never;

    // OES_shader_multisample_interpolation; no recipe, so that it is not run
    InterpolateAtCentroid "interpolateAtCentroid" Math,   ONE,     Unknown,                     NEVER,           Never;
    InterpolateAtSample  "interpolateAtSample"   Math,    ONE,     Unknown,                     NEVER,           Never;
    InterpolateAtOffset  "interpolateAtOffset"   Math,    ONE,     Unknown,                     NEVER,           Never;
}
