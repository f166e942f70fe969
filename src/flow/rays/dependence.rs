//! What a value in a loop depends on: a backward slice over definitions.

use super::form::SceneCall;
use crate::loops::is_invariant;
use crate::ranges::Query;
use crate::reaching_definitions::{Def, DefId};
use rustc_hash::FxHashSet;
use shaderlint_ir::{Binary, Loop, LoopId, OpId, OpKind, Unary};
use shaderlint_semantic::Scalar;
use shaderlint_semantic::builtins::Transfer;
use std::cell::Cell;

/// Most values that are followed per query.
const MAX_NODES: usize = 1500;
/// Most values that are followed per loop, over all queries.
const MAX_WORK: u32 = 30_000;

/// A component of a value.
pub(super) type ValueLane = (OpId, u32);

/// A value or definition of a slice.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum SliceNode {
    Lane(OpId, u32),
    Def(DefId),
}

/// Slices of the values in one loop.
pub(super) struct LoopSlice<'x> {
    pub query: Query<'x>,
    pub id: LoopId,
    pub looped: &'x Loop,
    left: Cell<u32>,
}

impl<'x> LoopSlice<'x> {
    pub fn new(query: Query<'x>, id: LoopId, looped: &'x Loop) -> LoopSlice<'x> {
        LoopSlice {
            query,
            id,
            looped,
            left: Cell::new(MAX_WORK),
        }
    }

    /// Takes one unit of the work that is left for this loop.
    pub fn spend(&self) -> Option<()> {
        let left = self.left.get().checked_sub(1)?;
        self.left.set(left);
        Some(())
    }

    /// Whether a value is loop-invariant.
    pub fn is_invariant(&self, op: OpId) -> bool {
        is_invariant(self.query, self.id, op)
    }

    /// Whether a definition is made in the loop.
    pub fn is_inside(&self, def: DefId) -> bool {
        self.query.defs.made_in(self.id).contains(&def)
    }

    /// Whether a value is a number in three or more dimensions.
    pub fn is_point(&self, op: OpId) -> bool {
        let ty = self.query.module.ty(op);
        ty.is_vector() && ty.components() >= 3 && ty.scalar_kind() != Some(Scalar::Bool)
    }

    /// Calls `visit` with the nodes that a component depends on, data only, the component itself first,
    /// and whether there is a point on the way. Where `visit` returns `false`, the walk does not go
    /// further. Returns whether the walk was complete.
    pub fn walk(&self, from: ValueLane, visit: impl FnMut(SliceNode, bool) -> bool) -> bool {
        self.walk_from(SliceNode::Lane(from.0, from.1), visit)
    }

    fn walk_from(&self, from: SliceNode, mut visit: impl FnMut(SliceNode, bool) -> bool) -> bool {
        let mut todo = vec![(from, false)];
        let mut seen = FxHashSet::default();
        while let Some((node, via)) = todo.pop() {
            if !seen.insert((node, via)) {
                continue;
            }
            if seen.len() > MAX_NODES || self.spend().is_none() {
                return false;
            }
            let is_first = |op| matches!(from, SliceNode::Lane(first, _) if first == op);
            let via =
                via || matches!(node, SliceNode::Lane(op, _) if !is_first(op) && self.is_point(op));
            if visit(node, via) {
                self.operands(node, |next| todo.push((next, via)));
            }
        }
        true
    }

    fn operands(&self, node: SliceNode, mut each: impl FnMut(SliceNode)) {
        let (module, defs) = (self.query.module, self.query.defs);
        let (op, lane) = match node {
            SliceNode::Lane(op, lane) => (op, lane),
            SliceNode::Def(def) => return self.sources(def, each),
        };
        if let OpKind::Load(_) = module.op(op).kind {
            return each(SliceNode::Def(defs.unrefined(defs.seen(op, lane))));
        }
        if let Some((part, lane)) = defs.part_of(module, op, lane) {
            return each(SliceNode::Lane(part, lane));
        }
        let is_whole = match module.op(op).kind {
            OpKind::Call(..) | OpKind::Returned(..) | OpKind::MatrixProduct(..) => true,
            OpKind::ExtractComputed { .. } | OpKind::Same { .. } => true,
            OpKind::Builtin(..) => module.ty(op).is_scalar(),
            _ => false,
        };
        module.each_operand(op, |operand| {
            let count = defs.lanes_of(operand).max(1);
            let lanes = match is_whole {
                true => 0..count,
                false if module.ty(operand).is_scalar() => 0..1,
                false => lane..lane + 1,
            };
            lanes.for_each(|lane| each(SliceNode::Lane(operand, lane)));
        });
    }

    fn sources(&self, def: DefId, mut each: impl FnMut(SliceNode)) {
        let defs = self.query.defs;
        let mut one = |def| each(SliceNode::Def(defs.unrefined(def)));
        match defs.get(def) {
            Def::Stored { value, lane } => each(SliceNode::Lane(value, lane)),
            Def::Merge { sides, .. } | Def::Measured(sides) => {
                defs.list(sides).iter().copied().for_each(one);
            }
            Def::Head { of, back, .. } if of == self.id => one(back),
            Def::Head { init, back, .. } if self.is_inside(def) => {
                one(init);
                one(back);
            }
            Def::Refined { of, .. } => one(of),
            Def::Head { .. } | Def::Entry(_) | Def::Unknown => {}
        }
    }

    /// Whether a component depends on the value that these heads have at the start of an iteration; if
    /// `via_point`, through a point in three dimensions.
    pub fn depends(&self, from: ValueLane, heads: &[DefId], via_point: bool) -> bool {
        let mut found = false;
        self.walk(from, |node, via| {
            let SliceNode::Def(def) = node else {
                return true;
            };
            let is_head = heads.contains(&def);
            found |= is_head && (via || !via_point);
            !is_head && !found && self.is_inside(def)
        });
        found
    }

    /// Whether a definition in the loop depends on the value that a head has at the start of an
    /// iteration, other than through the position along the ray.
    pub fn def_depends(&self, from: DefId, head: DefId, moved: &[ValueLane]) -> bool {
        let mut found = false;
        let from = self.query.defs.unrefined(from);
        self.walk_from(SliceNode::Def(from), |node, _| {
            let def = match node {
                SliceNode::Lane(op, lane) => return !moved.contains(&(op, lane)),
                SliceNode::Def(def) => def,
            };
            found |= def == head;
            def != head && !found && self.is_inside(def)
        });
        found
    }

    /// The first call on the way from a component to these heads.
    pub fn called(&self, from: &[ValueLane], heads: &[DefId]) -> Option<SceneCall> {
        let mut found = None;
        for &lane in from {
            self.walk(lane, |node, _| match node {
                SliceNode::Lane(op, lane) => {
                    if found.is_none()
                        && let OpKind::Call(function, list) = self.query.module.op(op).kind
                    {
                        let depends = |argument: &&OpId| {
                            let mut lanes = 0..self.query.defs.lanes_of(**argument);
                            lanes.any(|lane| self.depends((**argument, lane), heads, false))
                        };
                        let arguments = (0..).zip(self.query.module.operands(list));
                        let mut moved = arguments
                            .filter(|(_, argument)| depends(argument))
                            .peekable();
                        if moved.peek().is_some() {
                            let mut points =
                                moved.filter(|(_, argument)| self.is_point(**argument));
                            found = Some(SceneCall {
                                function,
                                lane,
                                point: points.next().map(|(index, _)| index),
                            });
                        }
                    }
                    found.is_none()
                }
                SliceNode::Def(def) => {
                    found.is_none() && !heads.contains(&def) && self.is_inside(def)
                }
            });
        }
        found
    }

    /// The components that a distance consists of: itself, and what it is a multiple, a sum, the minimum
    /// or the like of. Heads of other values are followed into the previous iteration; the position along
    /// the ray is not part of a distance.
    pub fn cores(
        &self,
        from: ValueLane,
        heads: &[DefId],
        moved: &[ValueLane],
    ) -> FxHashSet<ValueLane> {
        let (module, defs) = (self.query.module, self.query.defs);
        let mut found = FxHashSet::default();
        self.walk(from, |node, _| {
            let (op, lane) = match node {
                SliceNode::Def(def) => return !heads.contains(&def) && self.is_inside(def),
                SliceNode::Lane(op, lane) => (op, lane),
            };
            if moved.contains(&(op, lane)) {
                return false;
            }
            found.insert((op, lane));
            if self.is_point(op) && !matches!(module.op(op).kind, OpKind::Load(_)) {
                // A vector of distances is followed only to the component that is used.
                return defs.part_of(module, op, lane).is_some();
            }
            match module.op(op).kind {
                OpKind::Load(_) | OpKind::Convert(_) | OpKind::Unary(Unary::Negate, _) => true,
                OpKind::Binary(kind, _, by) => match kind {
                    Binary::Add | Binary::Subtract | Binary::Multiply => true,
                    Binary::Divide => !self.depends((by, lane), heads, true),
                    _ => false,
                },
                OpKind::Select { .. } => true,
                OpKind::Builtin(function, _) => matches!(
                    function.transfer(),
                    Transfer::Minimum
                        | Transfer::Maximum
                        | Transfer::Between
                        | Transfer::Magnitude
                        | Transfer::Blend
                ),
                _ => defs.part_of(module, op, lane).is_some(),
            }
        });
        found
    }
}
