//! Ranges of definitions.

use super::back::RequiredRange;
use super::builtin::of_host;
use super::interval::Interval;
use super::node::{GetRange, Node, NodeSubject};
use super::{Query, fitting};
use crate::reaching_definitions::condition::{each_comparison, each_load};
use crate::reaching_definitions::{Def, DefId, Refinement, Slot};
use shaderlint_ir::{Binary, LoopId, OpKind, Root};
use shaderlint_semantic::{Scalar, Type};

/// Maximum number of copies followed at once.
const MAX_COPIES: u32 = 64;

/// A loop head that starts at `init` and is incremented by a constant per iteration.
#[derive(Clone, Copy, Debug)]
struct Counter {
    of: LoopId,
    init: DefId,
    step: f64,
}

impl Query<'_> {
    /// The node that a node is a copy of, copies followed.
    pub(super) fn resolved(&self, mut node: Node) -> Node {
        let (module, defs) = (self.module, self.defs);
        for _ in 0..MAX_COPIES {
            let next = match node.subject(defs) {
                NodeSubject::Def(def) => match defs.get(def) {
                    Def::Stored { value, lane } => Node::lane(defs, value, lane),
                    _ => None,
                },
                NodeSubject::Lane(op, lane) => match module.op(op).kind {
                    OpKind::Load(_) => Some(Node::def(defs, defs.seen(op, lane))),
                    OpKind::Splat(_)
                    | OpKind::Swizzle(..)
                    | OpKind::Extract(..)
                    | OpKind::Compose(_) => {
                        let part = defs.part_of(module, op, lane);
                        part.and_then(|(op, lane)| Node::lane(defs, op, lane))
                    }
                    _ => None,
                },
            };
            match next {
                Some(next) => node = next,
                None => break,
            }
        }
        node
    }

    /// The range of a node, given the ranges of its operands; `None` if it never has a value. The
    /// set of operands requested does not depend on their ranges.
    pub(super) fn compute(&self, node: Node, get: &mut impl GetRange) -> Option<Interval> {
        match node.subject(self.defs) {
            NodeSubject::Lane(op, lane) => {
                let mut range = self.operation(op, lane, get);
                if let Some(range) = &mut range {
                    self.fit(op, lane, range);
                }
                range
            }
            NodeSubject::Def(def) => self.definition(def, get),
        }
    }

    fn definition(&self, id: DefId, get: &mut impl GetRange) -> Option<Interval> {
        let defs = self.defs;
        let of = |def| Node::def(defs, def);
        let source = 1u64 << (id.0 % 64);
        match defs.get(id) {
            Def::Entry(slot) => self.entry(slot, source, get),
            Def::Stored { value, lane } => self.of_lane(value, lane, get),
            Def::Measured(parts) => measure(defs.list(parts).iter().map(|part| get(of(*part)))),
            Def::Merge {
                sides, is_choice, ..
            } => {
                let ranges = defs.list(sides).iter().map(|side| get(of(*side)));
                let mut joined = join(ranges)?;
                if !is_choice {
                    joined = joined.loose();
                }
                joined.sources |= source;
                Some(joined)
            }
            Def::Head { init, back, .. } => {
                let (first, later) = (get(of(init)), get(of(back)));
                let mut joined = join([first, later].into_iter())?;
                // After the first iteration, only the back edge determines the rounding.
                joined.rounding = later.map_or(joined.rounding, |later| later.rounding);
                if !self.is_tested(id) {
                    joined = joined.loose();
                }
                joined.sources |= source;
                Some(joined)
            }
            Def::Refined { of: before, by } => self.refined(before, by, get),
            Def::Unknown => Some(Interval {
                sources: source,
                ..Interval::ANY
            }),
        }
    }

    /// The range of a definition constrained by a comparison.
    fn refined(&self, before: DefId, by: Refinement, get: &mut impl GetRange) -> Option<Interval> {
        let defs = self.defs;
        let known = get(Node::def(defs, before));
        let required = RequiredRange::at_end(self, by, get);
        let end = by.way(self.module, defs).last();
        let is_float = end.is_none_or(|hop| self.is_float_lane(hop.op));
        let head = defs.unrefined(before);
        let counter = self.counter(head);
        let first = counter.map(|c| get(Node::def(defs, c.init)));
        let mut range = known?;
        required.narrow(&mut range, is_float);
        if let (Some(counter), Some(Some(first))) = (counter, first) {
            let is_counted = snap(&mut range, first, counter.step);
            if is_counted && by.truth && self.is_test(counter.of, by) {
                range.touch_ends();
            }
        }
        // A contradiction: this code is unreachable.
        (range.lo.value <= range.hi.value).then_some(range)
    }

    fn is_float_lane(&self, op: shaderlint_ir::OpId) -> bool {
        let ty = self.module.ty(op);
        ty.element().scalar_kind() == Some(Scalar::Float)
    }

    /// Whether a comparison is a continuation condition of a loop.
    fn is_test(&self, looped: LoopId, by: Refinement) -> bool {
        let condition = self.module.looped(looped).and_then(|l| l.condition);
        let mut is_test = false;
        if let Some(condition) = condition {
            each_comparison(self.module, self.defs, condition, true, |premise| {
                is_test |= premise.comparison == by.comparison;
            });
        }
        is_test
    }

    /// Whether a loop head is a counter that the loop condition tests, so that it takes each of its
    /// values.
    fn is_tested(&self, head: DefId) -> bool {
        let Some(counter) = self.counter(head) else {
            return false;
        };
        let condition = self.module.looped(counter.of).and_then(|l| l.condition);
        let mut is_tested = false;
        if let Some(condition) = condition {
            let (module, defs) = (self.module, self.defs);
            each_comparison(module, defs, condition, true, |premise| {
                each_load(module, defs, premise, |load, lane, _| {
                    is_tested |= defs.unrefined(defs.seen(load, lane)) == head;
                });
            });
        }
        is_tested
    }

    /// Whether a definition, refinements aside, is a loop counter.
    pub(super) fn is_counted(&self, def: DefId) -> bool {
        self.counter(self.defs.unrefined(def)).is_some()
    }

    /// The counter at a loop head, if each iteration adds the same constant to it.
    fn counter(&self, head: DefId) -> Option<Counter> {
        let defs = self.defs;
        let Def::Head { of, init, back, .. } = defs.get(head) else {
            return None;
        };
        let Def::Stored { value, lane } = defs.get(defs.unrefined(back)) else {
            return None;
        };
        let (OpKind::Binary(op, a, b), 0) = (self.module.op(value).kind, lane) else {
            return None;
        };
        let is_head = |op| {
            matches!(self.module.op(op).kind, OpKind::Load(_))
                && defs.unrefined(defs.seen(op, 0)) == head
        };
        let constant = |op| match self.module.constant(op) {
            [value] => Some(value.as_number()),
            _ => None,
        };
        let step = match op {
            Binary::Add if is_head(a) => constant(b)?,
            Binary::Add if is_head(b) => constant(a)?,
            Binary::Subtract if is_head(a) => -constant(b)?,
            _ => return None,
        };
        (step != 0.0).then_some(Counter { of, init, step })
    }

    /// The range of a slot on entry to a function.
    fn entry(&self, slot: Slot, source: u64, get: &mut impl GetRange) -> Option<Interval> {
        let defs = self.defs;
        let (id, _) = defs.variable_at(slot);
        let unknown = |ty: Type| {
            let any = Interval {
                sources: source,
                ..Interval::ANY
            };
            fitting(ty.element().scalar_kind(), any)
        };
        let variable = self.module.variable(id)?;
        let mut range = match variable.root {
            Root::Local | Root::Temporary => return None,
            Root::ParameterOut if variable.ty.is_array() => return None,
            Root::ParameterOut => return Some(unknown(variable.ty)),
            Root::Uniform | Root::Input => return Some(self.given(slot, source)),
            Root::Parameter | Root::ParameterInout => {
                let Some(passed) = defs.passed(self.module, slot) else {
                    return Some(unknown(variable.ty));
                };
                let nodes = passed
                    .args()
                    .filter_map(|arg| Node::lane(defs, arg, passed.lane));
                let mut range = join(nodes.map(&mut *get))?;
                if passed.args().len() > 1 {
                    range.mixed = true;
                    range.sources |= source;
                }
                range
            }
            Root::Global | Root::Output => {
                let writes = defs.global_writes(slot);
                let mut put = writes.iter().filter_map(|def| get(Node::def(defs, *def)));
                let Some(first) = put.next() else {
                    return Some(unknown(variable.ty));
                };
                match put.reduce(Interval::join) {
                    Some(others) => Interval {
                        sources: first.sources | others.sources | source,
                        ..first.join(others).loose()
                    },
                    None => first,
                }
            }
        };
        if self.ranges.hides_variable(id) {
            // The known writes are the best estimate of its rounding.
            range = Interval {
                rounding: range.rounding,
                ..unknown(variable.ty)
            };
        }
        if range.is_any() {
            range.sources |= source;
        }
        Some(range)
    }

    /// The range of a slot that the host or the language sets.
    fn given(&self, slot: Slot, source: u64) -> Interval {
        let (id, lane) = self.defs.variable_at(slot);
        let Some(variable) = self.program.variable(id) else {
            return Interval::ANY;
        };
        let name = self.program.names.text(variable.name);
        let rows = variable
            .ty
            .element()
            .numeric()
            .map_or(0, |(_, _, rows)| rows as u32);
        let of = |lane: u32| of_host(name, lane as u8).unwrap_or(Interval::ANY);
        let range = match lane < rows || rows == 0 {
            true => of(lane),
            false => measure((0..rows).map(|row| Some(of(row))))
                .unwrap_or(Interval::ANY)
                .loose(),
        };
        let scalar = variable.ty.element().scalar_kind().filter(|_| lane < rows);
        // The resolution is constant, so it does not correlate values.
        let sources = if name == "iResolution" { 0 } else { source };
        Interval {
            sources,
            ..fitting(scalar, range)
        }
    }
}

