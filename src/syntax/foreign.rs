//! Types, functions and values of other languages, with their GLSL equivalents. In GLSL these are
//! ordinary identifiers, so a word counts as foreign only where it is not declared.

use super::names::{TypeWord, Version, WordClass, classify};
use rustc_hash::FxHashMap;
use std::sync::OnceLock;

/// GLSL equivalent of a foreign word.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Meaning {
    /// A GLSL type.
    Type(&'static str),
    /// A placeholder for an inferred type, such as `auto`; GLSL needs the type of the initializer.
    Inferred,
    /// A GLSL function with the same arguments.
    Function(&'static str),
    /// GLSL code with `$1` to `$4` for the arguments, and the number of arguments.
    Code(&'static str, usize),
    /// As `Code`, but not equivalent in every case; the last string explains the difference.
    Nearly(&'static str, usize, &'static str),
    /// GLSL code that must be a statement.
    Statement(&'static str, usize),
    /// A GLSL expression.
    Value(&'static str),
    /// A null value; 0 is the closest equivalent.
    Zero,
    /// No equivalent: prints or asserts something, so the statement can be removed.
    Silent,
    /// A namespace; its members are plain names in GLSL.
    Namespace,
    /// No equivalent; the string explains why or what to use.
    Absent(&'static str),
}

/// A word of another language.
#[derive(Clone, Copy, Debug)]
pub struct Foreign {
    /// Name of the language for messages.
    pub language: &'static str,
    /// What to use in GLSL.
    pub meaning: Meaning,
}

use Meaning::*;

const MOD: &str = "the result of `mod` has the sign of the divisor, that of `fmod` of the dividend";
const NO_SAMPLER: &str = "GLSL combines a texture and its sampler in one `sampler2D`";
const NO_POINTER: &str = "GLSL has no pointers and no dynamic memory";

#[rustfmt::skip]
const HLSL: &[(&str, Meaning)] = &[
    ("half", Type("float")), ("fixed", Type("float")), ("double", Type("float")),
    ("long", Type("int")), ("short", Type("int")), ("min16float", Type("float")), ("min10float", Type("float")), ("min16int", Type("int")),
    ("min16uint", Type("uint")), ("real", Type("float")), ("matrix", Type("mat4")), ("vector", Type("vec4")), ("dword", Type("uint")),
    ("Texture2D", Type("sampler2D")), ("Texture3D", Type("sampler3D")),
    ("TextureCube", Type("samplerCube")), ("Texture2DArray", Type("sampler2DArray")),
    ("sampler2D_float", Type("sampler2D")), ("SamplerState", Absent(NO_SAMPLER)),
    ("SamplerComparisonState", Absent(NO_SAMPLER)), ("sampler", Absent(NO_SAMPLER)),
    ("lerp", Function("mix")), ("frac", Function("fract")), ("rsqrt", Function("inversesqrt")),
    ("atan2", Function("atan")), ("ddx", Function("dFdx")), ("ddy", Function("dFdy")),
    ("ddx_fine", Function("dFdx")), ("ddy_fine", Function("dFdy")),
    ("ddx_coarse", Function("dFdx")), ("ddy_coarse", Function("dFdy")),
    ("tex2D", Function("texture")), ("tex3D", Function("texture")), ("texCUBE", Function("texture")),
    ("tex2Dproj", Function("textureProj")), ("tex2Dgrad", Function("textureGrad")),
    ("tex2Dlod", Code("textureLod($1, ($2).xy, ($2).w)", 2)),
    ("tex2Dbias", Code("texture($1, ($2).xy, ($2).w)", 2)),
    ("texCUBElod", Code("textureLod($1, ($2).xyz, ($2).w)", 2)),
    ("mul", Code("($1 * $2)", 2)), ("saturate", Code("clamp($1, 0.0, 1.0)", 1)),
    ("mad", Code("($1 * $2 + $3)", 3)), ("rcp", Code("(1.0 / $1)", 1)),
    ("log10", Code("(log($1) / log(10.0))", 1)), ("ldexp", Code("($1 * exp2($2))", 2)),
    ("fmod", Nearly("mod($1, $2)", 2, MOD)),
    ("sincos", Statement("$2 = sin($1), $3 = cos($1)", 3)),
    ("clip", Statement("if ($1 < 0.0) discard", 1)),
    ("asfloat", Function("intBitsToFloat")), ("asint", Function("floatBitsToInt")),
    ("asuint", Function("floatBitsToUint")), ("isfinite", Code("!(isnan($1) || isinf($1))", 1)),
    ("fwidth_fine", Function("fwidth")), ("msad4", Absent("GLSL has no equivalent function")),
    ("dst", Absent("GLSL has no equivalent function")), ("lit", Absent("GLSL has no equivalent function")),
    ("GetDimensions", Absent("use `textureSize(s, 0)` for the size of a texture")),
    ("StructuredBuffer", Absent("WebGL2 shaders read data from textures and uniform blocks")),
    ("RWTexture2D", Absent("WebGL2 shaders can write only to their outputs")),
    ("groupshared", Absent("WebGL2 has no compute shaders")),
];

#[rustfmt::skip]
const C: &[(&str, Meaning)] = &[
    ("auto", Inferred), ("size_t", Type("uint")), ("char", Type("int")), ("byte", Type("int")),
    ("int8_t", Type("int")), ("int16_t", Type("int")), ("int32_t", Type("int")),
    ("int64_t", Type("int")), ("uint8_t", Type("uint")), ("uint16_t", Type("uint")),
    ("uint32_t", Type("uint")), ("uint64_t", Type("uint")), ("uchar", Type("uint")),
    ("ushort", Type("uint")), ("ulong", Type("uint")), ("float32_t", Type("float")),
    ("float64_t", Type("float")), ("signed", Type("int")), ("_Bool", Type("bool")),
    ("fabs", Function("abs")), ("fmin", Function("min")), ("fmax", Function("max")),
    ("labs", Function("abs")), ("atan2f", Function("atan")), ("rsqrtf", Function("inversesqrt")),
    ("fminf", Function("min")), ("fmaxf", Function("max")), ("fabsf", Function("abs")),
    ("lrint", Code("int(round($1))", 1)), ("rint", Function("roundEven")),
    ("nearbyint", Function("roundEven")), ("fmodf", Nearly("mod($1, $2)", 2, MOD)),
    ("remainder", Code("($1 - $2 * roundEven($1 / $2))", 2)),
    ("fdim", Code("max($1 - $2, 0.0)", 2)), ("hypot", Code("length(vec2($1, $2))", 2)),
    ("cbrt", Code("(sign($1) * pow(abs($1), 1.0 / 3.0))", 1)), ("exp10", Code("pow(10.0, $1)", 1)),
    ("log1p", Code("log(1.0 + $1)", 1)), ("expm1", Code("(exp($1) - 1.0)", 1)),
    ("copysign", Code("(abs($1) * sign($2))", 2)), ("fma", Code("($1 * $2 + $3)", 3)),
    ("signbit", Code("($1 < 0.0)", 1)),
    ("M_PI", Value("3.14159265")), ("M_PI_2", Value("1.57079633")), ("M_PI_4", Value("0.78539816")),
    ("M_E", Value("2.71828183")), ("M_SQRT2", Value("1.41421356")), ("M_LN2", Value("0.69314718")),
    ("M_TWO_PI", Value("6.28318531")), ("M_TAU", Value("6.28318531")), ("M_1_PI", Value("0.31830989")),
    ("FLT_MAX", Value("3.402823466e+38")), ("FLT_MIN", Value("1.175494351e-38")),
    ("FLT_EPSILON", Value("1.192092896e-07")), ("DBL_MAX", Value("3.402823466e+38")),
    ("INT_MAX", Value("2147483647")), ("UINT_MAX", Value("4294967295u")),
    ("NULL", Zero), ("nullptr", Zero),
    ("INFINITY", Value("uintBitsToFloat(0x7F800000u)")), ("NAN", Value("uintBitsToFloat(0x7FC00000u)")),
    ("printf", Silent), ("puts", Silent), ("assert", Silent), ("static_assert", Silent),
    ("cout", Silent), ("std", Namespace), ("glm", Namespace), ("metal", Namespace),
    ("rand", Absent("GLSL has no random number generator; use a hash of the coordinates")),
    ("malloc", Absent(NO_POINTER)), ("throw", Absent("GLSL has no exceptions")),
    ("delete", Absent(NO_POINTER)), ("virtual", Absent("GLSL has no classes")),
];

#[rustfmt::skip]
const SCRIPT: &[(&str, Meaning)] = &[
    ("var", Inferred), ("let", Inferred), ("val", Inferred), ("local", Inferred), ("my", Inferred),
    ("dim", Inferred), ("number", Type("float")), ("Number", Type("float")), ("boolean", Type("bool")),
    ("Boolean", Type("bool")), ("integer", Type("int")), ("Integer", Type("int")),
    ("True", Value("true")), ("False", Value("false")), ("TRUE", Value("true")),
    ("FALSE", Value("false")), ("YES", Value("true")), ("NO", Value("false")),
    ("null", Zero), ("Null", Zero), ("nil", Zero), ("None", Zero), ("undefined", Zero),
    ("NaN", Value("uintBitsToFloat(0x7FC00000u)")),
    ("Infinity", Value("uintBitsToFloat(0x7F800000u)")),
    ("print", Silent), ("println", Silent), ("echo", Silent), ("alert", Silent), ("console", Silent),
    ("System", Silent), ("Debug", Silent), ("trace", Silent), ("fprintf", Silent), ("log_debug", Silent),
    ("Math", Namespace), ("math", Namespace), ("np", Namespace), ("numpy", Namespace),
    ("torch", Namespace), ("Mathf", Namespace), ("THREE", Namespace), ("MathUtils", Namespace),
    ("PI", Value("3.14159265")), ("Pi", Value("3.14159265")), ("TAU", Value("6.28318531")),
    ("TWO_PI", Value("6.28318531")), ("HALF_PI", Value("1.57079633")),
    ("len", Absent("use `a.length()` for an array, `length(v)` for a vector")),
    ("string", Absent("GLSL has no strings")), ("String", Absent("GLSL has no strings")),
    ("str", Absent("GLSL has no strings")),
    ("range", Absent("use a counting loop: `for (int i = 0; i < n; i++)`")),
    ("pass", Absent("an empty statement is `;` or `{}`")),
    ("raise", Absent("GLSL has no exceptions")),
    ("yield", Absent("GLSL has no coroutines")), ("await", Absent("GLSL has no asynchronous functions")),
    ("random", Absent("GLSL has no random number generator; use a hash of the coordinates")),
    ("elif", Absent("use `else if`")), ("elseif", Absent("use `else if`")),
    ("lambda", Absent("GLSL has no anonymous functions")),
    ("function", Absent("a function declaration starts with its return type")),
    ("def", Absent("a function declaration starts with its return type")),
];

#[rustfmt::skip]
const WGSL: &[(&str, Meaning)] = &[
    ("f32", Type("float")), ("f16", Type("float")), ("f64", Type("float")), ("i32", Type("int")),
    ("i64", Type("int")), ("u32", Type("uint")), ("u64", Type("uint")), ("u8", Type("uint")),
    ("texture_2d", Type("sampler2D")), ("texture_cube", Type("samplerCube")),
    ("dpdx", Function("dFdx")), ("dpdy", Function("dFdy")), ("dpdxFine", Function("dFdx")),
    ("dpdyFine", Function("dFdy")), ("inverseSqrt", Function("inversesqrt")),
    ("faceForward", Function("faceforward")), ("textureLoad", Function("texelFetch")),
    ("textureDimensions", Code("textureSize($1, 0)", 1)),
    ("textureSample", Code("texture($1, $3)", 3)),
    ("textureSampleLevel", Code("textureLod($1, $3, $4)", 4)),
    ("select", Code("($3 ? $2 : $1)", 3)), ("mat2x2f", Type("mat2")),
];

/// Word lists by language, in order of priority.
const LANGUAGES: &[(&str, &[(&str, Meaning)])] = &[
    ("HLSL", HLSL),
    ("C", C),
    ("WGSL", WGSL),
    ("another language", SCRIPT),
];

/// All words by name; a word of several languages belongs to the first in [`LANGUAGES`].
fn words() -> &'static FxHashMap<&'static str, Foreign> {
    static WORDS: OnceLock<FxHashMap<&str, Foreign>> = OnceLock::new();
    WORDS.get_or_init(|| {
        let mut all = FxHashMap::default();
        for &(language, words) in LANGUAGES {
            for &(word, meaning) in words {
                all.entry(word).or_insert(Foreign { language, meaning });
            }
        }
        all
    })
}

/// Looks up a word of another language.
pub fn foreign(word: &str, version: Version) -> Option<Foreign> {
    if word.is_empty() {
        return None;
    }
    if let Some(found) = words().get(word) {
        return Some(*found);
    }
    if let Some((language, ty)) = foreign_type(word, version) {
        let meaning = Type(ty);
        return Some(Foreign { language, meaning });
    }
    let plain = word.strip_suffix('f').filter(|w| SUFFIXED.contains(w))?;
    let function = SUFFIXED.iter().find(|w| **w == plain)?;
    Some(Foreign {
        language: "C",
        meaning: Function(function),
    })
}

/// Functions that C spells with the suffix `f`.
#[rustfmt::skip]
const SUFFIXED: &[&str] = &[
    "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh",
    "pow", "exp", "exp2", "log", "log2", "sqrt", "floor", "ceil", "round", "trunc", "mix", "clamp",
    "step", "sign",
];

/// Scalar types from which other languages form the names of vectors and matrices.
#[rustfmt::skip]
const SCALARS: &[(&str, &str)] = &[
    ("float", "float"), ("half", "float"), ("fixed", "float"), ("real", "float"), ("double", "float"),
    ("min16float", "float"), ("min10float", "float"), ("packed_float", "float"), ("Vector", "float"),
    ("vector", "float"), ("Vec", "float"), ("Color", "float"), ("int", "int"), ("short", "int"), ("long", "int"),
    ("min16int", "int"), ("uint", "uint"), ("min16uint", "uint"), ("ushort", "uint"), ("bool", "bool"),
];

/// Parses composed type names such as `float3`, `half4x4`, `vec3f` and `Vec3`.
fn foreign_type(word: &str, version: Version) -> Option<(&'static str, &'static str)> {
    let known = |text: &str| match classify(text, version) {
        WordClass::Type(word) => Some(word.name()),
        _ => None,
    };
    let starts_with_digit = |w: &&str| w.starts_with(|c: char| c.is_ascii_digit());
    let rest = word.strip_prefix("vec").or(word.strip_prefix("mat"));
    if let Some(rest) = rest.filter(starts_with_digit) {
        // `vec3f`, `vec3i`, `mat4x4f`
        let (size, suffix) = rest.split_at_checked(rest.len().checked_sub(1)?)?;
        let prefix = match suffix {
            "f" | "h" | "d" => "",
            "i" => "i",
            "u" => "u",
            "b" => "b",
            _ => return None,
        };
        return Some(("WGSL", known(&format!("{prefix}{}{size}", word.get(..3)?))?));
    }
    let digits = word.find(|c: char| c.is_ascii_digit() && c != '1' && c != '0')?;
    if let Some((_, scalar)) = SCALARS
        .iter()
        .find(|(s, _)| {
            word.strip_prefix(s)
                .is_some_and(|r| !r.is_empty() && r.len() <= 3)
        })
        .filter(|(s, _)| s.len() == digits || s.contains('1'))
    {
        let size = word
            .rsplit(|c: char| c.is_ascii_alphabetic() && c != 'x')
            .next()?;
        let prefix = match *scalar {
            "float" => "",
            other => other.get(..1)?,
        };
        let text = match size.split_once('x') {
            // HLSL states rows before columns.
            Some((rows, columns)) => format!("mat{columns}x{rows}"),
            None => format!("{prefix}vec{size}"),
        };
        return Some(("HLSL", known(&text)?));
    }
    None
}

/// The GLSL type that `word` matches if letter case is ignored.
pub fn type_in_another_case(word: &str, version: Version) -> Option<TypeWord> {
    TypeWord::ALL
        .iter()
        .copied()
        .find(|t| t.name().eq_ignore_ascii_case(word))
        .filter(|t| matches!(classify(t.name(), version), WordClass::Type(_)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use shaderlint_text::each_case;

    #[test]
    fn types_of_other_languages_map_to_glsl_types() {
        each_case(include_str!("foreign.txt"), |word, expected| {
            let found = foreign(word, Version::Es300).map(|f| match f.meaning {
                Type(t) | Function(t) | Value(t) | Code(t, _) | Nearly(t, ..) | Statement(t, _) => {
                    t
                }
                _ => "?",
            });
            assert_eq!(found.unwrap_or("none"), expected, "{word}");
        });
    }
}
