//! The solver for ranges: evaluates acyclic nodes directly, and strongly connected components by
//! fixed-point iteration.

use super::Query;
use super::interval::Interval;
use super::node::{Node, NodeSubject};
use crate::reaching_definitions::{Def, ReachingDefinitions};
use shaderlint_text::SetAt;
use std::cell::Cell;

/// Maximum number of ascending rounds; ranges that still change become unbounded.
const MAX_ROUNDS: usize = 12;
/// The first round with widening.
const WIDENED: usize = 2;
/// Thresholds of widening.
const STOPS: [f64; 3] = [-1.0, 0.0, 1.0];
/// Maximum size of a strongly connected component; the ranges of larger ones are unbounded.
const MAX_TOGETHER: usize = 20_000;

/// The known ranges and the state of the search.
#[derive(Default, Debug)]
pub(super) struct SolverState {
    /// By node: the index of its range plus one; 0 if it is not known.
    slots: Vec<u32>,
    /// `None` for nodes that never have a value.
    ranges: Vec<Option<Interval>>,
    /// By node: its number in the depth-first search; 0 if it was not visited. During fixed-point
    /// iteration: the time at which its range changed last.
    numbers: Vec<u32>,
    count: u32,
    /// By node: the node that it is a copy of, plus one; 0 if it was not requested.
    resolved: Vec<Cell<u32>>,
    /// By guard: whether it may hold; `None` if it is not known.
    met: Vec<Option<bool>>,
    search: TarjanState,
}

/// The lists of a search, reused by the next one.
#[derive(Default, Debug)]
struct TarjanState {
    frames: Vec<SearchFrame>,
    /// The unknown operands of the nodes in `frames` and `left`.
    operands: Vec<Node>,
    /// The stack of finished nodes whose strongly connected component is not complete.
    left: Vec<Left>,
}

/// A member of a strongly connected component.
#[derive(Clone, Copy, Debug)]
struct Left {
    node: Node,
    /// The range of its unknown operands in `TarjanState::operands`.
    start: usize,
    end: usize,
    /// The time at which it was computed last.
    computed: u32,
    is_join: bool,
}

/// A node on the search path (Tarjan, *Depth-First Search and Linear Graph Algorithms*, 1972).
#[derive(Debug)]
struct SearchFrame {
    node: Node,
    /// The range of its unknown operands in `TarjanState::operands`.
    next: usize,
    end: usize,
    start: usize,
    /// The lowest number of a node reachable from it (low-link).
    low: u32,
    /// The length of `left` when it was first visited.
    left: usize,
    is_own: bool,
}

impl SolverState {
    /// The range of a node; `None` if it never has a value.
    pub(super) fn solve(&mut self, query: &Query, root: Node) -> Option<Interval> {
        if self.slots.is_empty() {
            self.slots = vec![0; Node::count(query.defs)];
            self.numbers = vec![0; self.slots.len()];
            self.resolved = vec![Cell::new(0); self.slots.len()];
        }
        let root = self.resolved(query, root);
        if let Some(known) = self.get(root) {
            return *known;
        }
        let mut search = std::mem::take(&mut self.search);
        self.search(query, root, &mut search);
        self.search = search;
        self.get(root).copied().flatten()
    }

    /// The node that a node is a copy of, cached.
    #[inline]
    fn resolved(&self, query: &Query, node: Node) -> Node {
        let known = self.resolved.get(node.0 as usize).map_or(0, Cell::get);
        match known.checked_sub(1) {
            Some(number) => Node(number),
            None => self.resolve(query, node),
        }
    }

    #[inline(never)]
    fn resolve(&self, query: &Query, node: Node) -> Node {
        let found = query.resolved(node);
        if let Some(known) = self.resolved.get(node.0 as usize) {
            known.set(found.0 + 1);
        }
        found
    }

