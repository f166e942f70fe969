//! Common functions (GLSL ES 3.00 section 8.3).

use super::single::sign_of;
use wide::f32x8;

/// From this magnitude on, every float is an integer.
const FIRST_INTEGERS_ONLY: f32 = 8_388_608.0;

/// `trunc(x)`
#[inline(always)]
pub fn trunc(x: f32x8) -> f32x8 {
    let small = x.abs().simd_lt(f32x8::splat(FIRST_INTEGERS_ONLY));
    let integer = f32x8::from_i32x8(x.fast_trunc_int()) | sign_of(x);
    small.bitselect(integer, x)
}

/// `floor(x)`
#[inline(always)]
pub fn floor(x: f32x8) -> f32x8 {
    let integer = trunc(x);
    integer - (integer.simd_gt(x) & f32x8::splat(1.0))
}

/// `ceil(x)`
#[inline(always)]
pub fn ceil(x: f32x8) -> f32x8 {
    -floor(-x)
}

/// `roundEven(x)` and `round(x)`; the latter may round halves either way.
#[inline(always)]
pub fn round_even(x: f32x8) -> f32x8 {
    let small = x.abs().simd_lt(f32x8::splat(FIRST_INTEGERS_ONLY));
    let rounder = f32x8::splat(FIRST_INTEGERS_ONLY) | sign_of(x);
    let integer = ((x + rounder) - rounder) | sign_of(x);
    small.bitselect(integer, x)
}

/// `fract(x)`; less than 1 even for tiny negative numbers, where the difference rounds to 1, and for
/// NaN and infinity, as in Chromium.
#[inline(always)]
pub fn fract(x: f32x8) -> f32x8 {
    min(x - floor(x), f32x8::splat(1.0_f32.next_down()))
}

/// `mod(x, y)`
#[inline(always)]
pub fn modulo(x: f32x8, y: f32x8) -> f32x8 {
    x - y * floor(x / y)
}

/// `sign(x)`
#[inline(always)]
pub fn sign(x: f32x8) -> f32x8 {
    let one = f32x8::splat(1.0);
    let above = x.simd_gt(f32x8::ZERO) & one;
    let below = x.simd_lt(f32x8::ZERO) & one;
    above - below
}

/// `min(x, y)`: `x < y ? x : y`, thus `y` if one of them is NaN, as in Chromium on a CPU. GLSL leaves
/// this open; GPUs do as [`min_number`].
#[inline(always)]
pub fn min(x: f32x8, y: f32x8) -> f32x8 {
    x.simd_lt(y).bitselect(x, y)
}

/// `max(x, y)`: `x > y ? x : y`, thus `y` if one of them is NaN, as for [`min`].
#[inline(always)]
pub fn max(x: f32x8, y: f32x8) -> f32x8 {
    x.simd_gt(y).bitselect(x, y)
}

/// `min(x, y)` as the instruction of GPUs: the other operand if one is NaN (`minNum` of IEEE 754-2008).
#[inline(always)]
pub fn min_number(x: f32x8, y: f32x8) -> f32x8 {
    (x.simd_lt(y) | y.simd_ne(y)).bitselect(x, y)
}

/// `max(x, y)` as the instruction of GPUs, as for [`min_number`].
#[inline(always)]
pub fn max_number(x: f32x8, y: f32x8) -> f32x8 {
    (x.simd_gt(y) | y.simd_ne(y)).bitselect(x, y)
}

/// `clamp(x, low, high)`; `low` if `x` is NaN, unless `high` is less.
#[inline(always)]
pub fn clamp(x: f32x8, low: f32x8, high: f32x8) -> f32x8 {
    min(max(x, low), high)
}

/// `step(edge, x)`
#[inline(always)]
pub fn step(edge: f32x8, x: f32x8) -> f32x8 {
    x.simd_ge(edge) & f32x8::splat(1.0)
}

/// `smoothstep(low, high, x)`
#[inline(always)]
pub fn smoothstep(low: f32x8, high: f32x8, x: f32x8) -> f32x8 {
    let t = (x - low) / (high - low);
    let t = clamp(t, f32x8::ZERO, f32x8::splat(1.0));
    t * t * (f32x8::splat(3.0) - (t + t))
}

/// `mix(x, y, a)`
#[inline(always)]
pub fn mix(x: f32x8, y: f32x8, a: f32x8) -> f32x8 {
    (y - x) * a + x
}
