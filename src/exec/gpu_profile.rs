//! Results with the maximum error that a GPU may have (VK-GL-CTS, glsBuiltinPrecisionTests): 2.5
//! ULP for division, 2 ULP for `inversesqrt`, 3 + 2|x| ULP for `exp`, 3 ULP for `log`, 2^-11 for
//! sines within -pi to pi and |x| * 2^-12 outside, 4096 ULP for arc tangents.

use super::bytecode::ImpreciseOp;
use super::options::ErrorDirection;
use super::row::{floats, of_floats};
use fearless_simd::{f32x8, prelude::*};
use std::f32::consts::PI;

/// One ULP (unit in the last place) of a number between 1 and 2.
const UNIT: f32 = 1.0 / 8_388_608.0;

/// A result with the maximum permitted error for its operand.
#[inline(always)]
pub(super) fn imprecise<S: Simd>(
    what: ImpreciseOp,
    direction: ErrorDirection,
    result: f32x8<S>,
    operand: f32x8<S>,
) -> f32x8<S> {
    let (size, one) = (operand.abs(), f32x8::splat(result.token(), 1.0));
    let side = match direction {
        ErrorDirection::Out => one,
        ErrorDirection::In => -one,
        ErrorDirection::Either => {
            // Multiplicative hash: the top bits of the product are pseudo-random.
            let thrown = of_floats(result) * 0x9e37_79b1;
            floats((thrown & 0x8000_0000) | of_floats(one))
        }
    };
    let units = |count: f32x8<S>| result * (one + side * count * UNIT);
    let made = match what {
        ImpreciseOp::Quotient => units(one * 2.5),
        ImpreciseOp::InverseSqrt => units(one * 2.0),
        ImpreciseOp::Exponential => units(size * 2.0 + 3.0),
        ImpreciseOp::Logarithm => {
            let is_near_one = operand.simd_ge(0.5) & operand.simd_le(2.0);
            let near = result + side * (4.0 * UNIT);
            is_near_one.select(near, units(one * 3.0))
        }
        ImpreciseOp::Sine => {
            let within = one * (1.0 / 2048.0);
            let error = size.simd_le(PI).select(within, size * (1.0 / 4096.0));
            let made = result + side * error;
            let above = made.simd_gt(-one).select(made, -one);
            above.simd_lt(one).select(above, one)
        }
        ImpreciseOp::ArcTangent => units(one * 4096.0),
    };
    // Always exact: zero, NaN and infinity.
    let is_exact = match what {
        ImpreciseOp::Sine => result.is_nan(),
        _ => result.simd_eq(0.0) | !result.is_finite(),
    };
    is_exact.select(result, made)
}
