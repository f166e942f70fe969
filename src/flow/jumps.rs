//! Discontinuities: values that jump between neighbouring pixels, so that their derivatives are
//! meaningless there.

use super::ranges::Query;
use super::trace::{Start, trace};
use super::uniformity::{Uniformity, Varying};
use shaderlint_ir::{Binary, OpId, OpKind, Unary};
use shaderlint_semantic::BuiltinId;

/// A call of a built-in function that is discontinuous.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Jump {
    /// The `Builtin` operation.
    pub call: OpId,
    /// The called built-in function.
    pub function: BuiltinId,
}

/// The discontinuous call that a component depends on through sums and products only. `None` where
/// other terms may cancel the jump.
pub fn jump(ranges: Query, uniformity: &Uniformity, (op, lane): (OpId, u32)) -> Option<Jump> {
    let Query { module, defs, .. } = ranges;
    let mut found: Vec<Jump> = Vec::new();
    let mut is_mixed = false;
    trace(module, defs, (op, lane), |origin| {
        let Start::Made(call, lane) = origin else {
            is_mixed |= varies(uniformity, origin);
            return false;
        };
        match module.op(call).kind {
            OpKind::Unary(Unary::Negate, _) | OpKind::Convert(_) => true,
            OpKind::Binary(Binary::Add | Binary::Subtract, ..) => true,
            OpKind::Binary(Binary::Multiply | Binary::Divide, ..) => true,
            OpKind::Builtin(function, operands) if jumps(function, operands.len) => {
                let operands = module.operands(operands);
                let mut varying = operands
                    .iter()
                    .map(|o| uniformity.varies(Varying::Value(*o)));
                if varying.any(|v| v) && !is_within(ranges, function, operands, lane) {
                    found.push(Jump { call, function });
                }
                false
            }
            _ => {
                is_mixed |= varies(uniformity, origin);
                false
            }
        }
    });
    // Other terms may cancel the jumps of rounding, as in `floor(p) + smooth(p - floor(p))`.
    let is_rounded = found.iter().any(|j| rounds(j.function));
    let is_integer = is_rounded && (is_mixed || found.iter().any(|j| !rounds(j.function)));
    found
        .into_iter()
        .find(|j| !is_integer || j.function == BuiltinId::Atan)
}

/// Whether the arguments stay within one continuous piece of the function.
fn is_within(ranges: Query, function: BuiltinId, operands: &[OpId], lane: u32) -> bool {
    let at = |position: usize| {
        let op = *operands.get(position)?;
        Some((op, ranges.module.operand_lane(op, lane)))
    };
    let of = |position: usize| at(position).map(|(op, lane)| ranges.lane(op, lane));
    let Some(x) = of(0) else { return false };
    let period = match function {
        BuiltinId::Mod => of(1).and_then(|y| y.single()),
        BuiltinId::Floor | BuiltinId::Ceil | BuiltinId::Fract => Some(1.0),
        _ => None,
    };
    if let (Some(period), Some((op, lane))) = (period, at(0))
        && ranges.is_between_quads(op, lane, period)
    {
        return true;
    }
    match (function, of(1)) {
        // `atan(y, x)` has its branch cut where `y` changes sign at negative `x`.
        (BuiltinId::Atan, Some(right)) => {
            right.lo.value >= 0.0 || x.lo.value > 0.0 || x.hi.value < 0.0
        }
        (BuiltinId::Mod, Some(y)) => x.lo.value >= 0.0 && x.hi.value < y.lo.value,
        _ => x.lo.value.floor() == x.hi.value.floor(),
    }
}

fn varies(uniformity: &Uniformity, origin: Start) -> bool {
    uniformity.varies(match origin {
        Start::Made(op, _) => Varying::Value(op),
        Start::Given(variable, _) => Varying::Variable(variable),
    })
}

const fn rounds(function: BuiltinId) -> bool {
    use BuiltinId::{Ceil, Floor, Round, RoundEven, Trunc};
    matches!(function, Floor | Ceil | Round | RoundEven | Trunc)
}

const fn jumps(function: BuiltinId, operands: u32) -> bool {
    use BuiltinId::{Atan, Fract, Mod};
    match function {
        Atan => operands == 2,
        Fract | Mod => true,
        _ => rounds(function),
    }
}
