//! Decomposes conditions into comparisons, and comparisons into the values that they constrain.

use super::def::{Def, DefId, Hop, Premise, ReachingDefinitions, Refinement};
use crate::same::is_same;
use shaderlint_ir::{Binary, Module, OpId, OpKind, Unary, length_lane};
use shaderlint_semantic::BuiltinId;
use shaderlint_semantic::builtins::Transfer;

/// Maximum number of parts of a condition, and of a comparison, that are visited.
const MAX_PARTS: usize = 24;
/// Maximum number of hops from a comparison to a load.
const MAX_HOPS: u8 = 16;

/// Calls `each` with every comparison, or other atomic condition, that is known to be true or false
/// if `condition` has the value `truth`.
pub fn each_comparison(
    module: &Module,
    defs: &ReachingDefinitions,
    condition: OpId,
    truth: bool,
    mut each: impl FnMut(Premise),
) {
    let mut parts = ConditionWalk {
        module,
        defs,
        left: MAX_PARTS,
        call: None,
        each: &mut each,
    };
    parts.condition(condition, truth);
}

/// A depth-first walk over the parts of a condition, left to right, up to a limit.
struct ConditionWalk<'a, F> {
    module: &'a Module,
    defs: &'a ReachingDefinitions,
    left: usize,
    call: Option<OpId>,
    each: &'a mut F,
}

impl<F: FnMut(Premise)> ConditionWalk<'_, F> {
    fn condition(&mut self, at: OpId, truth: bool) {
        if self.left == 0 {
            return;
        }
        self.left -= 1;
        let premise = Premise {
            comparison: at,
            truth,
            call: self.call,
        };
        match self.module.op(at).kind {
            OpKind::Unary(Unary::Not, inner) => self.condition(inner, !truth),
            OpKind::Binary(Binary::And, a, b) if truth => {
                self.condition(a, true);
                self.condition(b, true);
            }
            OpKind::Binary(Binary::Or, a, b) if !truth => {
                self.condition(a, false);
                self.condition(b, false);
            }
            OpKind::Binary(op, ..) if op.compares() => (self.each)(premise),
            OpKind::Same { left, negated, .. } => {
                // For vectors that differ, the differing component is not known.
                let ty = self.module.ty(left);
                if ty.is_scalar() || ty.is_vector() && truth != negated {
                    (self.each)(premise);
                }
            }
            OpKind::Load(_) => self.held(self.defs.seen(at, 0), truth),
            // A function that only returns a condition.
            OpKind::Call(function, _) if self.call.is_none() => {
                if let Some(value) = self.defs.value_of(function) {
                    self.call = Some(at);
                    self.condition(value, truth);
                    self.call = None;
                }
            }
            _ => {}
        }
    }

    /// Decomposes the value of a `bool` variable that is known to be true or false.
    fn held(&mut self, def: DefId, truth: bool) {
        let (module, defs) = (self.module, self.defs);
        let value = |def| match defs.get(defs.unrefined(def)) {
            Def::Stored { value, .. } => Some(value),
            _ => None,
        };
        if let Some(value) = value(def) {
            return self.condition(value, truth);
        }
        let Def::Merge {
            sides,
            condition: Some(condition),
            ..
        } = defs.get(defs.unrefined(def))
        else {
            return;
        };
        let &[then, otherwise] = defs.list(sides) else {
            return;
        };
        let (then, otherwise) = (value(then), value(otherwise));
        let is_out = |side: Option<OpId>, met: bool| {
            side.is_some_and(|value| match module.constant(value) {
                [known] => known.as_bool() != truth,
                _ => value == condition && met != truth,
            })
        };
        // The side that gives the opposite answer was not taken.
        let (met, taken) = match (is_out(otherwise, false), is_out(then, true)) {
            (true, _) => (true, then),
            (_, true) => (false, otherwise),
            _ => return,
        };
        self.condition(condition, met);
        if let Some(value) = taken.filter(|v| *v != condition) {
            self.condition(value, truth);
        }
    }
}

/// The two operands of a comparison.
pub(super) fn sides(module: &Module, comparison: OpId) -> Option<(OpId, OpId)> {
    match module.op(comparison).kind {
        OpKind::Binary(_, left, right) | OpKind::Same { left, right, .. } => Some((left, right)),
        _ => None,
    }
}

