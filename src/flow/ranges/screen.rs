//! Pixel coordinates: linear combinations of `gl_FragCoord` and `iResolution`.

use super::Query;
use super::interval::{Interval, Tightness, below};
use crate::reaching_definitions::Def;
use shaderlint_ir::{Binary, OpId, OpKind, Unary};
use shaderlint_semantic::VariableId;

/// Maximum number of operations expanded per query.
const BUDGET: u32 = 32;

/// `place * gl_FragCoord[axis] + size * iResolution[axis]`
#[derive(Clone, Copy, Debug)]
struct ScreenTerm {
    axis: u32,
    place: f64,
    size: f64,
}

impl ScreenTerm {
    fn scaled(self, by: f64) -> ScreenTerm {
        ScreenTerm {
            place: self.place * by,
            size: self.size * by,
            ..self
        }
    }
}

impl Query<'_> {
    /// The range of `gl_FragCoord.x / iResolution.x`, `gl_FragCoord.x / iResolution.y` and the
    /// like, also with a multiple of the resolution subtracted first.
    pub(super) fn share(&self, a: OpId, b: OpId, lane: u32) -> Option<Interval> {
        let (size, along) = self.copied_from(b, lane)?;
        if !self.is_named(size, "iResolution") {
            return None;
        }
        let mut left = BUDGET;
        let part = self.along(a, lane, &mut left)?;
        if part.place == 0.0 {
            return None;
        }
        let (near, far) = (part.size, part.size + part.place);
        let (least, most) = (near.min(far), near.max(far));
        if part.axis == along {
            let range = Interval::new(least, most, Tightness::Touched);
            return Some(match far > near {
                true => Interval::new(least, below(most), Tightness::Touched),
                false => range,
            });
        }
        match least < 0.0 && most > 0.0 {
            true => Some(Interval::ANY.taking_both_signs()),
            false if least == 0.0 => Some(Interval::new(0.0, f64::INFINITY, Tightness::Touched)),
            false => None,
        }
    }

    /// Whether `a + sign * b` is negative on one side of the image and positive on the other.
    pub(super) fn is_centred(&self, a: OpId, b: OpId, lane: u32, sign: f64) -> bool {
        let mut left = BUDGET;
        let Some(first) = self.along(a, lane, &mut left) else {
            return false;
        };
        let Some(second) = self.along(b, lane, &mut left) else {
            return false;
        };
        let near = first.size + sign * second.size;
        let far = near + first.place + sign * second.place;
        first.axis == second.axis && near * far < 0.0
    }

    /// Whether `op` is a pixel coordinate, and its multiples of `period` lie between two quads of pixels, in
    /// which derivatives are taken.
    pub(crate) fn is_between_quads(&self, op: OpId, lane: u32, period: f64) -> bool {
        let mut left = BUDGET;
        self.along(op, lane, &mut left).is_some_and(|term| {
            let pixels = period / term.place;
            term.size == 0.0 && pixels.is_finite() && pixels % 2.0 == 0.0 && pixels != 0.0
        })
    }

    fn along(&self, op: OpId, lane: u32, left: &mut u32) -> Option<ScreenTerm> {
        *left = left.checked_sub(1)?;
        let (module, defs) = (self.module, self.defs);
        let constant = |op: OpId| match module.constant(op) {
            [value] => Some(value.as_number()),
            _ => None,
        };
        let factor = |op: OpId| match module.op(op).kind {
            OpKind::Splat(scalar) => constant(scalar),
            _ => constant(op),
        };
        match module.op(op).kind {
            OpKind::Load(_) => match defs.get(defs.unrefined(defs.seen(op, lane))) {
                Def::Stored { value, lane } => self.along(value, lane, left),
                _ => self.filled_in(op, lane),
            },
            OpKind::Unary(Unary::Negate, a) => Some(self.along(a, lane, left)?.scaled(-1.0)),
            OpKind::Binary(Binary::Multiply, a, b) => match (factor(a), factor(b)) {
                (Some(factor), _) => Some(self.along(b, lane, left)?.scaled(factor)),
                (_, Some(factor)) => Some(self.along(a, lane, left)?.scaled(factor)),
                _ => None,
            },
            OpKind::Binary(Binary::Divide, a, b) => {
                let divisor = factor(b).filter(|d| *d != 0.0)?;
                Some(self.along(a, lane, left)?.scaled(1.0 / divisor))
            }
            OpKind::Binary(kind @ (Binary::Add | Binary::Subtract), a, b) => {
                let sign = if kind == Binary::Add { 1.0 } else { -1.0 };
                let (a, b) = (self.along(a, lane, left)?, self.along(b, lane, left)?);
                (a.axis == b.axis).then_some(ScreenTerm {
                    axis: a.axis,
                    place: a.place + sign * b.place,
                    size: a.size + sign * b.size,
                })
            }
            _ => {
                let (part, lane) = defs.part_of(module, op, lane)?;
                self.along(part, lane, left)
            }
        }
    }

    fn filled_in(&self, op: OpId, lane: u32) -> Option<ScreenTerm> {
        let (id, axis) = self.copied_from(op, lane)?;
        let is_place = self.is_named(id, "gl_FragCoord");
        let is_size = self.is_named(id, "iResolution");
        (axis < 2 && (is_place || is_size)).then_some(ScreenTerm {
            axis,
            place: if is_place { 1.0 } else { 0.0 },
            size: if is_size { 1.0 } else { 0.0 },
        })
    }

    fn is_named(&self, id: VariableId, name: &str) -> bool {
        let variable = self.program.variable(id);
        variable.is_some_and(|v| self.program.names.text(v.name) == name)
    }
}
