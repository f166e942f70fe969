//! One program per built-in function; it evaluates the function for random arguments, one set per
//! pixel.

use crate::compute::Computing;
use std::f32::consts::PI;

/// Maximum difference between two implementations.
#[derive(Clone, Copy, Debug)]
pub enum Bound {
    /// The results must be identical.
    Exact,
    /// In units in the last place (ULP).
    Units(f64),
    /// Absolute difference.
    Absolute(f64),
    /// `3 + 2 * |x|` ULP, where `x` is the exponent.
    Power,
    /// 3 ULP or 2^-21, whichever is larger.
    Logarithm,
    /// Derived from the bounds of `exp2` and `log2`.
    PowerOfAny,
}

/// An expression in `a`, `b` and `c`, which are floats from the range, or in `i` and `j`, which are
/// integers with random bits.
pub struct Case {
    /// The evaluated expression: a float, or a value cast to `uint`.
    pub text: &'static str,
    range: [f32; 2],
    pub bound: Bound,
}

const fn case(text: &'static str, low: f32, high: f32, bound: Bound) -> Case {
    Case {
        text,
        range: [low, high],
        bound,
    }
}

use Bound::{Absolute, Exact, Logarithm, Power, PowerOfAny, Units};

/// 2^-11, plus a little for rounding in both implementations.
const SINE: f64 = 1.1 / 2048.0;

/// Bounds from the conformance suite, or from the definition of the function.
pub const CASES: [Case; 82] = [
    case("sin(a)", -PI, PI, Absolute(SINE)),
    case("cos(a)", -PI, PI, Absolute(SINE)),
    case("sin(a)", -100.0, 100.0, Absolute(0.05)),
    case("cos(a)", -100.0, 100.0, Absolute(0.05)),
    case("tan(a)", -0.9, 0.9, Absolute(4.0 * SINE)),
    case("asin(a)", -1.0, 1.0, Absolute(4.0 * SINE)),
    case("acos(a)", -1.0, 1.0, Absolute(4.0 * SINE)),
    case("atan(a)", -30.0, 30.0, Units(4098.0)),
    case("atan(a, b)", -30.0, 30.0, Units(4098.0)),
    case("sinh(a)", -6.0, 6.0, Absolute(1e-3)),
    case("cosh(a)", -6.0, 6.0, Absolute(1e-3)),
    case("tanh(a)", -6.0, 6.0, Absolute(1e-5)),
    case("asinh(a)", -6.0, 6.0, Absolute(1e-5)),
    case("acosh(a)", 1.0, 60.0, Absolute(1e-5)),
    case("atanh(a)", -0.9, 0.9, Absolute(1e-5)),
    case("exp(a)", -30.0, 30.0, Power),
    case("exp2(a)", -30.0, 30.0, Power),
    case("log(a)", 0.001, 4.0, Logarithm),
    case("log(a)", 0.1, 90000.0, Logarithm),
    case("log2(a)", 0.001, 4.0, Logarithm),
    case("log2(a)", 0.1, 90000.0, Logarithm),
    case("pow(a, b)", 0.01, 6.0, PowerOfAny),
    case("sqrt(a)", 0.0, 90000.0, Units(3.0)),
    case("inversesqrt(a)", 0.001, 90000.0, Units(3.0)),
    case("a / b", -90.0, 90.0, Units(2.5)),
    case("abs(a)", -9.0, 9.0, Exact),
    case("sign(a)", -9.0, 9.0, Exact),
    case("floor(a)", -900.0, 900.0, Exact),
    case("ceil(a)", -900.0, 900.0, Exact),
    case("trunc(a)", -900.0, 900.0, Exact),
    case("round(a)", -900.0, 900.0, Exact),
    case("roundEven(floor(a) * 0.5)", -900.0, 900.0, Exact),
    case("fract(a)", -900.0, 900.0, Exact),
    case("floor(a * 1e7)", -900.0, 900.0, Exact),
    case("mod(a, b)", 0.5, 90.0, Absolute(1e-4)),
    case("mod(floor(a), 8.0)", -900.0, 900.0, Exact),
    case("modf(a, b)", -900.0, 900.0, Exact),
    case("min(a, b)", -9.0, 9.0, Exact),
    case("max(a, b)", -9.0, 9.0, Exact),
    case("clamp(a, -2.0, abs(b))", -9.0, 9.0, Exact),
    case("mix(a, b, c)", 0.0, 1.0, Absolute(1e-6)),
    case("mix(a, b, c > 0.0)", -1.0, 1.0, Exact),
    case("step(a, b)", -9.0, 9.0, Exact),
    case("smoothstep(-3.0, 4.0, a)", -9.0, 9.0, Absolute(1e-6)),
    case("radians(a)", -900.0, 900.0, Units(2.5)),
    case("degrees(a)", -900.0, 900.0, Units(2.5)),
    case("length(vec3(a, b, c))", -9.0, 9.0, Units(5.0)),
    case("distance(vec2(a, b), vec2(c, 1.0))", -9.0, 9.0, Units(5.0)),
    case(
        "dot(vec3(a, b, c), vec3(b, c, a))",
        -9.0,
        9.0,
        Absolute(1e-4),
    ),
    case(
        "cross(vec3(a, b, c), vec3(b, c, a)).y",
        -9.0,
        9.0,
        Absolute(1e-4),
    ),
    case("normalize(vec4(a, b, c, 1.0)).z", -9.0, 9.0, Absolute(1e-6)),
    case(
        "faceforward(vec2(a, b), vec2(c, a), vec2(b, c)).y",
        -9.0,
        9.0,
        Exact,
    ),
    case(
        "reflect(vec3(a, b, c), normalize(vec3(b, c, a))).x",
        -9.0,
        9.0,
        Absolute(1e-4),
    ),
    case(
        "refract(normalize(vec3(a, b, c)), normalize(vec3(b, c, a)), 0.7).z",
        -9.0,
        9.0,
        Absolute(1e-4),
    ),
    case(
        "(mat3(a) * mat3(b, c, a, b, c, a, a, c, b))[1][2]",
        -9.0,
        9.0,
        Absolute(1e-4),
    ),
    case("matrixCompMult(mat2(a), mat2(b))[0][0]", -9.0, 9.0, Exact),
    case(
        "outerProduct(vec2(a, b), vec3(c, b, a))[1][0]",
        -9.0,
        9.0,
        Exact,
    ),
    case(
        "transpose(mat3x2(a, b, c, a, b, c))[1][2]",
        -9.0,
        9.0,
        Exact,
    ),
    case("determinant(mat2(a, b, c, a))", -9.0, 9.0, Absolute(1e-4)),
    case(
        "determinant(mat3(a, b, c, b, a, 1, c, 2, a))",
        -9.0,
        9.0,
        Absolute(1e-2),
    ),
    case(
        "determinant(mat4(a, b, c, 1, b, a, 1, c, c, 2, a, b, 1, 2, 3, 4))",
        -9.0,
        9.0,
        Absolute(0.1),
    ),
    case(
        "inverse(mat2(a, b, -b, a + 2.0))[1][0]",
        1.0,
        9.0,
        Absolute(1e-5),
    ),
    case(
        "inverse(mat3(a, b, 0, -b, a, 0, 1, 2, c))[2][1]",
        1.0,
        9.0,
        Absolute(1e-4),
    ),
    case(
        "inverse(mat4(a, b, 0, 0, -b, a, 0, 1, 0, 0, c, 0, 0, 0, 1, 2))[3][1]",
        1.0,
        9.0,
        Absolute(1e-4),
    ),
    case("dFdx(a)", -9.0, 9.0, Exact),
    case("dFdy(a)", -9.0, 9.0, Exact),
    case("fwidth(a)", -9.0, 9.0, Exact),
    case("packHalf2x16(vec2(a, b))", -60000.0, 60000.0, Exact),
    case("packHalf2x16(vec2(a, b))", -1e-4, 1e-4, Exact),
    case("packSnorm2x16(vec2(a, b))", -1.2, 1.2, Exact),
    case("packUnorm2x16(vec2(a, b))", -0.2, 1.2, Exact),
    case("unpackHalf2x16(uint(i) & 0x3bff3bffu).y", 0.0, 1.0, Exact),
    case("unpackSnorm2x16(uint(i)).x", 0.0, 1.0, Units(2.5)),
    case("unpackUnorm2x16(uint(i)).y", 0.0, 1.0, Units(2.5)),
    case("int(a)", -1e9, 1e9, Exact),
    case("uint(a)", 0.0, 4e9, Exact),
    case("float(i)", 0.0, 1.0, Exact),
    case("float(uint(i))", 0.0, 1.0, Units(1.0)),
    case("i / (j >> (j & 31))", 0.0, 1.0, Exact),
    case("uint(i) % (uint(j) >> (j & 31))", 0.0, 1.0, Exact),
    case("(i << j) ^ (j >> i)", 0.0, 1.0, Exact),
    case("uint(i) >> j", 0.0, 1.0, Exact),
];

