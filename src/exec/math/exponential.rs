//! Powers, logarithms and roots (GLSL ES 3.00 section 8.2), and the hyperbolic functions, which are
//! made of them.

use super::double::{exp2 as power_of_2, log2 as logarithm, narrow, polynomial, widen};
use super::sign_of;
use std::f64::consts::{LN_2, LOG2_E};
use wide::{f32x8, f64x8};

/// `pow(x, y)`; no number below 0, where the base has no logarithm. It is 1 of 0 and 0.
#[inline]
pub(in crate::exec) fn pow(x: f32x8, y: f32x8) -> f32x8 {
    let power = narrow(power_of_2(widen(y) * log2_wide(x)));
    let nothing = (x.abs() | y.abs()).simd_eq(f32x8::ZERO);
    nothing.bitselect(f32x8::splat(1.0), power)
}

/// `exp(x)`
#[inline]
pub(in crate::exec) fn exp(x: f32x8) -> f32x8 {
    narrow(power_of_2(widen(x) * f64x8::splat(LOG2_E)))
}

/// `exp2(x)`
#[inline]
pub(in crate::exec) fn exp2(x: f32x8) -> f32x8 {
    narrow(power_of_2(widen(x)))
}

/// `log(x)`
#[inline]
pub(in crate::exec) fn log(x: f32x8) -> f32x8 {
    narrow(log2_wide(x) * f64x8::splat(LN_2))
}

/// `log2(x)`
#[inline]
pub(in crate::exec) fn log2(x: f32x8) -> f32x8 {
    narrow(log2_wide(x))
}

/// The logarithm to base 2 of any number: of 0 negative infinity, below it no number.
#[inline(always)]
fn log2_wide(x: f32x8) -> f64x8 {
    let x = widen(x);
    let infinite = f64x8::splat(f64::INFINITY);
    let special = x.simd_eq(f64x8::ZERO).bitselect(
        -infinite,
        // Infinity and NaN stay, a negative number becomes NaN.
        x.simd_lt(f64x8::ZERO).bitselect(f64x8::splat(f64::NAN), x),
    );
    let usual = x.simd_gt(f64x8::ZERO) & x.simd_lt(infinite);
    usual.bitselect(logarithm(x), special)
}

/// `sqrt(x)`
#[inline(always)]
pub(in crate::exec) fn sqrt(x: f32x8) -> f32x8 {
    x.sqrt()
}

/// `inversesqrt(x)`
#[inline(always)]
pub(in crate::exec) fn inverse_sqrt(x: f32x8) -> f32x8 {
    f32x8::splat(1.0) / x.sqrt()
}

/// `e^x` with the digits of a double.
#[inline(always)]
fn exp_wide(x: f64x8) -> f64x8 {
    power_of_2(x * f64x8::splat(LOG2_E))
}

/// The natural logarithm of what is above 0.
#[inline(always)]
fn log_wide(x: f64x8) -> f64x8 {
    logarithm(x) * f64x8::splat(LN_2)
}

/// The hyperbolic sine of at most 1, which a difference of powers would lose.
#[inline(always)]
fn small_sinh(x: f64x8) -> f64x8 {
    let square = x * x;
    let series = [
        1.0 / 6.0,
        1.0 / 120.0,
        1.0 / 5040.0,
        1.0 / 362_880.0,
        1.0 / 39_916_800.0,
    ];
    x + x * square * polynomial(square, series)
}

/// The hyperbolic sine of what is at least 0.
#[inline(always)]
fn sinh_wide(x: f64x8) -> f64x8 {
    let half = f64x8::splat(0.5);
    let large = half * exp_wide(x) - half * exp_wide(-x);
    x.simd_lt(f64x8::splat(1.0)).bitselect(small_sinh(x), large)
}

/// The hyperbolic cosine.
#[inline(always)]
fn cosh_wide(x: f64x8) -> f64x8 {
    let half = f64x8::splat(0.5);
    half * exp_wide(x) + half * exp_wide(-x)
}

/// `sinh(x)`
#[inline]
pub(in crate::exec) fn sinh(x: f32x8) -> f32x8 {
    narrow(sinh_wide(widen(x.abs()))) | sign_of(x)
}

/// `cosh(x)`
#[inline]
pub(in crate::exec) fn cosh(x: f32x8) -> f32x8 {
    narrow(cosh_wide(widen(x)))
}

/// `tanh(x)`
#[inline]
pub(in crate::exec) fn tanh(x: f32x8) -> f32x8 {
    let size = widen(x.abs());
    // Above, the nearest float is 1.
    let within = size
        .simd_gt(f64x8::splat(20.0))
        .bitselect(f64x8::splat(20.0), size);
    narrow(sinh_wide(within) / cosh_wide(within)) | sign_of(x)
}

/// `asinh(x)`
#[inline]
pub(in crate::exec) fn asinh(x: f32x8) -> f32x8 {
    let size = widen(x.abs());
    let large = log_wide(size + (size * size + f64x8::splat(1.0)).sqrt());
    let result = size.simd_lt(f64x8::splat(TINY)).bitselect(size, large);
    (keep_special(x.abs(), narrow(result))) | sign_of(x)
}

/// `acosh(x)`; no number below 1.
#[inline]
pub(in crate::exec) fn acosh(x: f32x8) -> f32x8 {
    let wide = widen(x);
    let root = (wide * wide - f64x8::splat(1.0)).sqrt();
    let result = narrow(log_wide(wide + root));
    let below = x.simd_lt(f32x8::splat(1.0));
    below.bitselect(f32x8::splat(f32::NAN), keep_special(x, result))
}

/// `atanh(x)`; no number outside of -1 to 1.
#[inline]
pub(in crate::exec) fn atanh(x: f32x8) -> f32x8 {
    let (one, size) = (f64x8::splat(1.0), widen(x.abs()));
    let large = f64x8::splat(0.5) * log_wide((one + size) / (one - size));
    let result = narrow(size.simd_lt(f64x8::splat(TINY)).bitselect(size, large));
    let end = x.abs().simd_eq(f32x8::splat(1.0));
    let beyond = x.abs().simd_gt(f32x8::splat(1.0));
    let result = end.bitselect(f32x8::splat(f32::INFINITY), result);
    let result = beyond.bitselect(f32x8::splat(f32::NAN), result);
    x.is_nan().bitselect(x, result | sign_of(x))
}

/// Below, a number is the nearest float to its inverse hyperbolic sine and tangent.
const TINY: f64 = 1.0 / 8192.0;

/// Infinity and NaN stay as they are.
#[inline(always)]
fn keep_special(x: f32x8, result: f32x8) -> f32x8 {
    let finite = x.abs().simd_lt(f32x8::splat(f32::INFINITY));
    finite.bitselect(result, x)
}
