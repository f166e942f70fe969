//! Integers, and what turns them into floats and back (GLSL ES 3.00 sections 5.4.1, 5.9).

use wide::{f32x8, i32x8, u32x8};

/// `int(x)`; what is out of range is the lowest.
#[inline(always)]
pub fn int_of_float(x: f32x8) -> i32x8 {
    let limit = f32x8::splat(2_147_483_648.0);
    let within = x.abs().simd_lt(limit);
    let whole: f32x8 = bytemuck::cast(x.fast_trunc_int());
    let lowest = f32x8::splat(f32::from_bits(0x8000_0000));
    bytemuck::cast(within.bitselect(whole, lowest))
}

/// `uint(x)`; what is negative or too large is 0.
#[inline(always)]
pub fn uint_of_float(x: f32x8) -> u32x8 {
    let half = f32x8::splat(2_147_483_648.0);
    let large = x.simd_ge(half);
    let top: u32x8 = bytemuck::cast(large & f32x8::splat(f32::from_bits(0x8000_0000)));
    let rest: u32x8 = bytemuck::cast(int_of_float(x - (large & half)));
    let negative: u32x8 = bytemuck::cast(x.simd_lt(f32x8::ZERO));
    (rest ^ top) & !negative
}

/// `float(x)`
#[inline(always)]
pub fn float_of_int(x: i32x8) -> f32x8 {
    f32x8::from_i32x8(x)
}

/// `float(x)`
#[inline(always)]
pub fn float_of_uint(x: u32x8) -> f32x8 {
    f32x8::from(x.to_array().map(|x| x as f32))
}

/// Lane by lane.
#[inline(always)]
fn each_int(x: i32x8, y: i32x8, f: impl Fn(i32, i32) -> i32) -> i32x8 {
    let (x, y) = (x.to_array(), y.to_array());
    let mut both = x.into_iter().zip(y);
    i32x8::from([(); 8].map(|()| both.next().map_or(0, |(x, y)| f(x, y))))
}

/// Lane by lane.
#[inline(always)]
fn each_uint(x: u32x8, y: u32x8, f: impl Fn(u32, u32) -> u32) -> u32x8 {
    let (x, y) = (x.to_array(), y.to_array());
    let mut both = x.into_iter().zip(y);
    u32x8::from([(); 8].map(|()| both.next().map_or(0, |(x, y)| f(x, y))))
}

/// `x / y`; undefined by zero, where the browser divides by -1, and where it overflows, which gives 1
/// there.
#[inline]
pub fn divide_int(x: i32x8, y: i32x8) -> i32x8 {
    each_int(x, y, |x, y| match y {
        0 => x.wrapping_neg(),
        _ => x.checked_div(y).unwrap_or(1),
    })
}

/// `x / y`; undefined by zero, where the browser divides by the largest number.
#[inline]
pub fn divide_uint(x: u32x8, y: u32x8) -> u32x8 {
    each_uint(x, y, |x, y| {
        x.checked_div(y).unwrap_or(u32::from(x == u32::MAX))
    })
}

/// `x % y`; undefined of negative numbers, where the browser gives what has the sign of `y`, and by
/// zero, where it gives 0.
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

/// `x % y`; undefined by zero, where the browser divides by the largest number.
#[inline]
pub fn remainder_uint(x: u32x8, y: u32x8) -> u32x8 {
    each_uint(x, y, |x, y| {
        x.checked_rem(y)
            .unwrap_or(if x == u32::MAX { 0 } else { x })
    })
}

/// `x << y`, by the lowest five bits.
#[inline]
pub fn shift_left(x: u32x8, y: u32x8) -> u32x8 {
    each_uint(x, y, u32::wrapping_shl)
}

/// `x >> y` of a signed number, by the lowest five bits.
#[inline]
pub fn shift_right_int(x: i32x8, y: u32x8) -> i32x8 {
    each_int(x, bytemuck::cast(y), |x, y| x.wrapping_shr(y as u32))
}

/// `x >> y` of an unsigned number, by the lowest five bits.
#[inline]
pub fn shift_right_uint(x: u32x8, y: u32x8) -> u32x8 {
    each_uint(x, y, u32::wrapping_shr)
}