impl Case {
    /// The program: it outputs the result, `a` and `b`.
    pub fn program(&self) -> Computing {
        let [low, high] = self.range;
        let text = self.text;
        let is_integer = ["pack", "int(", "uint(", "i /", "(i "];
        let is_integer = is_integer.iter().any(|head| text.starts_with(head));
        let cast = if is_integer {
            "uint"
        } else {
            "floatBitsToUint"
        };
        let text = format!(
            "#version 300 es
precision highp float;
precision highp int;
uniform ivec4 seeds;
out highp uvec4 drawn;
uint state;
uint next() {{
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state * 0x9e3779b1u;
}}
float number() {{ return {low:?} + ({high:?} - {low:?}) * (float(next() >> 8) / 16777216.0); }}
void main() {{
    state = uint(gl_FragCoord.x) + 64u * uint(gl_FragCoord.y) + uint(seeds.x);
    next();
    next();
    float a = number(), b = number(), c = number();
    int i = int(next()), j = int(next());
    drawn = uvec4({cast}({text}), floatBitsToUint(a), floatBitsToUint(b), 1);
}}
"
        );
        Computing {
            text,
            seeds: [12345, 0, 0, 0],
            parts: [0.0; 4],
        }
    }

    /// The bound as data: its type and a number.
    pub fn bound(&self) -> (&'static str, f64) {
        match self.bound {
            Exact => ("exact", 0.0),
            Units(n) => ("units", n),
            Absolute(n) => ("absolute", n),
            Power => ("power", 0.0),
            Logarithm => ("logarithm", 0.0),
            PowerOfAny => ("power of any", 0.0),
        }
    }
}
