//! Ranges of definitions.

use super::back::Wanted;
use super::builtin::of_host;
use super::interval::Interval;
use super::node::{Node, Subject};
use super::{Query, fitting, number};
use crate::defs::condition::{each_comparison, each_load};
use crate::defs::{Def, DefId, Refinement, Slot};
use shaderlint_ir::{Binary, LoopId, OpKind, Root};
use shaderlint_semantic::{Scalar, Type};

/// How many copies are followed at once.
const MAX_COPIES: u32 = 64;

/// The number that each turn of a loop adds to what a loop begins with.
#[derive(Clone, Copy, Debug)]
struct Counter {
    of: LoopId,
    init: DefId,
    step: f64,
}

impl Query<'_> {
    /// The node whose value a node has, copies followed.
    pub(super) fn resolved(&self, mut node: Node) -> Node {
        let (module, defs) = (self.module, self.defs);
        for _ in 0..MAX_COPIES {
            let next = match node.subject(defs) {
                Subject::Def(def) => match defs.get(def) {
                    Def::Stored { value, lane } => Node::lane(defs, value, lane),
                    _ => None,
                },
                Subject::Lane(op, lane) => match module.op(op).kind {
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

    /// The range of a node, given those that it hangs on; `None` where it never has a value. Which
    /// nodes are asked for does not depend on the answers.
    pub(super) fn compute(
        &self,
        node: Node,
        get: &mut impl FnMut(Node) -> Option<Interval>,
    ) -> Option<Interval> {
        match node.subject(self.defs) {
            Subject::Lane(op, lane) => {
                let mut range = self.operation(op, lane, get);
                if let Some(range) = &mut range {
                    self.fit(op, lane, range);
                }
                range
            }
            Subject::Def(def) => self.definition(def, get),
        }
    }

    fn definition(
        &self,
        id: DefId,
        get: &mut impl FnMut(Node) -> Option<Interval>,
    ) -> Option<Interval> {
        let defs = self.defs;
        let of = |def| Node::def(defs, def);
        let source = 1u64 << (id.0 % 64);
        match defs.get(id) {
            Def::Entry(slot) => self.entry(slot, source, get),
            Def::Stored { value, lane } => match Node::lane(defs, value, lane) {
                Some(node) => get(node),
                None => Some(Interval::ANY),
            },
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
                // After the first turn it is what the turns make of it.
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

    /// What is left of a definition where a comparison holds or does not.
    fn refined(
        &self,
        before: DefId,
        by: Refinement,
        get: &mut impl FnMut(Node) -> Option<Interval>,
    ) -> Option<Interval> {
        let defs = self.defs;
        let known = get(Node::def(defs, before));
        let wanted = Wanted::at_end(self, by, get);
        let end = by.way(self.module, defs).last();
        let is_float = end.is_none_or(|hop| self.is_float_lane(hop.op));
        let head = defs.unrefined(before);
        let counter = self.counter(head);
        let first = counter.map(|c| get(Node::def(defs, c.init)));
        let mut range = known?;
        wanted.narrow(&mut range, is_float);
        if let (Some(counter), Some(Some(first))) = (counter, first) {
            let is_counted = snap(&mut range, first, counter.step);
            if is_counted && by.truth && self.is_test(counter.of, by) {
                range.touch_ends();
            }
        }
        // What contradicts itself is never reached.
        (range.lo.value <= range.hi.value).then_some(range)
    }

    fn is_float_lane(&self, op: shaderlint_ir::OpId) -> bool {
        let ty = self.module.ty(op);
        ty.element().scalar_kind() == Some(Scalar::Float)
    }

    /// Whether a loop goes on while a comparison holds.
    fn is_test(&self, looped: LoopId, by: Refinement) -> bool {
        let condition = self.module.looped(looped).and_then(|l| l.condition);
        let mut is_test = false;
        if let Some(condition) = condition {
            each_comparison(self.module, self.defs, condition, true, |told| {
                is_test |= told.comparison == by.comparison;
            });
        }
        is_test
    }

    /// Whether the head of a loop counts, and the loop ends by what it has counted: then it takes
    /// each of its values.
    fn is_tested(&self, head: DefId) -> bool {
        let Some(counter) = self.counter(head) else {
            return false;
        };
        let condition = self.module.looped(counter.of).and_then(|l| l.condition);
        let mut is_tested = false;
        if let Some(condition) = condition {
            let (module, defs) = (self.module, self.defs);
            each_comparison(module, defs, condition, true, |told| {
                each_load(module, defs, told, |load, lane, _| {
                    is_tested |= defs.unrefined(defs.seen(load, lane)) == head;
                });
            });
        }
        is_tested
    }

    /// Whether a definition is, conditions aside, what a loop counts.
    pub(super) fn is_counted(&self, def: DefId) -> bool {
        self.counter(self.defs.unrefined(def)).is_some()
    }

    /// What a lane counts, if it is the head of a loop whose turns each add one number to it.
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
            [value] => Some(number(*value)),
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

    /// What a lane of a variable holds before anything in the function is written to it.
    fn entry(
        &self,
        slot: Slot,
        source: u64,
        get: &mut impl FnMut(Node) -> Option<Interval>,
    ) -> Option<Interval> {
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
            Root::Local | Root::Temporary | Root::ParameterOut => return None,
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
            // Whether it is rounded, the writes that are known tell best.
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

    /// What the host or the language puts into a lane of a variable.
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
        // The size of the picture stays as it is, so numbers do not hang on each other by it.
        let sources = if name == "iResolution" { 0 } else { source };
        Interval {
            sources,
            ..fitting(scalar, range)
        }
    }
}

/// What is one of several, those left out that never have a value.
pub(super) fn join(ranges: impl Iterator<Item = Option<Interval>>) -> Option<Interval> {
    ranges.fold(None, |joined, range| match (joined, range) {
        (Some(a), Some(b)) => Some(a.join(b)),
        (a, b) => a.or(b),
    })
}

/// The length of a vector of these components.
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

/// Moves the ends of what a counter may be to numbers that it counts. Says whether it comes to them.
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

/// The last number on this side of an end that counting comes to. `None` where rounding decides
/// whether one turn more is made.
fn counted(first: f64, step: f64, end: f64, rounded: fn(f64) -> f64) -> Option<f64> {
    let turns = (end - first) / step;
    let is_exact = |v: f64| (v * 256.0).fract() == 0.0;
    let is_near = (turns - turns.round()).abs() < 1e-4 * turns.abs().max(1.0);
    if is_near && turns.round() != 0.0 && !(is_exact(first) && is_exact(step)) {
        return None;
    }
    Some(first + rounded(turns) * step)
}
