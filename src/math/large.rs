//! Trigonometric functions of large angles and extreme ratios, for which single precision is
//! insufficient.

use super::double::{atan, bits, narrow, of_bits, polynomial, round, widen};
use super::single::sign_of;
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};
use wide::{f32x8, f64x8, u64x8};

/// From this magnitude on, the two-part reduction by pi/2 is not precise enough.
const HUGE: f32 = 268_435_456.0;

/// The first 256 bits of `2 / PI` after the binary point.
const TWO_OVER_PI: [u128; 2] = [
    0xa2f9_836e_4e44_1529_fc27_57d1_f534_ddc0,
    0xdb62_9599_3c43_9041_fe51_63ab_debb_c561,
];

/// Range reduction: the number of quarter turns (multiples of pi/2), and the remainder, at most
/// pi/4 in magnitude.
#[inline(always)]
fn reduce(x: f32x8) -> (u64x8, f64x8) {
    let wide = widen(x);
    let (integer, quarters) = round(wide * f64x8::splat(FRAC_2_PI));
    // The first part of pi/2 has 25 significant bits, so that the product is exact.
    let rest = wide
        - integer * f64x8::splat(f64::from_bits(0x3ff9_21fb_5000_0000))
        - integer * f64x8::splat(f64::from_bits(0x3e51_10b4_611a_6263));
    let huge = x.abs().simd_ge(f32x8::splat(HUGE));
    if huge.any() {
        reduce_huge(x, quarters, rest)
    } else {
        (quarters, rest)
    }
}

/// Range reduction for finite angles of any size.
#[cold]
fn reduce_huge(x: f32x8, quarters: u64x8, rest: f64x8) -> (u64x8, f64x8) {
    let mut quarters = quarters.to_array();
    let mut rest = rest.to_array();
    for ((x, quarters), rest) in x.to_array().into_iter().zip(&mut quarters).zip(&mut rest) {
        if x.is_finite() && x.abs() >= HUGE {
            (*quarters, *rest) = reduce_one(x);
        }
    }
    (u64x8::from(quarters), f64x8::from(rest))
}

/// Payne-Hanek range reduction of a finite number of at least [`HUGE`]: multiplies it by the bits
/// of `2 / PI` that affect the last two bits of the number of quarter turns or the fraction.
fn reduce_one(x: f32) -> (u64, f64) {
    let bits = x.abs().to_bits();
    let digits = u128::from(bits & 0x7f_ffff | 0x80_0000);
    // The value is `digits * 2^exponent`.
    let exponent = (bits >> 23).saturating_sub(150);
    let skipped = exponent.saturating_sub(2);
    let [high, low] = TWO_OVER_PI;
    let window = if skipped == 0 {
        high
    } else {
        high << skipped | low >> (128 - skipped)
    };
    let product = digits.wrapping_mul(window);
    let quarters = (product.wrapping_add(1 << 125) >> 126) as u64;
    let rest = product.wrapping_sub(u128::from(quarters) << 126) as i128;
    let rest = rest as f64 / (1_u128 << 126) as f64 * FRAC_PI_2;
    if x < 0.0 {
        (quarters.wrapping_neg(), -rest)
    } else {
        (quarters, rest)
    }
}

/// Sine and cosine of an angle of at most pi/4.
#[inline(always)]
fn sine_cosine(x: f64x8) -> (f64x8, f64x8) {
    let square = x * x;
    let sine = x + x
        * square
        * polynomial(
            square,
            [
                -0.16666666663844049,
                0.008333331870341349,
                -0.00019840084376422697,
                2.724962008007483e-06,
            ],
        );
    let cosine = f64x8::splat(1.0) - square * f64x8::splat(0.5)
        + square
            * square
            * polynomial(
                square,
                [
                    0.04166666666431182,
                    -0.0013888887668370524,
                    2.480059840830534e-05,
                    -2.730070403394305e-07,
                ],
            );
    (sine, cosine)
}

/// The sine of `rest` plus a number of quarter turns.
#[inline(always)]
fn sine_after(quarters: u64x8, rest: f64x8) -> f64x8 {
    let (sine, cosine) = sine_cosine(rest);
    let odd = is_odd(quarters);
    let negative = (quarters & u64x8::splat(2)) << 62_u32;
    let chosen = odd.bitselect(cosine, sine);
    of_bits(bits(chosen) ^ negative)
}

/// All bits set where a number is odd, none where it is even.
#[inline(always)]
fn is_odd(quarters: u64x8) -> f64x8 {
    of_bits(u64x8::ZERO - (quarters & u64x8::splat(1)))
}

/// The sine of an angle plus a number of quarter turns.
#[cold]
pub(super) fn sine_and(x: f32x8, more: u32) -> f32x8 {
    let (quarters, rest) = reduce(x);
    narrow(sine_after(quarters + u64x8::splat(more.into()), rest))
}

/// `tan(x)` of an angle of any size.
#[cold]
pub(super) fn tan(x: f32x8) -> f32x8 {
    let (quarters, rest) = reduce(x);
    narrow(sine_after(quarters, rest) / sine_after(quarters + u64x8::splat(1), rest))
}

/// `atan(y, x)` of any pair of numbers; 0 if both are 0.
#[cold]
pub(super) fn atan2(y: f32x8, x: f32x8) -> f32x8 {
    let (height, width) = (widen(y.abs()), widen(x.abs()));
    // If both are equal the ratio is 1, also for two infinities.
    let same = height.simd_eq(width);
    let angle = atan(same.bitselect(f64x8::splat(1.0), height / width));
    let left = widen_mask(x.is_sign_negative());
    let angle = left.bitselect(f64x8::splat(PI) - angle, angle);
    let nothing = (x.abs() | y.abs()).simd_eq(f32x8::ZERO);
    let angle = nothing.bitselect(f32x8::ZERO, narrow(angle));
    angle | sign_of(y)
}

/// Widens a mask of floats to a mask of doubles.
#[inline(always)]
fn widen_mask(mask: f32x8) -> f64x8 {
    widen(mask.bitselect(f32x8::splat(1.0), f32x8::ZERO)).simd_gt(f64x8::ZERO)
}
