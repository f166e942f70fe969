//! Ranges of matrix and vector products.

use super::Query;
use super::interval::Interval;
use super::node::{GetRange, Node};
use shaderlint_ir::{OpId, column_lanes};

/// The terms of one component of a product: the first index and the stride of the factors on each
/// side.
#[derive(Clone, Copy, Debug)]
struct Terms {
    count: u32,
    left: (u32, u32),
    right: (u32, u32),
}

impl Query<'_> {
    /// The range of a component of a product, which is a sum of products.
    pub(super) fn product(
        &self,
        op: OpId,
        (a, b): (OpId, OpId),
        lane: u32,
        get: &mut impl GetRange,
    ) -> Option<Interval> {
        // A matrix may rotate or mirror, so each component may take either sign.
        let unknown = Interval {
            sources: 1 << ((op.0 * 4 + lane) % 64),
            ..Interval::ANY
        };
        let Some(terms) = self.multiplied(a, b, lane) else {
            return Some(unknown);
        };
        let mut of = |op: OpId, (first, step): (u32, u32), number: u32| {
            let node = Node::lane(self.defs, op, first + step * number);
            node.map_or(Some(Interval::ANY), &mut *get)
        };
        let mut sum: Option<Interval> = None;
        let (mut is_made, mut is_rotation) = (true, true);
        let mut sources = 0;
        for number in 0..terms.count {
            let pair = of(a, terms.left, number).zip(of(b, terms.right, number));
            let Some((x, y)) = pair else {
                is_made = false;
                continue;
            };
            let term = x * y;
            sum = Some(sum.map_or(term, |sum| sum + term));
            // For every matrix, there are vectors that give the component either sign.
            let vector = if self.module.ty(a).is_matrix() { y } else { x };
            let matrix = if self.module.ty(a).is_matrix() { x } else { y };
            is_rotation &= vector.takes_both_signs() && vector.sources & sources == 0;
            is_rotation &= matrix.is_free_of(&vector) && matrix.single() != Some(0.0);
            sources |= vector.sources;
        }
        let sum = sum.filter(|_| is_made)?;
        let is_vector = self.module.ty(op).is_vector();
        let known = Interval {
            sources: unknown.sources,
            ..sum.loose()
        };
        Some(match is_rotation && is_vector {
            true => known.taking_both_signs(),
            false => known,
        })
    }

    fn multiplied(&self, a: OpId, b: OpId, lane: u32) -> Option<Terms> {
        let (_, columns, rows) = self.module.ty(a).numeric()?;
        let (_, right_columns, right_rows) = self.module.ty(b).numeric()?;
        let (height, right_height) = (column_lanes(rows), column_lanes(right_rows));
        Some(match (columns, right_columns) {
            (1, _) => Terms {
                count: rows as u32,
                left: (0, 1),
                right: (lane * right_height, 1),
            },
            (_, 1) => Terms {
                count: columns as u32,
                left: (lane, height),
                right: (0, 1),
            },
            _ => Terms {
                count: columns as u32,
                left: (lane % height, height),
                right: (lane / height * right_height, 1),
            },
        })
    }
}
