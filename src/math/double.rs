//! Helpers for eight lanes in double precision, for functions that would lose precision in floats.
//!
//! Multiplications and additions are never fused, so that results are identical on all machines.

use super::lanes::lane_helpers;
use fearless_simd::{f32x8, f64x8, prelude::*, u64x8};

lane_helpers!(f64x8, u64x8, f64, 6_755_399_441_055_744.0);

/// Converts floats to doubles.
#[inline(always)]
pub(super) fn widen<S: Simd>(x: f32x8<S>) -> f64x8<S> {
    let (low, high) = x.widen();
    low.combine(high)
}

/// Rounds doubles to the nearest floats.
#[inline(always)]
pub(super) fn narrow<S: Simd>(x: f64x8<S>) -> f32x8<S> {
    let (low, high) = x.split();
    low.narrow(high)
}

/// `2^x`. Beyond the range of floats, any number that overflows or underflows a float.
#[inline(always)]
pub(super) fn exp2<S: Simd>(x: f64x8<S>) -> f64x8<S> {
    let low = number(x, -400.0);
    let above = x.simd_gt(low).select(x, low);
    let high = number(x, 400.0);
    let within = above.simd_lt(high).select(above, high);
    let (integer, bits) = round(within);
    let r = within - integer;
    let power = 1.0
        + r * polynomial(
            r,
            [
                std::f64::consts::LN_2,
                0.2402265092256076,
                0.05550410883930555,
                0.00961805662050108,
                0.001333350234150156,
                0.00015461467905285986,
                1.529734162283227e-5,
            ],
        );
    let scale: f64x8<S> = ((bits << 52) + 0x3ff0_0000_0000_0000).bitcast();
    x.is_nan().select(x, power * scale)
}

/// The binary logarithm of a positive finite number.
#[inline(always)]
pub(super) fn log2<S: Simd>(x: f64x8<S>) -> f64x8<S> {
    // The exponent is chosen such that the mantissa lies between sqrt(1/2) and sqrt(2).
    let from = 0x3fe6_a09e_667f_3bcd;
    let bias = 0x3ff0_0000_0000_0000;
    let shifted = x.bitcast::<u64x8<S>>() - from + bias;
    let exponent = shifted >> 52;
    let m: f64x8<S> = ((shifted & 0x000f_ffff_ffff_ffff) + from).bitcast();
    // An integer in the low bits of the double 2^52 becomes a double by subtracting 2^52.
    let integer = (exponent | 0x4330_0000_0000_0000).bitcast::<f64x8<S>>()
        - (4_503_599_627_370_496.0 + 1023.0);
    let s = (m - 1.0) / (m + 1.0);
    let series = polynomial(
        s * s,
        [
            2.88539008177785,
            0.9617966941132139,
            0.5770779423592367,
            0.4122092568034226,
            0.3199053733363255,
            0.2829066238319144,
        ],
    );
    integer + s * series
}

/// The arc tangent of a non-negative number, including infinity.
#[inline(always)]
pub(super) fn atan<S: Simd>(x: f64x8<S>) -> f64x8<S> {
    let large = x.simd_gt(2.414_213_562_373_095);
    let middle = x.simd_gt(0.414_213_562_373_095_03);
    let rotated = (x - 1.0) / (x + 1.0);
    let small = large.select(-1.0 / x, middle.select(rotated, x));
    let from = large.select(
        number(x, std::f64::consts::FRAC_PI_2),
        middle.select(number(x, std::f64::consts::FRAC_PI_4), number(x, 0.0)),
    );
    let square = small * small;
    let series = polynomial(
        square,
        [
            -0.33333333333265697,
            0.19999999949530511,
            -0.14285708076602635,
            0.11110818413183177,
            -0.09084078139184734,
            0.0760457946802056,
            -0.06026298321805999,
            0.03293875684556034,
        ],
    );
    from + (small + small * square * series)
}
