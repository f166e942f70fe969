//! The built-in functions of eight lanes, computed the same way on every machine.
//!
//! What the language leaves undefined is what the browser makes of it.

mod common;
mod double;
mod exponential;
mod inexact;
mod integer;
mod large;
mod packing;
mod single;
mod trigonometric;

pub(super) use common::{
    ceil, floor, fract, max, min, mix, modulo, round_even, sign, smoothstep, step, trunc,
};
pub(super) use exponential::{
    acosh, asinh, atanh, cosh, exp, exp2, inverse_sqrt, log, log2, pow, sinh, sqrt, tanh,
};
pub(super) use inexact::off;
pub(super) use integer::{
    divide_int, divide_uint, float_of_int, float_of_uint, int_of_float, remainder_int,
    remainder_uint, shift_left, shift_right_int, shift_right_uint, uint_of_float,
};
pub(super) use packing::{
    pack_half, pack_snorm, pack_unorm, unpack_half, unpack_snorm, unpack_unorm,
};
pub(super) use trigonometric::{acos, asin, atan, atan2, cos, sin, tan};

use wide::f32x8;

/// All bits set.
const ALL: f32x8 = f32x8::new([f32::from_bits(u32::MAX); 8]);

/// The signs alone, to be put on what has none.
#[inline(always)]
fn sign_of(x: f32x8) -> f32x8 {
    x & f32x8::splat(-0.0)
}

#[cfg(test)]
mod tests;
