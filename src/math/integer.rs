//! Integer arithmetic, and conversions between integers and floats (GLSL ES 3.00 sections 5.4.1 and
//! 5.9).

use wide::{f32x8, i32x8, u32x8};

/// `int(x)`; the lowest integer if `x` is out of range.
#[inline(always)]
pub fn int_of_float(x: f32x8) -> i32x8 {
    let limit = f32x8::splat(2_147_483_648.0);
    let within = x.abs().simd_lt(limit);
    let truncated: f32x8 = bytemuck::cast(x.fast_trunc_int());
    let lowest = f32x8::splat(f32::from_bits(0x8000_0000));
    bytemuck::cast(within.bitselect(truncated, lowest))
}

/// `uint(x)`; 0 if `x` is negative or too large.
#[inline(always)]
pub fn uint_of_float(x: f32x8) -> u32x8 {
    let half = f32x8::splat(2_147_483_648.0);
    let large = x.simd_ge(half);
    let top: u32x8 = bytemuck::cast(large & f32x8::splat(f32::from_bits(0x8000_0000)));
    let rest: u32x8 = bytemuck::cast(int_of_float(x - (large & half)));
    let negative: u32x8 = bytemuck::cast(x.simd_lt(f32x8::ZERO));
    (rest ^ top) & !negative
}

/// `float(x)` of an `int`
#[inline(always)]
pub fn float_of_int(x: i32x8) -> f32x8 {
    f32x8::from_i32x8(x)
}

/// `float(x)` of a `uint`
#[inline(always)]
pub fn float_of_uint(x: u32x8) -> f32x8 {
    f32x8::from(x.to_array().map(|x| x as f32))
}

/// Applies a function to each lane.
#[inline(always)]
fn each_int(x: i32x8, y: i32x8, f: impl Fn(i32, i32) -> i32) -> i32x8 {
    let (x, y) = (x.to_array(), y.to_array());
    let mut both = x.into_iter().zip(y);
    i32x8::from([(); 8].map(|()| both.next().map_or(0, |(x, y)| f(x, y))))
}

/// Applies a function to each lane.
#[inline(always)]
fn each_uint(x: u32x8, y: u32x8, f: impl Fn(u32, u32) -> u32) -> u32x8 {
    let (x, y) = (x.to_array(), y.to_array());
    let mut both = x.into_iter().zip(y);
    u32x8::from([(); 8].map(|()| both.next().map_or(0, |(x, y)| f(x, y))))
}

/// `x / y`. Undefined for division by zero, where browsers divide by -1, and for overflow, where
/// they return 1.
#[inline]
pub fn divide_int(x: i32x8, y: i32x8) -> i32x8 {
    each_int(x, y, |x, y| match y {
        0 => x.wrapping_neg(),
        _ => x.checked_div(y).unwrap_or(1),
    })
}

/// `x / y`. Undefined for division by zero, where browsers divide by the largest integer.
#[inline]
pub fn divide_uint(x: u32x8, y: u32x8) -> u32x8 {
    each_uint(x, y, |x, y| {
        x.checked_div(y).unwrap_or(u32::from(x == u32::MAX))
    })
}

/// `x % y`. Undefined for negative operands, where the result in browsers has the sign of `y`, and
/// for zero divisors, where it is 0.
#[inline]
pub fn remainder_int(x: i32x8, y: i32x8) -> i32x8 {
    each_int(x, y, |x, y| {
        let rest = x.checked_rem(y).unwrap_or(0);
        if rest != 0 && (rest < 0) != (y < 0) {
            rest + y
        } else {
            rest
        }
    })
}

/// `x % y`. Undefined for zero divisors, where browsers divide by the largest integer.
#[inline]
pub fn remainder_uint(x: u32x8, y: u32x8) -> u32x8 {
    each_uint(x, y, |x, y| {
        x.checked_rem(y)
            .unwrap_or(if x == u32::MAX { 0 } else { x })
    })
}

/// `x << y`, using the low five bits of `y`.
#[inline]
pub fn shift_left(x: u32x8, y: u32x8) -> u32x8 {
    each_uint(x, y, u32::wrapping_shl)
}

/// `x >> y` of a signed integer, using the low five bits of `y`.
#[inline]
pub fn shift_right_int(x: i32x8, y: u32x8) -> i32x8 {
    each_int(x, bytemuck::cast(y), |x, y| x.wrapping_shr(y as u32))
}

/// `x >> y` of an unsigned integer, using the low five bits of `y`.
#[inline]
pub fn shift_right_uint(x: u32x8, y: u32x8) -> u32x8 {
    each_uint(x, y, u32::wrapping_shr)
}
