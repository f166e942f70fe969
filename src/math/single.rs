//! Helpers for eight lanes in single precision.
//!
//! Multiplications and additions are never fused, so that results are identical on all machines.

use wide::{f32x8, i32x8, u32x8};

/// Adding and subtracting it rounds a float to the nearest integer; the low bits of the sum are
/// that integer.
const ROUNDER: f32 = 12_582_912.0;

/// Rounds to the nearest integer, for magnitudes below 2^21. Also returns a number whose low bits
/// are that integer in two's complement.
#[inline(always)]
pub(super) fn round(x: f32x8) -> (f32x8, u32x8) {
    let rounder = f32x8::splat(ROUNDER);
    let sum = x + rounder;
    (sum - rounder, bytemuck::cast(sum))
}

/// `c[0] + c[1] * x + c[2] * x * x ...`
#[inline(always)]
pub(super) fn polynomial<const N: usize>(x: f32x8, coefficients: [f32; N]) -> f32x8 {
    let mut sum = f32x8::ZERO;
    for (at, c) in coefficients.into_iter().rev().enumerate() {
        sum = if at == 0 {
            f32x8::splat(c)
        } else {
            sum * x + f32x8::splat(c)
        };
    }
    sum
}

/// `x * 2^n` for `n` from -252 to 254, in the low bits as returned by [`round`].
#[inline(always)]
pub(super) fn scale(x: f32x8, n: u32x8) -> f32x8 {
    // In two steps, since `2^n` itself may overflow or underflow.
    let n: i32x8 = bytemuck::cast(n << 16_u32);
    let half = n >> 17_u32;
    let rest = (n >> 16_u32) - half;
    x * power(half) * power(rest)
}

/// `2^n`
#[inline(always)]
fn power(n: i32x8) -> f32x8 {
    bytemuck::cast((n + i32x8::splat(127)) << 23_u32)
}

/// Splits the magnitude of a number: `x = 2^exponent * (1 + rest)`, with `1 + rest` between
/// sqrt(1/2) and sqrt(2). Subnormals are treated as if they had an implicit leading one, as in
/// browsers: 0 becomes 2^-127.
#[inline(always)]
pub(super) fn split(x: f32x8) -> (f32x8, f32x8) {
    let from = i32x8::splat(0x3f35_04f3);
    let shifted = bytemuck::cast::<_, i32x8>(x.abs()) - from;
    let rest = (shifted & i32x8::splat(0x007f_ffff)) + from;
    (
        f32x8::from_i32x8(shifted >> 23_u32),
        bytemuck::cast::<_, f32x8>(rest) - f32x8::splat(1.0),
    )
}

/// The sign bits, to be combined with magnitudes.
#[inline(always)]
pub(crate) fn sign_of(x: f32x8) -> f32x8 {
    x & f32x8::splat(-0.0)
}
