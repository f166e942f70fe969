//! Trigonometric functions of large angles and extreme ratios, for which single precision is
//! insufficient.

use super::double::{atan, narrow, number, polynomial, round, widen};
use super::single::with_sign;
use fearless_simd::{f32x8, f64x8, mask64x8, prelude::*, u64x8};
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};

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
fn reduce<S: Simd>(x: f32x8<S>) -> (u64x8<S>, f64x8<S>) {
    let wide = widen(x);
    let (integer, quarters) = round(wide * FRAC_2_PI);
    // The first part of pi/2 has 25 significant bits, so that the product is exact.
    let rest = wide
        - integer * f64::from_bits(0x3ff9_21fb_5000_0000)
        - integer * f64::from_bits(0x3e51_10b4_611a_6263);
    if x.abs().simd_ge(HUGE).any_true() {
        let (quarters, rest) = reduce_huge(x.into(), (quarters.into(), rest.into()));
        let simd = x.token();
        (quarters.simd_into(simd), rest.simd_into(simd))
    } else {
        (quarters, rest)
    }
}

/// Range reduction for finite angles of any size.
#[cold]
#[inline(never)]
fn reduce_huge(
    x: [f32; 8],
    (mut quarters, mut rest): ([u64; 8], [f64; 8]),
) -> ([u64; 8], [f64; 8]) {
    for ((x, quarters), rest) in x.into_iter().zip(&mut quarters).zip(&mut rest) {
        if x.is_finite() && x.abs() >= HUGE {
            (*quarters, *rest) = reduce_one(x);
        }
    }
    (quarters, rest)
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
fn sine_cosine<S: Simd>(x: f64x8<S>) -> (f64x8<S>, f64x8<S>) {
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
    let cosine = 1.0 - square * 0.5
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
fn sine_after<S: Simd>(quarters: u64x8<S>, rest: f64x8<S>) -> f64x8<S> {
    let (sine, cosine) = sine_cosine(rest);
    let negative = (quarters & 2) << 62;
    let chosen = is_odd(quarters).select(cosine, sine);
    (chosen.bitcast::<u64x8<S>>() ^ negative).bitcast()
}

/// Where a number is odd.
#[inline(always)]
fn is_odd<S: Simd>(quarters: u64x8<S>) -> mask64x8<S> {
    (quarters & 1).simd_eq(1)
}

/// The sine of an angle plus a number of quarter turns.
#[cold]
#[inline(never)]
pub(super) fn sine_and<S: Simd>(x: f32x8<S>, more: u32) -> f32x8<S> {
    x.token().vectorize(
        #[inline(always)]
        || {
            let (quarters, rest) = reduce(x);
            narrow(sine_after(quarters + u64::from(more), rest))
        },
    )
}

/// `tan(x)` of an angle of any size.
#[cold]
#[inline(never)]
pub(super) fn tan<S: Simd>(x: f32x8<S>) -> f32x8<S> {
    x.token().vectorize(
        #[inline(always)]
        || {
            let (quarters, rest) = reduce(x);
            narrow(sine_after(quarters, rest) / sine_after(quarters + 1, rest))
        },
    )
}

/// `atan(y, x)` of any pair of numbers; 0 if both are 0.
#[cold]
#[inline(never)]
pub(super) fn atan2<S: Simd>(y: f32x8<S>, x: f32x8<S>) -> f32x8<S> {
    x.token().vectorize(
        #[inline(always)]
        || {
            let (height, width) = (widen(y.abs()), widen(x.abs()));
            // If both are equal the ratio is 1, also for two infinities.
            let same = height.simd_eq(width);
            let angle = atan(same.select(number(width, 1.0), height / width));
            let left = widen(x).is_sign_negative();
            let angle = narrow(left.select(PI - angle, angle));
            let nothing = y.simd_eq(0.0) & x.simd_eq(0.0);
            with_sign(nothing.select(f32x8::splat(x.token(), 0.0), angle), y)
        },
    )
}
