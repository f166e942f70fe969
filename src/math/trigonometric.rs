//! Angle and trigonometric functions (GLSL ES 3.00 section 8.1).
//!
//! Common cases are computed in single precision; large angles and extreme ratios in double
//! precision.

use super::large;
use super::single::{flipped, number, polynomial, round, with_sign};
use fearless_simd::{f32x8, mask32x8, prelude::*, u32x8};
use std::f32::consts::{FRAC_2_PI, FRAC_PI_2, FRAC_PI_4, PI};

/// From this magnitude on, the four-part reduction by pi/2 is not precise enough.
const LARGE: f32 = 8192.0;

/// pi/2 as a sum: three parts with few enough significant bits that their products with integers
/// below 2^13 are exact, and the rest.
const QUARTER: [f32; 4] = [1.570_312_5, 4.837_513e-4, 7.549_533_6e-8, 2.563_344e-12];

/// Range reduction of an angle below [`LARGE`]: the remainder after subtracting quarter turns
/// (multiples of pi/2), at most pi/4 in magnitude, and a number whose low bits are the number of
/// quarter turns.
#[inline(always)]
fn reduce<S: Simd>(x: f32x8<S>) -> (f32x8<S>, u32x8<S>) {
    let (integer, quarters) = round(x * FRAC_2_PI);
    let mut rest = x;
    for part in QUARTER {
        rest -= integer * part;
    }
    (rest, quarters)
}

/// Sine and cosine of an angle of at most pi/4.
#[inline(always)]
fn sine_cosine<S: Simd>(x: f32x8<S>) -> (f32x8<S>, f32x8<S>) {
    let square = x * x;
    let series = [-1.666_666_4e-1, 8.332_747e-3, -1.958_763_9e-4];
    let sine = x + x * square * polynomial(square, series);
    let series = [4.166_666_4e-2, -1.388_830_1e-3, 2.454_769e-5];
    let half = 1.0 - square * 0.5;
    (sine, half + square * square * polynomial(square, series))
}

/// Where a number is odd.
#[inline(always)]
fn is_odd<S: Simd>(quarters: u32x8<S>) -> mask32x8<S> {
    (quarters & 1).simd_eq(1)
}

/// The sine of an angle plus a number of quarter turns.
#[inline(always)]
fn sine_and<S: Simd>(x: f32x8<S>, more: u32) -> f32x8<S> {
    let (rest, quarters) = reduce(x);
    let quarters = quarters + more;
    let (sine, cosine) = sine_cosine(rest);
    let negative = (quarters & 2) << 30;
    let found = flipped(is_odd(quarters).select(cosine, sine), negative);
    let small = x.abs().simd_lt(LARGE);
    if small.all_true() {
        found
    } else {
        small.select(found, large::sine_and(x, more))
    }
}

/// `sin(x)`
#[inline(always)]
pub fn sin<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    sine_and(x, 0)
}

/// `cos(x)`
#[inline(always)]
pub fn cos<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    sine_and(x, 1)
}

/// `tan(x)`
#[inline(always)]
pub fn tan<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    let (rest, quarters) = reduce(x);
    let (sine, cosine) = sine_cosine(rest);
    let odd = is_odd(quarters);
    let found = odd.select(-cosine, sine) / odd.select(sine, cosine);
    let small = x.abs().simd_lt(LARGE);
    if small.all_true() {
        found
    } else {
        small.select(found, large::tan(x))
    }
}

/// The arc sine of a number of at most 1/2, given with its square.
#[inline(always)]
fn small_asin<S: Simd>(x: f32x8<S>, square: f32x8<S>) -> f32x8<S> {
    let series = [
        1.666_667_3e-1,
        7.498_853e-2,
        4.500_189_4e-2,
        2.655_066_2e-2,
        3.809_396e-2,
    ];
    x + x * square * polynomial(square, series)
}

/// For magnitudes up to 1/2 the arc sine, above that half the arc cosine; and a mask of the latter.
#[inline(always)]
fn arc<S: Simd>(size: f32x8<S>) -> (f32x8<S>, mask32x8<S>) {
    let above = size.simd_gt(0.5);
    let square = above.select((1.0 - size) * 0.5, size * size);
    let x = above.select(square.sqrt(), size);
    (small_asin(x, square), above)
}

/// `asin(x)`; NaN outside -1 to 1.
#[inline(always)]
pub fn asin<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    let (angle, above) = arc(x.abs());
    let angle = above.select(FRAC_PI_2 - (angle + angle), angle);
    with_sign(angle, x)
}

/// `acos(x)`; NaN outside -1 to 1.
#[inline(always)]
pub fn acos<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    let (angle, above) = arc(x.abs());
    let near = above.select(angle + angle, FRAC_PI_2 - angle);
    let far = above.select(PI - (angle + angle), FRAC_PI_2 + angle);
    x.simd_lt(0.0).select(far, near)
}

/// tan(pi/8) and tan(3pi/8), where the range reduction of `atan` switches.
const OCTANT_TANGENTS: [f32; 2] = [0.414_213_57, 2.414_213_7];

/// The arc tangent of a number of at most tan(pi/8).
#[inline(always)]
fn small_atan<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    let square = x * x;
    let series = [
        -3.333_333e-1,
        1.999_953_8e-1,
        -1.426_389_7e-1,
        1.074_31e-1,
        -6.449_835e-2,
    ];
    x + x * square * polynomial(square, series)
}

/// `atan(y_over_x)`
#[inline(always)]
pub fn atan<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    let (one, size) = (number(x, 1.0), x.abs());
    let [middle, large] = OCTANT_TANGENTS.map(|tangent| size.simd_gt(tangent));
    let above = large.select(-one, middle.select(size - one, size));
    let below = large.select(size, middle.select(size + one, one));
    let from = middle.select(number(x, FRAC_PI_4), number(x, 0.0));
    let from = large.select(number(x, FRAC_PI_2), from);
    with_sign(from + small_atan(above / below), x)
}

/// `atan(y, x)`; undefined if both are 0, where browsers return 0.
#[inline(always)]
pub fn atan2<S: Simd>(y: f32x8<S>, x: f32x8<S>) -> f32x8<S> {
    let (height, width) = (y.abs(), x.abs());
    let steep = height.simd_gt(width);
    let (short, long) = (steep.select(width, height), steep.select(height, width));
    let middle = short.simd_gt(long * OCTANT_TANGENTS[0]);
    let above = middle.select(short - long, short);
    let below = middle.select(short + long, long);
    let from = middle.select(number(x, FRAC_PI_4), number(x, 0.0));
    let angle = from + small_atan(above / below);
    let angle = steep.select(FRAC_PI_2 - angle, angle);
    let left = x.is_sign_negative();
    let angle = with_sign(left.select(PI - angle, angle), y);
    // Otherwise, the ratio is undefined or not representable as a float.
    let usual = long.simd_gt(1e-30) & long.simd_lt(1e30);
    if usual.all_true() {
        angle
    } else {
        usual.select(angle, large::atan2(y, x))
    }
}
