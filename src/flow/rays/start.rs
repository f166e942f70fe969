//! Where the rays of a loop start, and whether another ray loop found that point.

use super::dependence::Lane;
use super::step::{Origin, Stepped};
use crate::ranges::Query;
use crate::reaching_definitions::{Def, DefId};
use rustc_hash::FxHashSet;
use shaderlint_ir::{LoopId, OpKind};
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
enum Node {
    Lane(Lane),
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
    pub fn of(&self, stepped: &Stepped) -> Option<Vec<Lane>> {
        self.left.set(MAX_NODES);
        let mut from: Vec<Node> = stepped.init.iter().copied().map(Node::Def).collect();
        let position: Vec<Node> = match stepped.origin {
            Origin::Init => from.clone(),
            Origin::Value(op) => (0..3).map(|lane| Node::Lane((op, lane))).collect(),
            Origin::Zero => Vec::new(),
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
    fn is_first(&self, from: Node) -> bool {
        self.is_first_within(from, 4)
    }

    fn is_first_within(&self, from: Node, calls: u32) -> bool {
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
                Node::Lane(lane) => lane,
                Node::Def(def) => {
                    if !self.def(def, calls, &mut todo) {
                        return false;
                    }
                    continue;
                }
            };
            match module.op(op).kind {
                OpKind::Load(_) => {
                    todo.push(Node::Def(defs.unrefined(defs.seen(op, lane))));
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
                todo.push(Node::Lane(part));
                continue;
            }
            module.each_operand(op, |operand| {
                let lanes = 0..defs.lanes_of(operand).max(1);
                todo.extend(lanes.map(|lane| Node::Lane((operand, lane))));
            });
        }
        true
    }

    /// Follows a definition; `false` if a ray loop made it.
    fn def(&self, def: DefId, calls: u32, todo: &mut Vec<Node>) -> bool {
        let (module, defs) = (self.query.module, self.query.defs);
        let def = defs.unrefined(def);
        let is_found = |id: &LoopId| defs.made_in(*id).contains(&def);
        if self.loops.iter().any(is_found) && !matches!(defs.get(def), Def::Entry(_)) {
            return false;
        }
        match defs.get(def) {
            Def::Stored { value, lane } => todo.push(Node::Lane((value, lane))),
            Def::Merge { sides, .. } | Def::Measured(sides) => {
                todo.extend(defs.list(sides).iter().copied().map(Node::Def));
            }
            // The first iteration of a loop over samples or bounces.
            Def::Head { init, .. } => todo.push(Node::Def(init)),
            Def::Refined { of, .. } => todo.push(Node::Def(of)),
            Def::Entry(slot) => match (defs.passed(module, slot), calls.checked_sub(1)) {
                (Some(passed), Some(rest)) => {
                    let mut args = passed.args();
                    let lane = passed.lane;
                    return args.any(|arg| self.is_first_within(Node::Lane((arg, lane)), rest));
                }
                (Some(_), None) => return false,
                (None, _) => todo.extend(defs.global_writes(slot).iter().copied().map(Node::Def)),
            },
            Def::Unknown => return false,
        }
        true
    }

    /// Follows copies of a component into the callers.
    fn origins(&self, node: Node, depth: u32, found: &mut Vec<Lane>) {
        let (module, defs) = (self.query.module, self.query.defs);
        let (Some(rest), Some(())) = (depth.checked_sub(1), self.spend()) else {
            return;
        };
        match node {
            Node::Lane((op, lane)) => {
                let next = match module.op(op).kind {
                    OpKind::Load(_) => {
                        let def = defs.unrefined(defs.seen(op, lane));
                        let is_copied = matches!(
                            defs.get(def),
                            Def::Stored { .. } | Def::Head { .. }
                        ) || matches!(defs.get(def), Def::Entry(slot) if defs.passed(module, slot).is_some());
                        is_copied.then_some(Node::Def(def))
                    }
                    _ => defs.part_of(module, op, lane).map(Node::Lane),
                };
                match next {
                    Some(next) => self.origins(next, rest, found),
                    None => found.push((op, lane)),
                }
            }
            Node::Def(def) => match defs.get(defs.unrefined(def)) {
                Def::Stored { value, lane } => self.origins(Node::Lane((value, lane)), rest, found),
                Def::Head { init, .. } => self.origins(Node::Def(init), rest, found),
                Def::Entry(slot) => {
                    if let Some(passed) = defs.passed(module, slot) {
                        let lane = passed.lane;
                        let own = passed.args().map(|arg| Node::Lane((arg, lane)));
                        let own = own.filter(|node| self.is_first(*node));
                        own.for_each(|node| self.origins(node, rest, found));
                    }
                }
                Def::Merge { sides, .. } => {
                    for side in defs.list(sides) {
                        self.origins(Node::Def(*side), rest, found);
                    }
                }
                _ => {}
            },
        }
    }
}
