//! Exponential functions (GLSL ES 3.00 section 8.2), and the hyperbolic functions based on them.

use super::double::{self, exp2 as power_of_2, log2 as logarithm, narrow, widen};
use super::single::{number, polynomial, round, scale, split, with_sign};
use fearless_simd::{f32x8, f64x8, prelude::*};
use std::f64::consts::{LN_2, LOG2_E};

/// `pow(x, y)`; undefined for negative `x`, where browsers ignore the sign.
#[inline(always)]
pub fn pow<S: Simd>(x: f32x8<S>, y: f32x8<S>) -> f32x8<S> {
    let size = x.abs();
    let power = narrow(power_of_2(widen(y) * logarithm(widen(size))));
    let usual = size.simd_ge(f32::MIN_POSITIVE) & size.simd_lt(f32::INFINITY);
    if usual.all_true() {
        power
    } else {
        usual.select(power, special_power(x, y))
    }
}

/// Powers of numbers that are zero, tiny, infinite or NaN.
#[cold]
#[inline(never)]
fn special_power<S: Simd>(x: f32x8<S>, y: f32x8<S>) -> f32x8<S> {
    x.token().vectorize(
        #[inline(always)]
        || exp2(y * log2(x)),
    )
}

/// `x` between `-limit` and `limit`; NaN stays NaN.
#[inline(always)]
fn limited<S: Simd>(x: f32x8<S>, limit: f32x8<S>) -> f32x8<S> {
    let above = x.simd_lt(-limit).select(-limit, x);
    above.simd_gt(limit).select(limit, above)
}

/// `exp(x)`
#[inline(always)]
pub fn exp<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    // Clamped to the range beyond which the result is 0 or infinite.
    let x = limited(x, number(x, 128.0));
    let (integer, bits) = round(x * std::f32::consts::LOG2_E);
    // The first part of ln 2 has 14 significant bits, so that the product is exact.
    let r = x - integer * LN_2_HIGH - integer * LN_2_LOW;
    let series = [
        0.5,
        1.666_657_6e-1,
        4.166_655_2e-2,
        8.363_233e-3,
        1.392_625e-3,
    ];
    let power = r + r * r * polynomial(r, series) + 1.0;
    scale(power, bits)
}

/// `exp2(x)`
#[inline(always)]
pub fn exp2<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    // Clamped to the range beyond which the result is 0 or infinite.
    let x = limited(x, number(x, 180.0));
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
    scale(r * polynomial(r, series) + 1.0, bits)
}

/// The first 14 bits of ln 2.
const LN_2_HIGH: f32 = 0.693_115_23;
/// The remaining bits of ln 2.
const LN_2_LOW: f32 = 3.194_618_3e-5;

/// `log(x)`; undefined for negative `x`, where browsers ignore the sign, and for 0, which they
/// treat as 2^-127.
#[inline(always)]
pub fn log<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    let (exponent, r) = split(x);
    let small = exponent * LN_2_LOW + after_the_first(r);
    unless_special(x, exponent * LN_2_HIGH + (r + small))
}

/// `log2(x)`; undefined where `log` is.
#[inline(always)]
pub fn log2<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    let (exponent, r) = split(x);
    let small = after_the_first(r);
    // `log2(e) - 1`, so that `r` itself is added without rounding.
    let more = 0.442_695_05;
    unless_special(x, exponent + (r + (small + (r * more + small * more))))
}

/// `log(1 + r) - r`, for `1 + r` between sqrt(1/2) and sqrt(2).
#[inline(always)]
fn after_the_first<S: Simd>(r: f32x8<S>) -> f32x8<S> {
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
    square * r * polynomial(r, series) - square * 0.5
}

/// The result of a logarithm; infinity and NaN are returned unchanged.
#[inline(always)]
fn unless_special<S: Simd>(x: f32x8<S>, found: f32x8<S>) -> f32x8<S> {
    let usual = x.simd_lt(f32::INFINITY);
    usual.select(found, x)
}

/// `sqrt(x)`
#[inline(always)]
pub fn sqrt<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    x.sqrt()
}

/// `inversesqrt(x)`
#[inline(always)]
pub fn inverse_sqrt<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    1.0 / x.sqrt()
}

/// `e^x` in double precision.
#[inline(always)]
fn exp_wide<S: Simd>(x: f64x8<S>) -> f64x8<S> {
    power_of_2(x * LOG2_E)
}

/// The natural logarithm of a positive number, in double precision.
#[inline(always)]
fn log_wide<S: Simd>(x: f64x8<S>) -> f64x8<S> {
    logarithm(x) * LN_2
}

/// The hyperbolic sine of a number of at most 1, where a difference of exponentials would cancel.
#[inline(always)]
fn small_sinh<S: Simd>(x: f64x8<S>) -> f64x8<S> {
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
fn sinh_wide<S: Simd>(x: f64x8<S>) -> f64x8<S> {
    let large = 0.5 * exp_wide(x) - 0.5 * exp_wide(-x);
    x.simd_lt(1.0).select(small_sinh(x), large)
}

/// The hyperbolic cosine.
#[inline(always)]
fn cosh_wide<S: Simd>(x: f64x8<S>) -> f64x8<S> {
    0.5 * exp_wide(x) + 0.5 * exp_wide(-x)
}

/// `sinh(x)`
#[inline(always)]
pub fn sinh<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    with_sign(narrow(sinh_wide(widen(x.abs()))), x)
}

/// `cosh(x)`
#[inline(always)]
pub fn cosh<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    narrow(cosh_wide(widen(x)))
}

/// `tanh(x)`
#[inline(always)]
pub fn tanh<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    let size = widen(x.abs());
    // Beyond this, the nearest float is 1.
    let within = size.simd_gt(20.0).select(double::number(size, 20.0), size);
    with_sign(narrow(sinh_wide(within) / cosh_wide(within)), x)
}

/// `asinh(x)`
#[inline(always)]
pub fn asinh<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    let size = widen(x.abs());
    let large = log_wide(size + (size * size + 1.0).sqrt());
    let result = size.simd_lt(TINY).select(size, large);
    with_sign(keep_special(x.abs(), narrow(result)), x)
}

/// `acosh(x)`; NaN for `x` below 1.
#[inline(always)]
pub fn acosh<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    let wide = widen(x);
    let root = (wide * wide - 1.0).sqrt();
    let result = narrow(log_wide(wide + root));
    let below = x.simd_lt(1.0);
    below.select(number(x, f32::NAN), keep_special(x, result))
}

/// `atanh(x)`; undefined outside -1 to 1, where browsers evaluate the logarithmic formula all the
/// same.
#[inline(always)]
pub fn atanh<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    let size = widen(x.abs());
    let large = 0.5 * log_wide((1.0 + size) / (1.0 - size));
    let result = with_sign(narrow(size.simd_lt(TINY).select(size, large)), x);
    let beyond = 0.5 * log((1.0 + x) / (1.0 - x));
    x.abs().simd_lt(1.0).select(result, beyond)
}

/// Below this, the inverse hyperbolic sine and tangent round to their argument.
const TINY: f64 = 1.0 / 8192.0;

/// Returns infinity and NaN unchanged.
#[inline(always)]
fn keep_special<S: Simd>(x: f32x8<S>, result: f32x8<S>) -> f32x8<S> {
    let finite = x.abs().simd_lt(f32::INFINITY);
    finite.select(result, x)
}
