//! Deterministic implementations of the built-in functions, for eight numbers at a time (SIMD):
//! used for constant folding and by the VM. Also a hash for pseudo-random numbers.
//!
//! Where the specification leaves a result undefined, it is what browsers compute. The functions are
//! inlined into their callers, which choose the instructions.

mod common;
mod double;
mod exponential;
mod hash;
mod integer;
mod lanes;
mod large;
mod level;
mod packing;
mod sine;
mod single;
mod trigonometric;

pub use common::{
    ceil, floor, fract, max, max_number, min, min_number, mix, modulo, round_even, sign,
    smoothstep, step, trunc,
};
pub use exponential::{
    acosh, asinh, atanh, cosh, exp, exp2, inverse_sqrt, log, log2, pow, sinh, sqrt, tanh,
};
pub use hash::hash;
pub use integer::{
    divide_int, divide_uint, float_of_int, float_of_uint, int_of_float, remainder_int,
    remainder_uint, shift_left, shift_right_int, shift_right_uint, uint_of_float,
};
pub use level::{Baseline, Faster, baseline, faster};
pub use packing::{
    bits_of, half_bits, half_value, pack_half, pack_snorm, pack_unorm, unpack_half, unpack_snorm,
    unpack_unorm,
};
pub use sine::sine;
pub use trigonometric::{acos, asin, atan, atan2, cos, sin, tan};

use fearless_simd::{SimdBase, f32x8};

/// Evaluates a SIMD function for one number.
pub fn of_one(f: impl Fn(f32x8<Baseline>) -> f32x8<Baseline>, x: f32) -> f32 {
    let [first, ..]: [f32; 8] = f(f32x8::splat(baseline(), x)).into();
    first
}

/// Evaluates a SIMD function of two operands for one pair of numbers.
pub fn of_two(
    f: impl Fn(f32x8<Baseline>, f32x8<Baseline>) -> f32x8<Baseline>,
    x: f32,
    y: f32,
) -> f32 {
    of_one(|x| f(x, f32x8::splat(baseline(), y)), x)
}

#[cfg(test)]
mod tests;