    fn search(&mut self, query: &Query, root: Node, search: &mut TarjanState) {
        let TarjanState {
            frames,
            operands,
            left,
        } = search;
        frames.extend(self.visit(query, root, operands, 0));
        while let Some(frame) = frames.last_mut() {
            if frame.next < frame.end {
                let operand = operands.get(frame.next).copied();
                frame.next += 1;
                let Some(operand) = operand.filter(|o| self.get(*o).is_none()) else {
                    continue;
                };
                frame.is_own |= operand == frame.node;
                match self.numbers.get(operand.0 as usize) {
                    Some(0) => frames.extend(self.visit(query, operand, operands, left.len())),
                    Some(number) => frame.low = frame.low.min(*number),
                    None => {}
                }
                continue;
            }
            let Some(frame) = frames.pop() else { break };
            left.push(Left {
                node: frame.node,
                start: frame.start,
                end: frame.end,
                computed: 0,
                is_join: false,
            });
            let number = self.numbers.get(frame.node.0 as usize).copied();
            if number == Some(frame.low) {
                match left.get_mut(frame.left..) {
                    Some([one]) if !frame.is_own => {
                        let range = self.compute(query, one.node);
                        self.put(one.node, range);
                    }
                    together => self.together(query, together.unwrap_or(&mut []), operands),
                }
                left.truncate(frame.left);
                operands.truncate(frame.start);
            } else if let Some(outer) = frames.last_mut() {
                outer.low = outer.low.min(frame.low);
            }
        }
    }

    /// Whether a guard may hold; `None` if it is not known.
    pub(super) fn is_met(&self, guard: u32) -> Option<bool> {
        self.met.get(guard as usize).copied().flatten()
    }

    /// Caches whether a guard may hold.
    pub(super) fn keep_met(&mut self, guard: u32, is_met: bool, defs: &ReachingDefinitions) {
        self.met.resize(defs.guard_count(), None);
        self.met.set_at(guard as usize, Some(is_met));
    }

    #[inline]
    fn get(&self, node: Node) -> Option<&Option<Interval>> {
        let slot = self.slots.get(node.0 as usize)?.checked_sub(1)?;
        self.ranges.get(slot as usize)
    }

    fn put(&mut self, node: Node, range: Option<Interval>) {
        let Some(slot) = self.slots.get_mut(node.0 as usize) else {
            return;
        };
        match slot
            .checked_sub(1)
            .and_then(|at| self.ranges.get_mut(at as usize))
        {
            Some(kept) => *kept = range,
            None => {
                self.ranges.push(range);
                *slot = self.ranges.len() as u32;
            }
        }
    }

    /// Visits a node: computes its range if all operands are known, else returns a frame for the
    /// search.
    fn visit(
        &mut self,
        query: &Query,
        node: Node,
        operands: &mut Vec<Node>,
        left: usize,
    ) -> Option<SearchFrame> {
        let start = operands.len();
        let range = query.compute(node, &mut |operand| {
            let operand = self.resolved(query, operand);
            match self.get(operand) {
                Some(known) => *known,
                None => self.meet(query, operand, operands),
            }
        });
        if operands.len() == start {
            self.put(node, range);
            return None;
        }
        self.count += 1;
        self.numbers.set_at(node.0 as usize, self.count);
        Some(SearchFrame {
            node,
            next: start,
            end: operands.len(),
            start,
            low: self.count,
            left,
            is_own: false,
        })
    }

    /// Handles an operand without a known range: constants are evaluated, others are added to
    /// `unknown`.
    #[inline(never)]
    fn meet(&mut self, query: &Query, node: Node, unknown: &mut Vec<Node>) -> Option<Interval> {
        let range = query.constant(node);
        match range {
            Some(_) => self.put(node, range),
            None => unknown.push(node),
        }
        range
    }

    fn compute(&self, query: &Query, node: Node) -> Option<Interval> {
        query.compute(node, &mut |operand| {
            let operand = self.resolved(query, operand);
            *self.get(operand).unwrap_or(&Some(Interval::ANY))
        })
    }