/// Calls `each` with every load that a comparison constrains: the load, its component, and the path
/// to it.
pub fn each_load(
    module: &Module,
    defs: &ReachingDefinitions,
    premise: Premise,
    mut each: impl FnMut(OpId, u32, Refinement),
) {
    let Premise {
        comparison,
        truth,
        call,
    } = premise;
    let Some((left, right)) = sides(module, comparison) else {
        return;
    };
    let mut loads = Loads {
        module,
        defs,
        left: MAX_PARTS,
        each: &mut each,
    };
    for lane in 0..module.ty(left).components() as u8 {
        for (is_right, side) in [(false, left), (true, right)] {
            let way = Refinement {
                comparison,
                truth,
                is_right,
                lane,
                path: 0,
                hops: 0,
                call,
            };
            loads.part(side, lane as u32, way);
        }
    }
}

/// A walk over the operands of a comparison.
struct Loads<'a, F> {
    module: &'a Module,
    defs: &'a ReachingDefinitions,
    left: usize,
    each: &'a mut F,
}

impl<F: FnMut(OpId, u32, Refinement)> Loads<'_, F> {
    fn part(&mut self, op: OpId, lane: u32, way: Refinement) {
        if self.left == 0 {
            return;
        }
        self.left -= 1;
        if let OpKind::Load(_) = self.module.op(op).kind {
            (self.each)(op, lane, way);
        }
        if way.hops >= MAX_HOPS {
            return;
        }
        for choice in 0..3 {
            if let Some((op, lane)) = way.hop(self.module, self.defs, op, lane, choice) {
                let path = way.path | (choice as u32) << (2 * way.hops);
                let hops = way.hops + 1;
                self.part(op, lane, Refinement { path, hops, ..way });
            }
        }
    }
}

impl Refinement {
    /// The operations from one side of the comparison down to the constrained load.
    pub fn way(self, module: &Module, defs: &ReachingDefinitions) -> impl Iterator<Item = Hop> {
        let first = sides(module, self.comparison);
        let lane = self.lane as u32;
        let mut at = first.map(|(l, r)| (if self.is_right { r } else { l }, lane));
        let mut number = 0;
        std::iter::from_fn(move || {
            let (op, lane) = at?;
            let choice = (number < self.hops).then(|| (self.path >> (2 * number) & 3) as u8);
            number += 1;
            at = choice.and_then(|choice| self.hop(module, defs, op, lane, choice));
            Some(Hop { op, lane, choice })
        })
    }

    /// The operand that is constrained if a component of an operation is.
    fn hop(
        self,
        module: &Module,
        defs: &ReachingDefinitions,
        op: OpId,
        lane: u32,
        choice: u8,
    ) -> Option<(OpId, u32)> {
        if defs.is_element(module, op) {
            return None;
        }
        match (module.op(op).kind, choice) {
            (OpKind::Load(_), 0) => match defs.get(defs.unrefined(defs.seen(op, lane))) {
                Def::Stored { value, lane } => Some((value, lane)),
                Def::Entry(slot) => defs.argument(module, self.call?, slot),
                _ => None,
            },
            _ => operand(module, defs, op, lane, choice),
        }
    }
}

/// See [`Refinement::hop`].
fn operand(
    module: &Module,
    defs: &ReachingDefinitions,
    op: OpId,
    lane: u32,
    choice: u8,
) -> Option<(OpId, u32)> {
    let found = module.op(op);
    let is_length = length_lane(found.ty) == Some(lane);
    match (found.kind, choice) {
        (OpKind::Unary(Unary::Negate, a) | OpKind::Convert(a), 0) => Some((a, lane)),
        (OpKind::Binary(kind, a, b), 0 | 1) if !is_length => {
            use Binary::*;
            let operand = if choice == 0 { a } else { b };
            matches!(kind, Add | Subtract | Multiply | Divide).then_some((operand, lane))
        }
        (OpKind::Builtin(function, list), _) if !is_length => {
            let args = module.operands(list);
            argument(module, defs, function, args, lane, choice)
        }
        (_, 0) => defs.part_of(module, op, lane),
        _ => None,
    }
}

/// The argument of a built-in function that its result constrains.
fn argument(
    module: &Module,
    defs: &ReachingDefinitions,
    function: BuiltinId,
    args: &[OpId],
    lane: u32,
    choice: u8,
) -> Option<(OpId, u32)> {
    let arg = *args.get(choice as usize)?;
    let length = || Some((arg, length_lane(module.ty(arg)).unwrap_or(0)));
    let own_lane = module.operand_lane(arg, lane);
    match (function.transfer(), choice) {
        (Transfer::Norm, 0) => length(),
        (Transfer::Product, 0) => match args {
            [a, b] if is_same(module, defs, *a, *b) => length(),
            _ => None,
        },
        (Transfer::Minimum | Transfer::Maximum, 0 | 1)
        | (Transfer::Magnitude | Transfer::Rounded(_), 0) => Some((arg, own_lane)),
        _ if function == BuiltinId::Sqrt && choice == 0 => Some((arg, own_lane)),
        _ => None,
    }
}
