//! Exponential functions (GLSL ES 3.00 section 8.2), and the hyperbolic functions based on them.

use super::double::{self, exp2 as power_of_2, log2 as logarithm, narrow, widen};
use super::single::{polynomial, round, scale, sign_of, split};
use std::f64::consts::{LN_2, LOG2_E};
use wide::{f32x8, f64x8};

/// `pow(x, y)`; undefined for negative `x`, where browsers ignore the sign.
#[inline]
pub fn pow(x: f32x8, y: f32x8) -> f32x8 {
    let size = x.abs();
    let power = narrow(power_of_2(widen(y) * logarithm(widen(size))));
    let usual =
        size.simd_ge(f32x8::splat(f32::MIN_POSITIVE)) & size.simd_lt(f32x8::splat(f32::INFINITY));
    if usual.all() {
        power
    } else {
        usual.bitselect(power, special_power(x, y))
    }
}

/// Powers of numbers that are zero, tiny, infinite or NaN.
#[cold]
fn special_power(x: f32x8, y: f32x8) -> f32x8 {
    exp2(y * log2(x))
}

/// `x` between `-limit` and `limit`; NaN stays NaN.
#[inline(always)]
fn limited(x: f32x8, limit: f32x8) -> f32x8 {
    let above = x.simd_lt(-limit).bitselect(-limit, x);
    above.simd_gt(limit).bitselect(limit, above)
}

/// `exp(x)`
#[inline]
pub fn exp(x: f32x8) -> f32x8 {
    // Clamped to the range beyond which the result is 0 or infinite.
    let x = limited(x, f32x8::splat(128.0));
    let (integer, bits) = round(x * f32x8::splat(std::f32::consts::LOG2_E));
    // The first part of ln 2 has 14 significant bits, so that the product is exact.
    let r = x - integer * f32x8::splat(LN_2_HIGH) - integer * f32x8::splat(LN_2_LOW);
    let series = [
        0.5,
        1.666_657_6e-1,
        4.166_655_2e-2,
        8.363_233e-3,
        1.392_625e-3,
    ];
    let power = r + r * r * polynomial(r, series) + f32x8::splat(1.0);
    scale(power, bits)
}

/// `exp2(x)`
#[inline]
pub fn exp2(x: f32x8) -> f32x8 {
    // Clamped to the range beyond which the result is 0 or infinite.
    let x = limited(x, f32x8::splat(180.0));
    let (integer, bits) = round(x);
    let r = x - integer;
    let series = [
        6.931_472e-1,
        2.402_265e-1,
        5.550_357e-2,
        9.618_082e-3,
        1.339_097_9e-3,
        1.545_326_2e-4,
    ];
    scale(r * polynomial(r, series) + f32x8::splat(1.0), bits)
}

/// The first 14 bits of ln 2.
const LN_2_HIGH: f32 = 0.693_115_23;
/// The remaining bits of ln 2.
const LN_2_LOW: f32 = 3.194_618_3e-5;

/// `log(x)`; undefined for negative `x`, where browsers ignore the sign, and for 0, which they
/// treat as 2^-127.
#[inline]
pub fn log(x: f32x8) -> f32x8 {
    let (exponent, r) = split(x);
    let small = exponent * f32x8::splat(LN_2_LOW) + after_the_first(r);
    unless_special(x, exponent * f32x8::splat(LN_2_HIGH) + (r + small))
}

/// `log2(x)`; undefined where `log` is.
#[inline]
pub fn log2(x: f32x8) -> f32x8 {
    let (exponent, r) = split(x);
    let small = after_the_first(r);
    // `log2(e) - 1`, so that `r` itself is added without rounding.
    let more = f32x8::splat(0.442_695_05);
    unless_special(x, exponent + (r + (small + (r * more + small * more))))
}

/// `log(1 + r) - r`, for `1 + r` between sqrt(1/2) and sqrt(2).
#[inline(always)]
fn after_the_first(r: f32x8) -> f32x8 {
    let series = [
        3.333_333e-1,
        -2.499_999_7e-1,
        2.000_072e-1,
        -1.666_781e-1,
        1.424_887_6e-1,
        -1.242_536e-1,
        1.168_702_5e-1,
        -1.148_308_2e-1,
        6.971_346_6e-2,
    ];
    let square = r * r;
    square * r * polynomial(r, series) - square * f32x8::splat(0.5)
}

