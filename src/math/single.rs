//! Eight lanes in single precision, and their digits.
//!
//! No multiplication is fused with an addition, so that every machine gives the same digits.

use wide::{f32x8, i32x8, u32x8};

/// Added to a float and taken away again, it leaves the nearest whole number; the lowest bits of the
/// sum are that number.
const ROUNDER: f32 = 12_582_912.0;

/// The nearest whole number, and a number whose lowest bits are those of it in two's complement;
/// below 2^21.
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

/// `x * 2^n`; `n` are the lowest bits that [`round`] gives, from -252 to 254.
#[inline(always)]
pub(super) fn scale(x: f32x8, n: u32x8) -> f32x8 {
    // In two steps, since a power itself may be too large or too small for a float.
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

/// Exponent and rest of a number, its sign left out: `x = 2^exponent * (1 + rest)`, where `1 + rest`
/// lies between the roots of 1/2 and 2. Numbers without a leading one are given one, as in the browser:
/// 0 is taken for 2^-127.
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

/// The signs alone, to be put on what has none.
#[inline(always)]
pub(crate) fn sign_of(x: f32x8) -> f32x8 {
    x & f32x8::splat(-0.0)
}