    /// Solves a strongly connected component, given in approximate topological order (operands
    /// first).
    fn together(&mut self, query: &Query, nodes: &mut [Left], operands: &[Node]) {
        if nodes.len() > MAX_TOGETHER {
            nodes
                .iter()
                .for_each(|n| self.put(n.node, Some(Interval::ANY)));
            return;
        }
        for left in &mut *nodes {
            left.is_join = is_join(query, left.node);
            self.put(left.node, None);
        }
        for round in 0..MAX_ROUNDS {
            let mut is_changed = false;
            for left in &mut *nodes {
                if !self.has_moved(left, operands) {
                    continue;
                }
                let range = self.compute(query, left.node);
                left.computed = self.count;
                match left.is_join {
                    true => is_changed |= self.climb(left.node, range, round),
                    false => _ = self.change(left.node, range),
                }
            }
            if !is_changed {
                break;
            }
        }
        // Descending iteration: narrows from above.
        for _ in 0..2 {
            let mut is_changed = false;
            for left in nodes.iter().filter(|left| left.is_join) {
                let range = self.compute(query, left.node);
                is_changed |= self.change(left.node, range);
            }
            if !is_changed {
                break;
            }
            for left in nodes.iter_mut().filter(|left| !left.is_join) {
                if self.has_moved(left, operands) {
                    let range = self.compute(query, left.node);
                    left.computed = self.count;
                    self.change(left.node, range);
                }
            }
        }
    }

    /// Whether an operand changed after the node was computed; for a widening point also the node
    /// itself.
    fn has_moved(&self, left: &Left, operands: &[Node]) -> bool {
        let has_changed = |node: &Node| {
            let changed = self.numbers.get(node.0 as usize);
            changed.is_some_and(|changed| *changed > left.computed)
        };
        let operands = operands.get(left.start..left.end).unwrap_or(&[]);
        left.is_join && has_changed(&left.node) || operands.iter().any(has_changed)
    }

    /// Replaces the range of a node. Returns whether it changed.
    fn change(&mut self, node: Node, range: Option<Interval>) -> bool {
        if self.get(node) == Some(&range) {
            return false;
        }
        self.count += 1;
        self.numbers.set_at(node.0 as usize, self.count);
        self.put(node, range);
        true
    }

    /// Joins a range into that of a widening point, with widening. Returns whether it changed.
    fn climb(&mut self, node: Node, range: Option<Interval>, round: usize) -> bool {
        let before = self.get(node).copied().flatten();
        let mut joined = match (before, range) {
            (Some(a), Some(b)) => Some(Interval {
                rounding: b.rounding,
                ..a.join(b)
            }),
            (a, b) => a.or(b),
        };
        if let (Some(before), Some(after)) = (before, &mut joined) {
            if round + 1 == MAX_ROUNDS && !is_within(after, &before) {
                *after = Interval::ANY.like(after);
            } else if round >= WIDENED {
                widen(&before, after);
            }
        }
        self.change(node, joined)
    }
}

/// Whether one range is within another.
fn is_within(inner: &Interval, outer: &Interval) -> bool {
    inner.lo.value >= outer.lo.value && inner.hi.value <= outer.hi.value
}

/// Widens the bounds that are still moving to the next threshold.
fn widen(before: &Interval, after: &mut Interval) {
    if after.lo.value < before.lo.value {
        let stop = STOPS.iter().rev().find(|s| **s <= after.lo.value);
        *after = after.down_to(stop.copied().unwrap_or(f64::NEG_INFINITY));
    }
    if after.hi.value > before.hi.value {
        let stop = STOPS.iter().find(|s| **s >= after.hi.value);
        *after = after.up_to(stop.copied().unwrap_or(f64::INFINITY));
    }
}

/// Whether a node is a widening point: a loop head or a function entry.
fn is_join(query: &Query, node: Node) -> bool {
    let NodeSubject::Def(def) = node.subject(query.defs) else {
        return false;
    };
    matches!(query.defs.get(def), Def::Head { .. } | Def::Entry(_))
}
