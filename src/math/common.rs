//! Common functions (GLSL ES 3.00 section 8.3).

use super::single::{number, with_sign};
use fearless_simd::{f32x8, i32x8, mask32x8, prelude::*};

/// From this magnitude on, every float is an integer.
const FIRST_INTEGERS_ONLY: f32 = 8_388_608.0;

/// Whether there are instructions that round to integers. Known to the compiler.
#[inline(always)]
fn rounds<S: Simd>(simd: S) -> bool {
    #[cfg(target_arch = "x86_64")]
    return !matches!(simd.level(), fearless_simd::Level::Sse2(_));
    #[cfg(not(target_arch = "x86_64"))]
    return !simd.level().is_fallback();
}

/// `trunc(x)`
#[inline(always)]
pub fn trunc<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    if rounds(x.token()) {
        return x.trunc();
    }
    let small = x.abs().simd_lt(FIRST_INTEGERS_ONLY);
    let integer: f32x8<S> = f32x8::float_from(i32x8::truncate_from(x));
    small.select(with_sign(integer, x), x)
}

/// `floor(x)`
#[inline(always)]
pub fn floor<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    if rounds(x.token()) {
        return x.floor();
    }
    let integer = trunc(x);
    integer - one_where(integer.simd_gt(x))
}

/// `ceil(x)`
#[inline(always)]
pub fn ceil<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    -floor(-x)
}

/// `roundEven(x)` and `round(x)`; the latter may round halves either way.
#[inline(always)]
pub fn round_even<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    let small = x.abs().simd_lt(FIRST_INTEGERS_ONLY);
    let rounder = with_sign(number(x, FIRST_INTEGERS_ONLY), x);
    let integer = with_sign((x + rounder) - rounder, x);
    small.select(integer, x)
}

/// `fract(x)`; less than 1 even for tiny negative numbers, where the difference rounds to 1, and for
/// NaN and infinity, as in Chromium.
#[inline(always)]
pub fn fract<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    min(x - floor(x), number(x, 1.0_f32.next_down()))
}

/// `mod(x, y)`
#[inline(always)]
pub fn modulo<S: Simd>(x: f32x8<S>, y: f32x8<S>) -> f32x8<S> {
    x - y * floor(x / y)
}

/// 1 where a mask is set, else 0.
#[inline(always)]
fn one_where<S: Simd>(mask: mask32x8<S>) -> f32x8<S> {
    let simd = mask.token();
    mask.select(f32x8::splat(simd, 1.0), f32x8::splat(simd, 0.0))
}

/// `sign(x)`
#[inline(always)]
pub fn sign<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    one_where(x.simd_gt(0.0)) - one_where(x.simd_lt(0.0))
}

/// `min(x, y)`: `x < y ? x : y`, thus `y` if one of them is NaN, as in Chromium on a CPU. GLSL leaves
/// this open; GPUs do as [`min_number`].
#[inline(always)]
pub fn min<S: Simd>(x: f32x8<S>, y: f32x8<S>) -> f32x8<S> {
    x.simd_lt(y).select(x, y)
}

/// `max(x, y)`: `x > y ? x : y`, thus `y` if one of them is NaN, as for [`min`].
#[inline(always)]
pub fn max<S: Simd>(x: f32x8<S>, y: f32x8<S>) -> f32x8<S> {
    x.simd_gt(y).select(x, y)
}

/// `min(x, y)` as the instruction of GPUs: the other operand if one is NaN (`minNum` of IEEE 754-2008).
#[inline(always)]
pub fn min_number<S: Simd>(x: f32x8<S>, y: f32x8<S>) -> f32x8<S> {
    (x.simd_lt(y) | y.is_nan()).select(x, y)
}

/// `max(x, y)` as the instruction of GPUs, as for [`min_number`].
#[inline(always)]
pub fn max_number<S: Simd>(x: f32x8<S>, y: f32x8<S>) -> f32x8<S> {
    (x.simd_gt(y) | y.is_nan()).select(x, y)
}

/// `clamp(x, low, high)`; `low` if `x` is NaN, unless `high` is less.
#[inline(always)]
pub fn clamp<S: Simd>(x: f32x8<S>, low: f32x8<S>, high: f32x8<S>) -> f32x8<S> {
    min(max(x, low), high)
}

/// `step(edge, x)`
#[inline(always)]
pub fn step<S: Simd>(edge: f32x8<S>, x: f32x8<S>) -> f32x8<S> {
    one_where(x.simd_ge(edge))
}

/// `smoothstep(low, high, x)`
#[inline(always)]
pub fn smoothstep<S: Simd>(low: f32x8<S>, high: f32x8<S>, x: f32x8<S>) -> f32x8<S> {
    let t = (x - low) / (high - low);
    let t = clamp(t, number(t, 0.0), number(t, 1.0));
    t * t * (3.0 - (t + t))
}

/// `mix(x, y, a)`
#[inline(always)]
pub fn mix<S: Simd>(x: f32x8<S>, y: f32x8<S>, a: f32x8<S>) -> f32x8<S> {
    (y - x) * a + x
}
