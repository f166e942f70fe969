//! Where the rays of a loop start, and whether another ray loop found that point.

use super::dependence::ValueLane;
use super::step::{RayOrigin, Stepped};
use crate::ranges::Query;
use crate::reaching_definitions::{Def, DefId};
use rustc_hash::FxHashSet;
use shaderlint_ir::{LoopId, OpKind};
use shaderlint_semantic::builtins::Transfer;
use std::cell::Cell;

/// Most values that are followed per loop.
const MAX_NODES: u32 = 6000;

/// Finds where rays start.
pub(super) struct Starts<'a> {
    query: Query<'a>,
    /// All ray loops.
    loops: &'a [LoopId],
    /// By function: whether it contains a ray loop, or calls such a function.
    marching: &'a [bool],
    left: Cell<u32>,
}

#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum StartNode {
    Lane(ValueLane),
    Def(DefId),
}

impl<'a> Starts<'a> {
    pub fn new(query: Query<'a>, loops: &'a [LoopId], marching: &'a [bool]) -> Starts<'a> {
        Starts {
            query,
            loops,
            marching,
            left: Cell::new(0),
        }
    }

    /// Takes one unit of the work that is left; `None` if there is none.
    fn spend(&self) -> Option<()> {
        self.left.set(self.left.get().checked_sub(1)?);
        Some(())
    }

    /// The components of the position where the rays of a loop start, in the functions that compute it;
    /// `None` if they start at a point that a ray loop found.
    pub fn of(&self, stepped: &Stepped) -> Option<Vec<ValueLane>> {
        self.left.set(MAX_NODES);
        let mut from: Vec<StartNode> = stepped.init.iter().copied().map(StartNode::Def).collect();
        let position: Vec<StartNode> = match stepped.origin {
            RayOrigin::Init => from.clone(),
            RayOrigin::Value(op) => (0..3).map(|lane| StartNode::Lane((op, lane))).collect(),
            RayOrigin::Zero => Vec::new(),
            RayOrigin::Unknown => return None,
        };
        from.extend(&position);
        if !from.iter().all(|node| self.is_first(*node)) {
            return None;
        }
        let mut found = Vec::new();
        position
            .into_iter()
            .for_each(|node| self.origins(node, 8, &mut found));
        Some(found)
    }

    /// Whether a value does not depend on the result of a ray loop. For a parameter, one call with such
    /// a value is enough.
    fn is_first(&self, from: StartNode) -> bool {
        self.is_first_within(from, 4)
    }

    fn is_first_within(&self, from: StartNode, calls: u32) -> bool {
        let (module, defs) = (self.query.module, self.query.defs);
        let mut todo = vec![from];
        let mut seen = FxHashSet::default();
        while let Some(node) = todo.pop() {
            if !seen.insert(node) {
                continue;
            }
            if self.spend().is_none() {
                return false;
            }
            let (op, lane) = match node {
                StartNode::Lane(lane) => lane,
                StartNode::Def(def) => {
                    if !self.def(def, calls, &mut todo) {
                        return false;
                    }
                    continue;
                }
            };
            match module.op(op).kind {
                OpKind::Load(_) => {
                    todo.push(StartNode::Def(defs.unrefined(defs.seen(op, lane))));
                    continue;
                }
                OpKind::Call(function, _)
                    if self.marching.get(function.0 as usize) != Some(&false) =>
                {
                    return false;
                }
                _ => {}
            }
            if let Some(part) = defs.part_of(module, op, lane) {
                todo.push(StartNode::Lane(part));
                continue;
            }
            module.each_operand(op, |operand| {
                let lanes = 0..defs.lanes_of(operand).max(1);
                todo.extend(lanes.map(|lane| StartNode::Lane((operand, lane))));
            });
        }
        true
    }

    /// Follows a definition; `false` if a ray loop made it.
    fn def(&self, def: DefId, calls: u32, todo: &mut Vec<StartNode>) -> bool {
        let (module, defs) = (self.query.module, self.query.defs);
        let def = defs.unrefined(def);
        let is_found = |id: &LoopId| defs.made_in(*id).contains(&def);
        if self.loops.iter().any(is_found) && !matches!(defs.get(def), Def::Entry(_)) {
            return false;
        }
        match defs.get(def) {
            Def::Stored { value, lane } => todo.push(StartNode::Lane((value, lane))),
            Def::Merge { sides, .. } | Def::Measured(sides) => {
                todo.extend(defs.list(sides).iter().copied().map(StartNode::Def));
            }
            // The first iteration of a loop over samples or bounces.
            Def::Head { init, .. } => todo.push(StartNode::Def(init)),
            Def::Refined { of, .. } => todo.push(StartNode::Def(of)),
            Def::Entry(slot) => match (defs.passed(module, slot), calls.checked_sub(1)) {
                (Some(passed), Some(rest)) => {
                    let mut args = passed.args();
                    let lane = passed.lane;
                    return args
                        .any(|arg| self.is_first_within(StartNode::Lane((arg, lane)), rest));
                }
                (Some(_), None) => return false,
                (None, _) => {
                    todo.extend(defs.global_writes(slot).iter().copied().map(StartNode::Def))
                }
            },
            Def::Unknown => return false,
        }
        true
    }

    /// Follows copies of a component into the callers.
    fn origins(&self, node: StartNode, depth: u32, found: &mut Vec<ValueLane>) {
        let (module, defs) = (self.query.module, self.query.defs);
        let (Some(rest), Some(())) = (depth.checked_sub(1), self.spend()) else {
            return;
        };
        match node {
            StartNode::Lane((op, lane)) => {
                let next = match module.op(op).kind {
                    OpKind::Load(_) => {
                        let def = defs.unrefined(defs.seen(op, lane));
                        let is_copied = matches!(
                            defs.get(def),
                            Def::Stored { .. } | Def::Head { .. }
                        ) || matches!(defs.get(def), Def::Entry(slot) if defs.passed(module, slot).is_some());
                        is_copied.then_some(StartNode::Def(def))
                    }
                    OpKind::Convert(a) => Some(StartNode::Lane((a, lane))),
                    OpKind::Builtin(function, list)
                        if matches!(function.transfer(), Transfer::Rounded(_)) =>
                    {
                        let first = module.operands(list).first();
                        first.map(|a| StartNode::Lane((*a, lane)))
                    }
                    _ => defs.part_of(module, op, lane).map(StartNode::Lane),
                };
                match next {
                    Some(next) => self.origins(next, rest, found),
                    None => found.push((op, lane)),
                }
            }
            StartNode::Def(def) => match defs.get(defs.unrefined(def)) {
                Def::Stored { value, lane } => {
                    self.origins(StartNode::Lane((value, lane)), rest, found)
                }
                Def::Head { init, .. } => self.origins(StartNode::Def(init), rest, found),
                Def::Entry(slot) => {
                    if let Some(passed) = defs.passed(module, slot) {
                        let lane = passed.lane;
                        let own = passed.args().map(|arg| StartNode::Lane((arg, lane)));
                        let own = own.filter(|node| self.is_first(*node));
                        own.for_each(|node| self.origins(node, rest, found));
                    }
                }
                Def::Merge { sides, .. } => {
                    for side in defs.list(sides) {
                        self.origins(StartNode::Def(*side), rest, found);
                    }
                }
                _ => {}
            },
        }
    }
}
