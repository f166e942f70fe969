//! Helpers for eight lanes in double precision, for functions that would lose precision in floats.
//!
//! Multiplications and additions are never fused, so that results are identical on all machines.

use wide::{f32x8, f64x8, u64x8};

/// Adding and subtracting it rounds a double to the nearest integer; the low bits of the sum are
/// that integer.
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// Converts floats to doubles.
#[inline(always)]
pub(super) fn widen(x: f32x8) -> f64x8 {
    f64x8::from(x.to_array().map(f64::from))
}

/// Rounds doubles to the nearest floats.
#[inline(always)]
pub(super) fn narrow(x: f64x8) -> f32x8 {
    f32x8::from(x.to_array().map(|x| x as f32))
}

/// Reinterprets doubles as bits.
#[inline(always)]
pub(super) fn bits(x: f64x8) -> u64x8 {
    bytemuck::cast(x)
}

/// Reinterprets bits as doubles.
#[inline(always)]
pub(super) fn of_bits(x: u64x8) -> f64x8 {
    bytemuck::cast(x)
}

/// Rounds to the nearest integer, for magnitudes below 2^51. Also returns a number whose low bits
/// are that integer in two's complement.
#[inline(always)]
pub(super) fn round(x: f64x8) -> (f64x8, u64x8) {
    let sum = x + f64x8::splat(ROUNDER);
    (sum - f64x8::splat(ROUNDER), bits(sum))
}

/// `c[0] + c[1] * x + c[2] * x * x ...`
#[inline(always)]
pub(super) fn polynomial<const N: usize>(x: f64x8, coefficients: [f64; N]) -> f64x8 {
    let mut sum = f64x8::ZERO;
    for (at, c) in coefficients.into_iter().rev().enumerate() {
        sum = if at == 0 {
            f64x8::splat(c)
        } else {
            sum * x + f64x8::splat(c)
        };
    }
    sum
}

/// `2^x`. Beyond the range of floats, any number that overflows or underflows a float.
#[inline(always)]
pub(super) fn exp2(x: f64x8) -> f64x8 {
    let within = x
        .fast_max(f64x8::splat(-400.0))
        .fast_min(f64x8::splat(400.0));
    let (integer, bits) = round(within);
    let r = within - integer;
    let power = f64x8::splat(1.0)
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
    let scale = of_bits((bits << 52_u32) + u64x8::splat(0x3ff0_0000_0000_0000));
    x.is_nan().bitselect(x, power * scale)
}

/// The binary logarithm of a positive finite number.
#[inline(always)]
pub(super) fn log2(x: f64x8) -> f64x8 {
    // The exponent is chosen such that the mantissa lies between sqrt(1/2) and sqrt(2).
    let from = u64x8::splat(0x3fe6_a09e_667f_3bcd);
    let bias = u64x8::splat(0x3ff0_0000_0000_0000);
    let shifted = bits(x) - from + bias;
    let exponent = shifted >> 52_u32;
    let m = of_bits((shifted & u64x8::splat(0x000f_ffff_ffff_ffff)) + from);
    // An integer in the low bits of the double 2^52 becomes a double by subtracting 2^52.
    let integer = of_bits(exponent | u64x8::splat(0x4330_0000_0000_0000))
        - f64x8::splat(4_503_599_627_370_496.0 + 1023.0);
    let one = f64x8::splat(1.0);
    let s = (m - one) / (m + one);
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
pub(super) fn atan(x: f64x8) -> f64x8 {
    let one = f64x8::splat(1.0);
    let large = x.simd_gt(f64x8::splat(2.414_213_562_373_095));
    let middle = x.simd_gt(f64x8::splat(0.414_213_562_373_095_03));
    let rotated = (x - one) / (x + one);
    let small = large.bitselect(-one / x, middle.bitselect(rotated, x));
    let from = large.bitselect(
        f64x8::splat(std::f64::consts::FRAC_PI_2),
        middle & f64x8::splat(std::f64::consts::FRAC_PI_4),
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
