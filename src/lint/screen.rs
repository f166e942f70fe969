//! Values that are linear in the pixel coordinates.

use super::facts::Facts;
use shaderlint_flow::ranges::Interval;
use shaderlint_flow::{Start, Varying};
use shaderlint_ir::{Binary, OpId, OpKind, Unary};
use shaderlint_semantic::Scalar;

/// Most operations that are followed.
const MAX_DEPTH: u32 = 12;

/// A value that changes by a constant from each pixel to the next.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Along {
    /// 0 for `gl_FragCoord.x`, 1 for `gl_FragCoord.y`.
    pub axis: u32,
    /// Change per pixel, before the division by `share_of`.
    pub scale: f64,
    /// The component of `iResolution` that it is divided by.
    pub share_of: Option<u32>,
    /// Range of the constant term.
    pub offset: Interval,
}

/// The linear form of a component; `None` if it is not linear in the pixel coordinates.
pub fn along(facts: &Facts, op: OpId, lane: u32) -> Option<Along> {
    within(facts, op, lane, MAX_DEPTH)
}

fn within(facts: &Facts, op: OpId, lane: u32, depth: u32) -> Option<Along> {
    let rest = depth.checked_sub(1)?;
    let module = facts.module();
    let start = facts.origin(op, lane)?;
    let (made, lane) = match start {
        Start::Given(_, axis @ (0 | 1)) if facts.is_given(Some(start), "gl_FragCoord") => {
            return Some(Along {
                axis,
                scale: 1.0,
                share_of: None,
                offset: Interval::constant(0.0),
            });
        }
        Start::Given(..) => return None,
        Start::Made(made, lane) => (made, lane),
    };
    let lane_of = |op: OpId| module.operand_lane(op, lane);
    let of = |op| within(facts, op, lane_of(op), rest);
    // A value that is the same for all pixels.
    let shared = |op| {
        let is_shared = !facts.uniformity().varies(Varying::Value(op));
        is_shared.then(|| facts.ranges().lane(op, lane_of(op)))
    };
    let number = |op| facts.ranges().lane(op, lane_of(op)).single();
    let scaled = |a: Along, by: f64| Along {
        scale: a.scale * by,
        offset: a.offset * Interval::constant(by),
        ..a
    };
    match module.op(made).kind {
        OpKind::Convert(a) => {
            let is_number = module.scalar(a) != Some(Scalar::Bool);
            of(a).filter(|_| is_number)
        }
        OpKind::Unary(Unary::Negate, a) => Some(scaled(of(a)?, -1.0)),
        OpKind::Binary(Binary::Add, a, b) => match shared(b) {
            Some(by) => of(a).map(|a| moved(a, by)),
            None => Some(moved(of(b)?, shared(a)?)),
        },
        OpKind::Binary(Binary::Subtract, a, b) => match shared(b) {
            Some(by) => of(a).map(|a| moved(a, -by)),
            None => Some(moved(scaled(of(b)?, -1.0), shared(a)?)),
        },
        OpKind::Binary(Binary::Multiply, a, b) => match number(b) {
            Some(by) => Some(scaled(of(a)?, by)),
            None => Some(scaled(of(b)?, number(a)?)),
        },
        OpKind::Binary(Binary::Divide, a, b) => match number(b) {
            Some(by) if by != 0.0 => Some(scaled(of(a)?, 1.0 / by)),
            _ => {
                let size = facts.origin(b, lane_of(b))?;
                let Start::Given(_, component) = size else {
                    return None;
                };
                let all = of(a).filter(|a| a.share_of.is_none())?;
                let is_size = facts.is_given(Some(size), "iResolution");
                is_size.then_some(Along {
                    share_of: Some(component),
                    offset: Interval::ANY,
                    ..all
                })
            }
        },
        _ => None,
    }
}

fn moved(a: Along, by: Interval) -> Along {
    Along {
        offset: a.offset + by,
        ..a
    }
}
