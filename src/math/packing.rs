//! Packing and unpacking functions (GLSL ES 3.00 section 8.4).

use super::common::{max, min, round_even};
use super::integer::{float_of_int, float_of_uint, int_of_float};
use super::single::number;
use fearless_simd::{f32x8, i32x8, prelude::*, u32x8};

/// `packSnorm2x16(vec2(x, y))`
#[inline(always)]
pub fn pack_snorm<S: Simd>(x: f32x8<S>, y: f32x8<S>) -> u32x8<S> {
    join(x, y, |x| {
        let within = min(max(x, number(x, -1.0)), number(x, 1.0));
        int_of_float(round_even(within * 32767.0))
    })
}

/// `packUnorm2x16(vec2(x, y))`
#[inline(always)]
pub fn pack_unorm<S: Simd>(x: f32x8<S>, y: f32x8<S>) -> u32x8<S> {
    join(x, y, |x| {
        let within = min(max(x, number(x, 0.0)), number(x, 1.0));
        int_of_float(round_even(within * 65535.0))
    })
}

/// `packHalf2x16(vec2(x, y))`
#[inline(always)]
pub fn pack_half<S: Simd>(x: f32x8<S>, y: f32x8<S>) -> u32x8<S> {
    join(x, y, |x| {
        let lanes: [f32; 8] = x.into();
        lanes.map(|x| i32::from(half_bits(x))).simd_into(x.token())
    })
}

/// `unpackSnorm2x16(p)`
#[inline(always)]
pub fn unpack_snorm<S: Simd>(p: u32x8<S>) -> [f32x8<S>; 2] {
    let p: i32x8<S> = p.bitcast();
    [(p << 16) >> 16, p >> 16].map(|x| {
        let x = float_of_int(x) / 32767.0;
        max(x, number(x, -1.0))
    })
}

/// `unpackUnorm2x16(p)`
#[inline(always)]
pub fn unpack_unorm<S: Simd>(p: u32x8<S>) -> [f32x8<S>; 2] {
    halves(p).map(|x| float_of_uint(x) / 65535.0)
}

/// `unpackHalf2x16(p)`
#[inline(always)]
pub fn unpack_half<S: Simd>(p: u32x8<S>) -> [f32x8<S>; 2] {
    halves(p).map(|x| {
        let lanes: [u32; 8] = x.into();
        lanes.map(|x| half_value(x as u16)).simd_into(x.token())
    })
}

/// The low and high 16 bits.
#[inline(always)]
fn halves<S: Simd>(p: u32x8<S>) -> [u32x8<S>; 2] {
    [p & 0xffff, p >> 16]
}

/// Packs the low 16 bits of two numbers, the second in the high half.
#[inline(always)]
fn join<S: Simd>(x: f32x8<S>, y: f32x8<S>, f: impl Fn(f32x8<S>) -> i32x8<S>) -> u32x8<S> {
    let (x, y): (u32x8<S>, u32x8<S>) = (f(x).bitcast(), f(y).bitcast());
    (x & 0xffff) | (y << 16)
}

/// `floatBitsToUint(x)`: the bits of a float, the same for every NaN. Which of them an operation results
/// in is up to the compiler of this crate (in `a + b` it may swap the operands), so that neither a shader
/// nor its outputs may show it.
pub const fn bits_of(x: f32) -> u32 {
    if x.is_nan() {
        f32::NAN.to_bits()
    } else {
        x.to_bits()
    }
}

/// Rounds a float to half precision (16 bits).
pub fn half_bits(x: f32) -> u16 {
    let sign = (bits_of(x) >> 16) as u16 & 0x8000;
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
