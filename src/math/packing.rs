//! Packing and unpacking functions (GLSL ES 3.00 section 8.4).

use super::common::{max, min, round_even};
use super::integer::{float_of_int, float_of_uint, int_of_float};
use wide::{f32x8, i32x8, u32x8};

/// `packSnorm2x16(vec2(x, y))`
#[inline]
pub fn pack_snorm(x: f32x8, y: f32x8) -> u32x8 {
    join(x, y, |x| {
        let within = min(max(x, f32x8::splat(-1.0)), f32x8::splat(1.0));
        int_of_float(round_even(within * f32x8::splat(32767.0)))
    })
}

/// `packUnorm2x16(vec2(x, y))`
#[inline]
pub fn pack_unorm(x: f32x8, y: f32x8) -> u32x8 {
    join(x, y, |x| {
        let within = min(max(x, f32x8::ZERO), f32x8::splat(1.0));
        int_of_float(round_even(within * f32x8::splat(65535.0)))
    })
}

/// `packHalf2x16(vec2(x, y))`
#[inline]
pub fn pack_half(x: f32x8, y: f32x8) -> u32x8 {
    join(x, y, |x| {
        i32x8::from(x.to_array().map(|x| i32::from(half_bits(x))))
    })
}

/// `unpackSnorm2x16(p)`
#[inline]
pub fn unpack_snorm(p: u32x8) -> [f32x8; 2] {
    let p: i32x8 = bytemuck::cast(p);
    [(p << 16_u32) >> 16_u32, p >> 16_u32].map(|x| {
        let x = float_of_int(x) / f32x8::splat(32767.0);
        max(x, f32x8::splat(-1.0))
    })
}

/// `unpackUnorm2x16(p)`
#[inline]
pub fn unpack_unorm(p: u32x8) -> [f32x8; 2] {
    halves(p).map(|x| float_of_uint(x) / f32x8::splat(65535.0))
}

/// `unpackHalf2x16(p)`
#[inline]
pub fn unpack_half(p: u32x8) -> [f32x8; 2] {
    halves(p).map(|x| f32x8::from(x.to_array().map(|x| half_value(x as u16))))
}

/// The low and high 16 bits.
#[inline(always)]
fn halves(p: u32x8) -> [u32x8; 2] {
    [p & u32x8::splat(0xffff), p >> 16_u32]
}

/// Packs the low 16 bits of two numbers, the second in the high half.
#[inline(always)]
fn join(x: f32x8, y: f32x8, f: impl Fn(f32x8) -> i32x8) -> u32x8 {
    let (x, y): (u32x8, u32x8) = (bytemuck::cast(f(x)), bytemuck::cast(f(y)));
    (x & u32x8::splat(0xffff)) | (y << 16_u32)
}

/// Rounds a float to half precision (16 bits).
pub fn half_bits(x: f32) -> u16 {
    let sign = if x.is_sign_negative() { 0x8000 } else { 0 };
    let bits = x.abs().to_bits();
    sign | if x.is_nan() {
        0x7fff
    } else if bits >= 0x4780_0000 {
        0x7c00
    } else if bits >= 0x3880_0000 {
        // Rounds to nearest even, with the exponent bias of half precision.
        let odd = bits >> 13 & 1;
        ((bits - 0x3800_0000 + 0xfff + odd) >> 13) as u16
    } else {
        // Subnormal in half precision: a multiple of 2^-24.
        (x.abs() * 16_777_216.0).round_ties_even() as u16
    }
}

/// Converts half precision (16 bits) to a float.
pub fn half_value(bits: u16) -> f32 {
    let (exponent, rest) = (bits >> 10 & 0x1f, (bits & 0x3ff) as f32);
    let size = match exponent {
        0 => rest / 16_777_216.0,
        31 if rest == 0.0 => f32::INFINITY,
        31 => f32::NAN,
        e => (1.0 + rest / 1024.0) * 2f32.powi(e as i32 - 15),
    };
    if bits & 0x8000 != 0 { -size } else { size }
}
