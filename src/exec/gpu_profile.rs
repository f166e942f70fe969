//! Results with the maximum error that a GPU may have (VK-GL-CTS, glsBuiltinPrecisionTests): 2.5
//! ULP for division, 2 ULP for `inversesqrt`, 3 + 2|x| ULP for `exp`, 3 ULP for `log`, 2^-11 for
//! sines within -pi to pi and |x| * 2^-12 outside, 4096 ULP for arc tangents.

use super::bytecode::ImpreciseOp;
use super::compile::options::ErrorDirection;
use super::row::{floats, of_floats};
use std::f32::consts::PI;
use wide::{f32x8, i32x8};

const ALL: f32x8 = f32x8::new([f32::from_bits(u32::MAX); 8]);

/// One ULP (unit in the last place) of a number between 1 and 2.
const UNIT: f32 = 1.0 / 8_388_608.0;

/// A result with the maximum permitted error for its operand.
#[inline]
pub(super) fn imprecise(
    what: ImpreciseOp,
    direction: ErrorDirection,
    result: f32x8,
    operand: f32x8,
) -> f32x8 {
    let size = operand.abs();
    let side = match direction {
        ErrorDirection::Out => f32x8::ONE,
        ErrorDirection::In => -f32x8::ONE,
        ErrorDirection::Either => {
            // Multiplicative hash: the top bits of the product are pseudo-random.
            let thrown = of_floats(result) * i32x8::splat(0x9e37_79b1_u32 as i32);
            let sign = thrown & i32x8::splat(i32::MIN);
            floats(sign | of_floats(f32x8::ONE))
        }
    };
    let units = |count: f32x8| result * (f32x8::ONE + side * count * UNIT);
    let made = match what {
        ImpreciseOp::Quotient => units(f32x8::splat(2.5)),
        ImpreciseOp::InverseSqrt => units(f32x8::splat(2.0)),
        ImpreciseOp::Exponential => units(size * 2.0 + 3.0),
        ImpreciseOp::Logarithm => {
            let is_near_one = operand.simd_ge(f32x8::HALF) & operand.simd_le(f32x8::splat(2.0));
            let near = result + side * f32x8::splat(4.0 * UNIT);
            is_near_one.bitselect(near, units(f32x8::splat(3.0)))
        }
        ImpreciseOp::Sine => {
            let within = f32x8::splat(1.0 / 2048.0);
            let error = size
                .simd_le(f32x8::splat(PI))
                .bitselect(within, size * (1.0 / 4096.0));
            let made = result + side * error;
            made.fast_max(-f32x8::ONE).fast_min(f32x8::ONE)
        }
        ImpreciseOp::ArcTangent => units(f32x8::splat(4096.0)),
    };
    // Always exact: zero, NaN and infinity.
    let is_usual = (result.simd_eq(f32x8::ZERO) | result.is_nan() | result.is_inf()) ^ ALL;
    let keeps_zero = !matches!(what, ImpreciseOp::Sine);
    match keeps_zero {
        true => is_usual.bitselect(made, result),
        false => (result.is_nan() ^ ALL).bitselect(made, result),
    }
}
