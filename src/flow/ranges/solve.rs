//! Solves for ranges: what hangs on nothing unknown at once, what hangs on itself together.

use super::Query;
use super::interval::Interval;
use super::node::{Node, Subject};
use crate::defs::{Def, Defs};
use std::cell::Cell;

/// Most rounds until what still moves is taken for anything.
const MAX_ROUNDS: usize = 12;
/// From this round on moving bounds are widened.
const WIDENED: usize = 2;
/// Where a moving bound may come to rest.
const STOPS: [f64; 3] = [-1.0, 0.0, 1.0];
/// Most values that are solved together; of more nothing is known.
const MAX_TOGETHER: usize = 20_000;

/// What is known, and the state of the search.
#[derive(Default, Debug)]
pub(super) struct Known {
    /// By node: the number of its range, plus one; 0 where it is not known.
    slots: Vec<u32>,
    /// `None` for what never has a value.
    ranges: Vec<Option<Interval>>,
    /// By node: when the search came to it; 0 where it did not. While nodes are solved together:
    /// when the range changed last.
    numbers: Vec<u32>,
    count: u32,
    /// By node: the number of the node whose value it has, plus one; 0 where it was not asked for.
    resolved: Vec<Cell<u32>>,
    /// By guard: whether it may hold, if that is known.
    met: Vec<Option<bool>>,
    search: TarjanState,
}

/// The lists of a search, kept for the next one.
#[derive(Default, Debug)]
struct TarjanState {
    frames: Vec<Frame>,
    /// The operands that are not known, of the nodes of the frames and of those left.
    operands: Vec<Node>,
    /// Nodes whose operands have been looked at, but that hang on one whose have not.
    left: Vec<Left>,
}

/// A node that hangs on itself.
#[derive(Clone, Copy, Debug)]
struct Left {
    node: Node,
    /// Where its operands that were not known lie in the common list.
    start: usize,
    end: usize,
    /// When it was computed last.
    computed: u32,
    is_turn: bool,
}

/// A node whose operands are being looked at (Tarjan, *Depth-First Search and Linear Graph
/// Algorithms*, 1972).
#[derive(Debug)]
struct Frame {
    node: Node,
    /// Its operands that are not known, in a common list.
    next: usize,
    end: usize,
    start: usize,
    /// The first node that it leads back to.
    low: u32,
    /// How many nodes were left when the search came to it.
    left: usize,
    is_own: bool,
}

impl Known {
    /// The range of a node.
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

    /// The node whose value a node has.
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
                is_turn: false,
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

    /// Whether a condition may hold, if that is known.
    pub(super) fn is_met(&self, guard: u32) -> Option<bool> {
        self.met.get(guard as usize).copied().flatten()
    }

    /// Notes whether a condition may hold.
    pub(super) fn keep_met(&mut self, guard: u32, is_met: bool, defs: &Defs) {
        self.met.resize(defs.guard_count(), None);
        if let Some(slot) = self.met.get_mut(guard as usize) {
            *slot = Some(is_met);
        }
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

    /// Comes to a node: computes it if all that it hangs on is known, and looks at that otherwise.
    fn visit(
        &mut self,
        query: &Query,
        node: Node,
        operands: &mut Vec<Node>,
        left: usize,
    ) -> Option<Frame> {
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
        if let Some(number) = self.numbers.get_mut(node.0 as usize) {
            *number = self.count;
        }
        Some(Frame {
            node,
            next: start,
            end: operands.len(),
            start,
            low: self.count,
            left,
            is_own: false,
        })
    }

    /// The range of a constant that is met for the first time; what else is not known is noted.
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

    /// Solves for nodes that hang on each other, given with operands mostly before what they are
    /// operands of.
    fn together(&mut self, query: &Query, nodes: &mut [Left], operands: &[Node]) {
        if nodes.len() > MAX_TOGETHER {
            nodes
                .iter()
                .for_each(|n| self.put(n.node, Some(Interval::ANY)));
            return;
        }
        for left in &mut *nodes {
            left.is_turn = is_turn(query, left.node);
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
                match left.is_turn {
                    true => is_changed |= self.climb(left.node, range, round),
                    false => _ = self.change(left.node, range),
                }
            }
            if !is_changed {
                break;
            }
        }
        // From above the equations only narrow.
        for _ in 0..2 {
            let mut is_changed = false;
            for left in nodes.iter().filter(|left| left.is_turn) {
                let range = self.compute(query, left.node);
                is_changed |= self.change(left.node, range);
            }
            if !is_changed {
                break;
            }
            for left in nodes.iter_mut().filter(|left| !left.is_turn) {
                if self.has_moved(left, operands) {
                    let range = self.compute(query, left.node);
                    left.computed = self.count;
                    self.change(left.node, range);
                }
            }
        }
    }

    /// Whether what a node is computed from has changed since: its operands, and where values come
    /// round, itself.
    fn has_moved(&self, left: &Left, operands: &[Node]) -> bool {
        let has_changed = |node: &Node| {
            let changed = self.numbers.get(node.0 as usize);
            changed.is_some_and(|changed| *changed > left.computed)
        };
        let operands = operands.get(left.start..left.end).unwrap_or(&[]);
        left.is_turn && has_changed(&left.node) || operands.iter().any(has_changed)
    }

    /// Gives a node another range. Says whether it is another.
    fn change(&mut self, node: Node, range: Option<Interval>) -> bool {
        if self.get(node) == Some(&range) {
            return false;
        }
        self.count += 1;
        if let Some(number) = self.numbers.get_mut(node.0 as usize) {
            *number = self.count;
        }
        self.put(node, range);
        true
    }

    /// Adds a range to what is known where values come round. Says whether that is more.
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

/// Whether one range lies in another.
fn is_within(inner: &Interval, outer: &Interval) -> bool {
    inner.lo.value >= outer.lo.value && inner.hi.value <= outer.hi.value
}

/// Moves bounds that are still moving to where they may stop.
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

/// Whether values come round here: at the head of a loop, and where a function is entered.
fn is_turn(query: &Query, node: Node) -> bool {
    let Subject::Def(def) = node.subject(query.defs) else {
        return false;
    };
    matches!(query.defs.get(def), Def::Head { .. } | Def::Entry(_))
}