/// The result of a logarithm; infinity and NaN are returned unchanged.
#[inline(always)]
fn unless_special(x: f32x8, found: f32x8) -> f32x8 {
    let usual = x.simd_lt(f32x8::splat(f32::INFINITY));
    usual.bitselect(found, x)
}

/// `sqrt(x)`
#[inline(always)]
pub fn sqrt(x: f32x8) -> f32x8 {
    x.sqrt()
}

/// `inversesqrt(x)`
#[inline(always)]
pub fn inverse_sqrt(x: f32x8) -> f32x8 {
    f32x8::splat(1.0) / x.sqrt()
}

/// `e^x` in double precision.
#[inline(always)]
fn exp_wide(x: f64x8) -> f64x8 {
    power_of_2(x * f64x8::splat(LOG2_E))
}

/// The natural logarithm of a positive number, in double precision.
#[inline(always)]
fn log_wide(x: f64x8) -> f64x8 {
    logarithm(x) * f64x8::splat(LN_2)
}

/// The hyperbolic sine of a number of at most 1, where a difference of exponentials would cancel.
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
    x + x * square * double::polynomial(square, series)
}

/// The hyperbolic sine of a non-negative number.
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
pub fn sinh(x: f32x8) -> f32x8 {
    narrow(sinh_wide(widen(x.abs()))) | sign_of(x)
}

/// `cosh(x)`
#[inline]
pub fn cosh(x: f32x8) -> f32x8 {
    narrow(cosh_wide(widen(x)))
}

/// `tanh(x)`
#[inline]
pub fn tanh(x: f32x8) -> f32x8 {
    let size = widen(x.abs());
    // Beyond this, the nearest float is 1.
    let within = size
        .simd_gt(f64x8::splat(20.0))
        .bitselect(f64x8::splat(20.0), size);
    narrow(sinh_wide(within) / cosh_wide(within)) | sign_of(x)
}

/// `asinh(x)`
#[inline]
pub fn asinh(x: f32x8) -> f32x8 {
    let size = widen(x.abs());
    let large = log_wide(size + (size * size + f64x8::splat(1.0)).sqrt());
    let result = size.simd_lt(f64x8::splat(TINY)).bitselect(size, large);
    (keep_special(x.abs(), narrow(result))) | sign_of(x)
}

/// `acosh(x)`; NaN for `x` below 1.
#[inline]
pub fn acosh(x: f32x8) -> f32x8 {
    let wide = widen(x);
    let root = (wide * wide - f64x8::splat(1.0)).sqrt();
    let result = narrow(log_wide(wide + root));
    let below = x.simd_lt(f32x8::splat(1.0));
    below.bitselect(f32x8::splat(f32::NAN), keep_special(x, result))
}

/// `atanh(x)`; undefined outside -1 to 1, where browsers evaluate the logarithmic formula all the
/// same.
#[inline]
pub fn atanh(x: f32x8) -> f32x8 {
    let (one, size) = (f64x8::splat(1.0), widen(x.abs()));
    let large = f64x8::splat(0.5) * log_wide((one + size) / (one - size));
    let result = narrow(size.simd_lt(f64x8::splat(TINY)).bitselect(size, large)) | sign_of(x);
    let one = f32x8::splat(1.0);
    let beyond = f32x8::splat(0.5) * log((one + x) / (one - x));
    x.abs().simd_lt(one).bitselect(result, beyond)
}

/// Below this, the inverse hyperbolic sine and tangent round to their argument.
const TINY: f64 = 1.0 / 8192.0;

/// Returns infinity and NaN unchanged.
#[inline(always)]
fn keep_special(x: f32x8, result: f32x8) -> f32x8 {
    let finite = x.abs().simd_lt(f32x8::splat(f32::INFINITY));
    finite.bitselect(result, x)
}
