//! Several small numbers in one (GLSL ES 3.00 section 8.4).

use super::common::{max, min, round_even};
use super::integer::{float_of_int, float_of_uint, int_of_float};
use crate::semantic::{half_bits, half_value};
use wide::{f32x8, i32x8, u32x8};

/// `packSnorm2x16(vec2(x, y))`
#[inline]
pub(in crate::exec) fn pack_snorm(x: f32x8, y: f32x8) -> u32x8 {
    join(x, y, |x| {
        let within = min(max(x, f32x8::splat(-1.0)), f32x8::splat(1.0));
        int_of_float(round_even(within * f32x8::splat(32767.0)))
    })
}

/// `packUnorm2x16(vec2(x, y))`
#[inline]
pub(in crate::exec) fn pack_unorm(x: f32x8, y: f32x8) -> u32x8 {
    join(x, y, |x| {
        let within = min(max(x, f32x8::ZERO), f32x8::splat(1.0));
        int_of_float(round_even(within * f32x8::splat(65535.0)))
    })
}

/// `packHalf2x16(vec2(x, y))`
#[inline]
pub(in crate::exec) fn pack_half(x: f32x8, y: f32x8) -> u32x8 {
    join(x, y, |x| {
        i32x8::from(x.to_array().map(|x| i32::from(half_bits(x))))
    })
}

/// `unpackSnorm2x16(p)`
#[inline]
pub(in crate::exec) fn unpack_snorm(p: u32x8) -> [f32x8; 2] {
    let p: i32x8 = bytemuck::cast(p);
    [(p << 16_u32) >> 16_u32, p >> 16_u32].map(|x| {
        let x = float_of_int(x) / f32x8::splat(32767.0);
        max(x, f32x8::splat(-1.0))
    })
}

/// `unpackUnorm2x16(p)`
#[inline]
pub(in crate::exec) fn unpack_unorm(p: u32x8) -> [f32x8; 2] {
    halves(p).map(|x| float_of_uint(x) / f32x8::splat(65535.0))
}

/// `unpackHalf2x16(p)`
#[inline]
pub(in crate::exec) fn unpack_half(p: u32x8) -> [f32x8; 2] {
    halves(p).map(|x| f32x8::from(x.to_array().map(|x| half_value(x as u16))))
}

/// The lower and the upper 16 bits.
#[inline(always)]
fn halves(p: u32x8) -> [u32x8; 2] {
    [p & u32x8::splat(0xffff), p >> 16_u32]
}

/// The lower 16 bits of two numbers, those of the second above.
#[inline(always)]
fn join(x: f32x8, y: f32x8, f: impl Fn(f32x8) -> i32x8) -> u32x8 {
    let (x, y): (u32x8, u32x8) = (bytemuck::cast(f(x)), bytemuck::cast(f(y)));
    (x & u32x8::splat(0xffff)) | (y << 16_u32)
}
