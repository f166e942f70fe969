//! Integer arithmetic, and conversions between integers and floats (GLSL ES 3.00 sections 5.4.1 and
//! 5.9).

use fearless_simd::{f32x8, i32x8, prelude::*, u32x8};

/// `int(x)`; the lowest integer if `x` is out of range.
#[inline(always)]
pub fn int_of_float<S: Simd>(x: f32x8<S>) -> i32x8<S> {
    let within = x.abs().simd_lt(2_147_483_648.0);
    within.select(i32x8::truncate_from(x), i32x8::splat(x.token(), i32::MIN))
}

/// `uint(x)`; 0 if `x` is negative or too large.
#[inline(always)]
pub fn uint_of_float<S: Simd>(x: f32x8<S>) -> u32x8<S> {
    let zero = u32x8::splat(x.token(), 0);
    let half = 2_147_483_648.0;
    let large = x.simd_ge(half);
    let top = large.select(u32x8::splat(x.token(), 0x8000_0000), zero);
    let rest: u32x8<S> = int_of_float(large.select(x - half, x)).bitcast();
    x.simd_lt(0.0).select(zero, rest ^ top)
}

/// `float(x)` of an `int`
#[inline(always)]
pub fn float_of_int<S: Simd>(x: i32x8<S>) -> f32x8<S> {
    f32x8::float_from(x)
}

/// `float(x)` of a `uint`
#[inline(always)]
pub fn float_of_uint<S: Simd>(x: u32x8<S>) -> f32x8<S> {
    f32x8::float_from(x)
}

/// Applies a function to each lane.
#[inline(always)]
fn each<S: Simd, V: SimdBase<S>>(
    x: V,
    y: V,
    f: impl Fn(V::Element, V::Element) -> V::Element,
) -> V {
    let lane = |at: usize| match (x.as_slice().get(at), y.as_slice().get(at)) {
        (Some(x), Some(y)) => f(*x, *y),
        _ => V::Element::default(),
    };
    V::from_fn(x.token(), lane)
}

/// `x / y`. Undefined for division by zero, where browsers divide by -1, and for overflow, where
/// they return 1.
#[inline(always)]
pub fn divide_int<S: Simd>(x: i32x8<S>, y: i32x8<S>) -> i32x8<S> {
    each(x, y, |x, y| match y {
        0 => x.wrapping_neg(),
        _ => x.checked_div(y).unwrap_or(1),
    })
}

/// `x / y`. Undefined for division by zero, where browsers divide by the largest integer.
#[inline(always)]
pub fn divide_uint<S: Simd>(x: u32x8<S>, y: u32x8<S>) -> u32x8<S> {
    each(x, y, |x, y| {
        x.checked_div(y).unwrap_or(u32::from(x == u32::MAX))
    })
}

/// `x % y`. Undefined for negative operands, where the result in browsers has the sign of `y`, and
/// for zero divisors, where it is 0.
#[inline(always)]
pub fn remainder_int<S: Simd>(x: i32x8<S>, y: i32x8<S>) -> i32x8<S> {
    each(x, y, |x, y| {
        let rest = x.checked_rem(y).unwrap_or(0);
        if rest != 0 && (rest < 0) != (y < 0) {
            rest + y
        } else {
            rest
        }
    })
}

/// `x % y`. Undefined for zero divisors, where browsers divide by the largest integer.
#[inline(always)]
pub fn remainder_uint<S: Simd>(x: u32x8<S>, y: u32x8<S>) -> u32x8<S> {
    each(x, y, |x, y| {
        x.checked_rem(y)
            .unwrap_or(if x == u32::MAX { 0 } else { x })
    })
}

/// `x << y`, using the low five bits of `y`.
#[inline(always)]
pub fn shift_left<S: Simd>(x: u32x8<S>, y: u32x8<S>) -> u32x8<S> {
    x << (y & 31)
}

/// `x >> y` of a signed integer, using the low five bits of `y`.
#[inline(always)]
pub fn shift_right_int<S: Simd>(x: i32x8<S>, y: u32x8<S>) -> i32x8<S> {
    x >> (y & 31).bitcast::<i32x8<S>>()
}

/// `x >> y` of an unsigned integer, using the low five bits of `y`.
#[inline(always)]
pub fn shift_right_uint<S: Simd>(x: u32x8<S>, y: u32x8<S>) -> u32x8<S> {
    x >> (y & 31)
}