/// The union of ranges, without those that never have a value.
pub(super) fn join(ranges: impl Iterator<Item = Option<Interval>>) -> Option<Interval> {
    ranges.fold(None, |joined, range| match (joined, range) {
        (Some(a), Some(b)) => Some(a.join(b)),
        (a, b) => a.or(b),
    })
}

/// The length of a vector, from the ranges of its components.
pub(super) fn measure(parts: impl Iterator<Item = Option<Interval>>) -> Option<Interval> {
    let mut sum: Option<Interval> = None;
    let mut is_made = true;
    for part in parts {
        match part {
            Some(part) => sum = Some(sum.map_or(part.square(), |sum| sum + part.square())),
            None => is_made = false,
        }
    }
    let mut length = sum.filter(|_| is_made)?.rising(|v| v.max(0.0).sqrt());
    length.raise(0.0);
    Some(length)
}

/// Moves the bounds of a counter to the nearest values that it takes. Returns whether it attains
/// them.
fn snap(range: &mut Interval, first: Interval, step: f64) -> bool {
    let Some(first) = first.single() else {
        return true;
    };
    let (lo, hi) = (range.lo.value, range.hi.value);
    let (mut least, mut most) = (Some(lo), Some(hi));
    if lo.is_finite() {
        least = counted(first, step.abs(), lo, f64::ceil);
    }
    if hi.is_finite() {
        most = counted(first, step.abs(), hi, f64::floor);
    }
    range.raise(least.unwrap_or(lo));
    range.lower(most.unwrap_or(hi));
    least.is_some() && most.is_some()
}

/// The last value of a counter before a bound. `None` if rounding decides whether there is one more
/// iteration.
fn counted(first: f64, step: f64, end: f64, rounded: fn(f64) -> f64) -> Option<f64> {
    let iterations = (end - first) / step;
    let is_exact = |v: f64| (v * 256.0).fract() == 0.0;
    let is_near = (iterations - iterations.round()).abs() < 1e-4 * iterations.abs().max(1.0);
    if is_near && iterations.round() != 0.0 && !(is_exact(first) && is_exact(step)) {
        return None;
    }
    Some(first + rounded(iterations) * step)
}
