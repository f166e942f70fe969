//! Angles (GLSL ES 3.00 section 8.1).
//!
//! What is usual is computed in single precision; large angles, and what has no ratio, in double.

use super::large;
use super::single::{polynomial, round, sign_of};
use std::f32::consts::{FRAC_2_PI, FRAC_PI_2, FRAC_PI_4, PI};
use wide::{f32x8, u32x8};

/// From here on a quarter turn in four parts has too few digits.
const LARGE: f32 = 8192.0;

/// A quarter turn: three parts of so few digits that their products with whole numbers below 2^13 are
/// exact, and the rest.
const QUARTER: [f32; 4] = [1.570_312_5, 4.837_513e-4, 7.549_533_6e-8, 2.563_344e-12];

/// An angle below [`LARGE`] as the rest after whole quarter turns, which is at most an eighth of a
/// turn, and a number whose lowest bits count these.
#[inline(always)]
fn reduce(x: f32x8) -> (f32x8, u32x8) {
    let (whole, quarters) = round(x * f32x8::splat(FRAC_2_PI));
    let mut rest = x;
    for part in QUARTER {
        rest -= whole * f32x8::splat(part);
    }
    (rest, quarters)
}

/// The sine and the cosine of at most an eighth of a turn.
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

/// The sine of an angle and so many quarter turns more.
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

/// The arc sine of at most 1/2, or of the root of its square.
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

/// The arc sine of a number without its sign, or half the arc cosine of it above 1/2, and which of the
/// two.
#[inline(always)]
fn arc(size: f32x8) -> (f32x8, f32x8) {
    let (half, one) = (f32x8::splat(0.5), f32x8::splat(1.0));
    let above = size.simd_gt(half);
    let square = above.bitselect((one - size) * half, size * size);
    let x = above.bitselect(square.sqrt(), size);
    (small_asin(x, square), above)
}

/// `asin(x)`; no number outside of -1 to 1.
#[inline]
pub fn asin(x: f32x8) -> f32x8 {
    let (angle, above) = arc(x.abs());
    let angle = above.bitselect(f32x8::splat(FRAC_PI_2) - (angle + angle), angle);
    angle | sign_of(x)
}

/// `acos(x)`; no number outside of -1 to 1.
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

/// The tangent of an eighth and of three eighths of half a turn.
const TURNS: [f32; 2] = [0.414_213_57, 2.414_213_7];

/// The arc tangent of at most `TURNS[0]`.
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
    let [middle, large] = TURNS.map(|turn| size.simd_gt(f32x8::splat(turn)));
    let above = large.bitselect(-one, middle.bitselect(size - one, size));
    let below = large.bitselect(size, middle.bitselect(size + one, one));
    let from = large.bitselect(f32x8::splat(FRAC_PI_2), middle & f32x8::splat(FRAC_PI_4));
    (from + small_atan(above / below)) | sign_of(x)
}

/// `atan(y, x)`; undefined where both are 0, where the browser gives 0.
#[inline]
pub fn atan2(y: f32x8, x: f32x8) -> f32x8 {
    let (height, width) = (y.abs(), x.abs());
    let steep = height.simd_gt(width);
    let (short, long) = (
        steep.bitselect(width, height),
        steep.bitselect(height, width),
    );
    let middle = short.simd_gt(long * f32x8::splat(TURNS[0]));
    let above = middle.bitselect(short - long, short);
    let below = middle.bitselect(short + long, long);
    let angle = (middle & f32x8::splat(FRAC_PI_4)) + small_atan(above / below);
    let angle = steep.bitselect(f32x8::splat(FRAC_PI_2) - angle, angle);
    let left = x.is_sign_negative();
    let angle = left.bitselect(f32x8::splat(PI) - angle, angle) | sign_of(y);
    // Others have no ratio, or none that a float holds.
    let usual = long.simd_gt(f32x8::splat(1e-30)) & long.simd_lt(f32x8::splat(1e30));
    if usual.all() {
        angle
    } else {
        usual.bitselect(angle, large::atan2(y, x))
    }
}
