//! Helpers for eight lanes in single precision.
//!
//! Multiplications and additions are never fused, so that results are identical on all machines.

use super::lanes::lane_helpers;
use fearless_simd::{f32x8, i32x8, prelude::*, u32x8};

/// The bit of the sign.
const SIGN: u32 = 1 << 31;

lane_helpers!(f32x8, u32x8, f32, 12_582_912.0);

/// `x * 2^n` for `n` from -252 to 254, in the low bits as returned by [`round`].
#[inline(always)]
pub(super) fn scale<S: Simd>(x: f32x8<S>, n: u32x8<S>) -> f32x8<S> {
    // In two steps, since `2^n` itself may overflow or underflow.
    let n: i32x8<S> = (n << 16).bitcast();
    let half = n >> 17;
    let rest = (n >> 16) - half;
    x * power(half) * power(rest)
}

/// `2^n`
#[inline(always)]
fn power<S: Simd>(n: i32x8<S>) -> f32x8<S> {
    ((n + 127) << 23).bitcast()
}

/// Splits the magnitude of a number: `x = 2^exponent * (1 + rest)`, with `1 + rest` between
/// sqrt(1/2) and sqrt(2). Subnormals are treated as if they had an implicit leading one, as in
/// browsers: 0 becomes 2^-127.
#[inline(always)]
pub(super) fn split<S: Simd>(x: f32x8<S>) -> (f32x8<S>, f32x8<S>) {
    let from = 0x3f35_04f3;
    let shifted = x.abs().bitcast::<i32x8<S>>() - from;
    let rest = (shifted & 0x007f_ffff) + from;
    (
        f32x8::float_from(shifted >> 23),
        rest.bitcast::<f32x8<S>>() - 1.0,
    )
}

/// A non-negative number with the sign of another.
#[inline(always)]
pub(super) fn with_sign<S: Simd>(size: f32x8<S>, of: f32x8<S>) -> f32x8<S> {
    let (size, of): (u32x8<S>, u32x8<S>) = (size.bitcast(), of.bitcast());
    (size | (of & SIGN)).bitcast()
}

/// All bits of a number with these bits flipped.
#[inline(always)]
pub(super) fn flipped<S: Simd>(x: f32x8<S>, bits: u32x8<S>) -> f32x8<S> {
    (x.bitcast::<u32x8<S>>() ^ bits).bitcast()
}
