//! Angle and trigonometric functions (GLSL ES 3.00 section 8.1).
//!
//! Common cases are computed in single precision; large angles and extreme ratios in double
//! precision.

use super::large;
use super::single::{polynomial, round, sign_of};
use std::f32::consts::{FRAC_2_PI, FRAC_PI_2, FRAC_PI_4, PI};
use wide::{f32x8, u32x8};

/// From this magnitude on, the four-part reduction by pi/2 is not precise enough.
const LARGE: f32 = 8192.0;

/// pi/2 as a sum: three parts with few enough significant bits that their products with integers
/// below 2^13 are exact, and the rest.
const QUARTER: [f32; 4] = [1.570_312_5, 4.837_513e-4, 7.549_533_6e-8, 2.563_344e-12];

/// Range reduction of an angle below [`LARGE`]: the remainder after subtracting quarter turns
/// (multiples of pi/2), at most pi/4 in magnitude, and a number whose low bits are the number of
/// quarter turns.
#[inline(always)]
fn reduce(x: f32x8) -> (f32x8, u32x8) {
    let (integer, quarters) = round(x * f32x8::splat(FRAC_2_PI));
    let mut rest = x;
    for part in QUARTER {
        rest -= integer * f32x8::splat(part);
    }
    (rest, quarters)
}

/// Sine and cosine of an angle of at most pi/4.
#[inline(always)]
fn sine_cosine(x: f32x8) -> (f32x8, f32x8) {
    let square = x * x;
    let series = [-1.666_666_4e-1, 8.332_747e-3, -1.958_763_9e-4];
    let sine = x + x * square * polynomial(square, series);
    let series = [4.166_666_4e-2, -1.388_830_1e-3, 2.454_769e-5];
    let half = f32x8::splat(1.0) - square * f32x8::splat(0.5);
    (sine, half + square * square * polynomial(square, series))
}

/// All bits set where a number is odd, none where it is even.
#[inline(always)]
fn is_odd(quarters: u32x8) -> f32x8 {
    let bit = quarters & u32x8::splat(1);
    bytemuck::cast(u32x8::ZERO - bit)
}

/// The sine of an angle plus a number of quarter turns.
#[inline(always)]
fn sine_and(x: f32x8, more: u32) -> f32x8 {
    let (rest, quarters) = reduce(x);
    let quarters = quarters + u32x8::splat(more);
    let (sine, cosine) = sine_cosine(rest);
    let negative: f32x8 = bytemuck::cast((quarters & u32x8::splat(2)) << 30_u32);
    let found = is_odd(quarters).bitselect(cosine, sine) ^ negative;
    let small = x.abs().simd_lt(f32x8::splat(LARGE));
    if small.all() {
        found
    } else {
        small.bitselect(found, large::sine_and(x, more))
    }
}

/// `sin(x)`
#[inline]
pub fn sin(x: f32x8) -> f32x8 {
    sine_and(x, 0)
}

/// `cos(x)`
#[inline]
pub fn cos(x: f32x8) -> f32x8 {
    sine_and(x, 1)
}

/// `tan(x)`
#[inline]
pub fn tan(x: f32x8) -> f32x8 {
    let (rest, quarters) = reduce(x);
    let (sine, cosine) = sine_cosine(rest);
    let odd = is_odd(quarters);
    let found = odd.bitselect(-cosine, sine) / odd.bitselect(sine, cosine);
    let small = x.abs().simd_lt(f32x8::splat(LARGE));
    if small.all() {
        found
    } else {
        small.bitselect(found, large::tan(x))
    }
}

/// The arc sine of a number of at most 1/2, given with its square.
#[inline(always)]
fn small_asin(x: f32x8, square: f32x8) -> f32x8 {
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
fn arc(size: f32x8) -> (f32x8, f32x8) {
    let (half, one) = (f32x8::splat(0.5), f32x8::splat(1.0));
    let above = size.simd_gt(half);
    let square = above.bitselect((one - size) * half, size * size);
    let x = above.bitselect(square.sqrt(), size);
    (small_asin(x, square), above)
}

/// `asin(x)`; NaN outside -1 to 1.
#[inline]
pub fn asin(x: f32x8) -> f32x8 {
    let (angle, above) = arc(x.abs());
    let angle = above.bitselect(f32x8::splat(FRAC_PI_2) - (angle + angle), angle);
    angle | sign_of(x)
}

/// `acos(x)`; NaN outside -1 to 1.
#[inline]
pub fn acos(x: f32x8) -> f32x8 {
    let (angle, above) = arc(x.abs());
    let near = above.bitselect(angle + angle, f32x8::splat(FRAC_PI_2) - angle);
    let far = above.bitselect(
        f32x8::splat(PI) - (angle + angle),
        f32x8::splat(FRAC_PI_2) + angle,
    );
    x.simd_lt(f32x8::ZERO).bitselect(far, near)
}

/// tan(pi/8) and tan(3pi/8), where the range reduction of `atan` switches.
const OCTANT_TANGENTS: [f32; 2] = [0.414_213_57, 2.414_213_7];

/// The arc tangent of a number of at most tan(pi/8).
#[inline(always)]
fn small_atan(x: f32x8) -> f32x8 {
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
#[inline]
pub fn atan(x: f32x8) -> f32x8 {
    let (one, size) = (f32x8::splat(1.0), x.abs());
    let [middle, large] = OCTANT_TANGENTS.map(|tangent| size.simd_gt(f32x8::splat(tangent)));
    let above = large.bitselect(-one, middle.bitselect(size - one, size));
    let below = large.bitselect(size, middle.bitselect(size + one, one));
    let from = large.bitselect(f32x8::splat(FRAC_PI_2), middle & f32x8::splat(FRAC_PI_4));
    (from + small_atan(above / below)) | sign_of(x)
}

/// `atan(y, x)`; undefined if both are 0, where browsers return 0.
#[inline]
pub fn atan2(y: f32x8, x: f32x8) -> f32x8 {
    let (height, width) = (y.abs(), x.abs());
    let steep = height.simd_gt(width);
    let (short, long) = (
        steep.bitselect(width, height),
        steep.bitselect(height, width),
    );
    let middle = short.simd_gt(long * f32x8::splat(OCTANT_TANGENTS[0]));
    let above = middle.bitselect(short - long, short);
    let below = middle.bitselect(short + long, long);
    let angle = (middle & f32x8::splat(FRAC_PI_4)) + small_atan(above / below);
    let angle = steep.bitselect(f32x8::splat(FRAC_PI_2) - angle, angle);
    let left = x.is_sign_negative();
    let angle = left.bitselect(f32x8::splat(PI) - angle, angle) | sign_of(y);
    // Otherwise, the ratio is undefined or not representable as a float.
    let usual = long.simd_gt(f32x8::splat(1e-30)) & long.simd_lt(f32x8::splat(1e30));
    if usual.all() {
        angle
    } else {
        usual.bitselect(angle, large::atan2(y, x))
    }
}
