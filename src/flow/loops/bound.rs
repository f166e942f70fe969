//! Loop bounds: the exit condition that terminates a loop, and its trip count.

use super::halving::halves;
use super::pace::{Pace, Tracer, is_invariant};
use super::{Bound, FoundLoop, Goes, LoopFacts};
use crate::ranges::{Interval, Query};
use crate::reaching_definitions::condition::each_comparison;
use crate::reaching_definitions::{Def, DefId};
use shaderlint_ir::{Binary, LoopId, OpId, OpKind, Provenance, Root};
use shaderlint_semantic::builtins::Transfer;
use shaderlint_syntax::ast::ExprId;

/// Smaller steps are taken for zero: they may be lost in rounding when added to a counter.
const LEAST_STEP: f64 = 1e-9;
/// Maximum number of parts of a bit test that are visited.
const MAX_BITS: u32 = 8;
/// Maximum number of calls through which a limit is followed from parameters to arguments.
const MAX_CALLS: u32 = 24;

/// The relation between the counter and the limit while a loop continues.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Relation {
    Below { or_equal: bool },
    Above { or_equal: bool },
    Not,
}

impl Relation {
    const fn flipped(self) -> Relation {
        match self {
            Relation::Below { or_equal } => Relation::Above { or_equal },
            Relation::Above { or_equal } => Relation::Below { or_equal },
            Relation::Not => Relation::Not,
        }
    }
}

impl FoundLoop {
    /// Finds the bound of the loop.
    pub(super) fn looped(self, query: Query) -> Option<LoopFacts> {
        let module = query.module;
        let looped = module.looped(self.id)?;
        let is_one = |op: OpId| match module.op(op).kind {
            OpKind::Binary(kind, ..) => kind.compares(),
            OpKind::Same { .. } => true,
            _ => false,
        };
        let mut made = LoopFacts {
            stmt: looped.stmt,
            function: self.function,
            bound: Bound::Open,
            counter: None,
            limit: None,
            given: None,
            ends_early: self.ends_early || looped.condition.is_some_and(|c| !is_one(c)),
        };
        for goes in &self.goes {
            self.take(query, &mut made, *goes);
        }
        // Unreachable, or every path through the body leaves it.
        if !query.defs.repeats(self.id) && made.bound.iterations().is_none_or(|n| n > 1) {
            made.bound = Bound::AtMost(1);
        }
        match made.bound {
            Bound::Exact(iterations) if made.ends_early => made.bound = Bound::AtMost(iterations),
            Bound::Exact(_) => {}
            // Without a step expression, the body may end the loop early.
            _ => made.ends_early |= module.steps(looped.step).is_empty(),
        }
        Some(made)
    }

    /// Updates the loop's facts if a continuation condition gives a better bound.
    fn take(&self, query: Query, made: &mut LoopFacts, goes: Goes) {
        let (module, defs) = (query.module, query.defs);
        // `a || b` holds until both sides are false.
        if let (OpKind::Binary(Binary::Or, a, b), true) =
            (module.op(goes.condition).kind, goes.truth)
        {
            let start = LoopFacts {
                bound: Bound::Open,
                ..*made
            };
            let ends = [a, b].map(|condition| {
                let mut made = start;
                self.take(query, &mut made, Goes { condition, ..goes });
                made
            });
            if let (Bound::Open, [one, other]) = (made.bound, ends)
                && one.bound != Bound::Open
                && other.bound != Bound::Open
            {
                let iterations = one.bound.iterations().zip(other.bound.iterations());
                made.bound = iterations.map_or(Bound::Ends, |(a, b)| Bound::AtMost(a.max(b)));
            }
            return;
        }
        let mut comparisons = Vec::new();
        each_comparison(module, defs, goes.condition, goes.truth, |premise| {
            if premise.call.is_none() {
                comparisons.push((premise.comparison, premise.truth));
            }
        });
        for (comparison, truth) in comparisons {
            if made.bound == Bound::Open && sheds_bits(query, self.id, comparison) {
                made.bound = Bound::Ends;
            }
            let Some((relation, left, right)) = related(query, comparison, truth) else {
                continue;
            };
            self.compare(query, made, relation, left, right);
            self.compare(query, made, relation.flipped(), right, left);
        }
    }

    /// Updates the loop's facts if a relation between a counter and a limit gives a better bound.
    fn compare(
        &self,
        query: Query,
        made: &mut LoopFacts,
        relation: Relation,
        side: OpId,
        limit: OpId,
    ) -> Option<()> {
        let defs = query.defs;
        let is_above = matches!(relation, Relation::Above { .. });
        if made.bound == Bound::Open && is_above && halves(query, self.id, side) {
            made.bound = Bound::Ends;
        }
        let (side, is_size) = match magnitude(query, side) {
            Some(inner) => (inner, true),
            None => (side, false),
        };
        let moved = Tracer::new(query, self.id).value(side, 0)?;
        let Def::Head {
            slot, init, back, ..
        } = defs.get(moved.head)
        else {
            return None;
        };
        let mut tracer = Tracer::new(query, self.id);
        tracer.target = Some(moved.head);
        let iteration = tracer.def(back)?;
        let pace = match is_size {
            true => iteration.pace.of_size(relation)?,
            false => iteration.pace,
        };
        let all = query.lane(limit, 0);
        let ends = |number: &f64| match relation {
            Relation::Below { .. } => *number >= all.hi.value,
            Relation::Above { .. } => *number <= all.lo.value,
            Relation::Not => all.single() == Some(*number),
        };
        let is_there = iteration.head == moved.head
            && heads_there(relation, pace, &all)
            && tracer.jumps.iter().all(ends);
        if !is_there || !is_invariant(query, self.id, limit) {
            return None;
        }
        let tests_first = query.module.looped(self.id)?.tests_first;
        let least = u64::from(!tests_first);
        let iterations = start(query, init, pace)
            .zip(end(query, limit, relation, pace))
            .filter(|_| !is_size)
            .and_then(|(start, end)| iterations(start, relation, end, pace))
            .map(|iterations| iterations.max(least));
        let is_exact = || {
            let is_known = query.lane(limit, 0).single().is_some();
            is_known && query.def(init).single().is_some() && tracer.jumps.is_empty()
        };
        let bound = match iterations {
            Some(iterations) if is_exact() => Bound::Exact(iterations),
            Some(iterations) => Bound::AtMost(iterations),
            None => Bound::Ends,
        };
        let is_more = match (made.bound.iterations(), iterations) {
            (Some(known), Some(iterations)) => iterations < known,
            (None, Some(_)) => true,
            _ => made.bound == Bound::Open,
        };
        if is_more {
            made.bound = bound;
            made.counter = Some(defs.variable_at(slot).0);
            made.limit = expr_of(query, limit);
            made.given = expr_of(query, source(query, limit));
        }
        Some(())
    }
}

/// Whether a comparison tests bits of a number that each iteration shifts: `(n & 1) == 0`.
fn sheds_bits(query: Query, looped: LoopId, comparison: OpId) -> bool {
    let (module, defs) = (query.module, query.defs);
    let OpKind::Same { left, right, .. } = module.op(comparison).kind else {
        return false;
    };
    let mut todo = [left, right].map(|side| (side, false)).to_vec();
    for _ in 0..MAX_BITS {
        let Some((op, is_masked)) = todo.pop() else {
            break;
        };
        match module.op(op).kind {
            OpKind::Binary(Binary::BitAnd, a, b) => todo.extend([(a, true), (b, true)]),
            OpKind::Binary(Binary::BitOr | Binary::BitXor, a, b) if is_masked => {
                todo.extend([(a, true), (b, true)]);
            }
            _ if is_masked => {
                let moved = Tracer::new(query, looped).value(op, 0);
                let Some(head) = moved.map(|moved| moved.head) else {
                    continue;
                };
                let Def::Head { back, .. } = defs.get(head) else {
                    continue;
                };
                let mut tracer = Tracer::new(query, looped);
                tracer.target = Some(head);
                let pace = tracer.def(back).map(|moved| moved.pace);
                if let Some(Pace::Times(by)) = pace
                    && tracer.jumps.is_empty()
                    && (by.abs() >= 2.0 || by.abs() <= 0.5)
                {
                    return true;
                }
            }
            _ => {}
        }
    }
    false
}

/// The relation between the two sides of a comparison that is true or false.
fn related(query: Query, comparison: OpId, truth: bool) -> Option<(Relation, OpId, OpId)> {
    match query.module.op(comparison).kind {
        OpKind::Binary(kind, left, right) => {
            let relation = match (kind, truth) {
                (Binary::Less, true) | (Binary::GreaterEqual, false) => {
                    Relation::Below { or_equal: false }
                }
                (Binary::LessEqual, true) | (Binary::Greater, false) => {
                    Relation::Below { or_equal: true }
                }
                (Binary::Greater, true) | (Binary::LessEqual, false) => {
                    Relation::Above { or_equal: false }
                }
                (Binary::GreaterEqual, true) | (Binary::Less, false) => {
                    Relation::Above { or_equal: true }
                }
                _ => return None,
            };
            Some((relation, left, right))
        }
        OpKind::Same {
            negated,
            left,
            right,
        } => (negated == truth).then_some((Relation::Not, left, right)),
        _ => None,
    }
}

/// The operand of `abs`.
fn magnitude(query: Query, op: OpId) -> Option<OpId> {
    let module = query.module;
    let OpKind::Builtin(function, list) = module.op(op).kind else {
        return None;
    };
    let is_magnitude = matches!(function.transfer(), Transfer::Magnitude);
    module
        .operands(list)
        .first()
        .copied()
        .filter(|_| is_magnitude)
}

impl Pace {
    /// How the absolute value of a counter changes; `None` if it may both grow and shrink.
    fn of_size(self, relation: Relation) -> Option<Pace> {
        match (self, relation) {
            (Pace::Times(by), _) => Some(Pace::Times(by.abs())),
            // A counter that moves in one direction leaves every interval around zero.
            (
                Pace::By {
                    lo,
                    hi,
                    is_invariant,
                },
                Relation::Below { .. },
            ) if lo > LEAST_STEP || hi < -LEAST_STEP => Some(Pace::By {
                lo: lo.abs().min(hi.abs()),
                hi: lo.abs().max(hi.abs()),
                is_invariant,
            }),
            _ => None,
        }
    }
}

/// Whether a counter with this step moves towards the limit.
fn heads_there(relation: Relation, pace: Pace, limit: &Interval) -> bool {
    match (relation, pace) {
        (
            _,
            Pace::By {
                lo: 0.0, hi: 0.0, ..
            },
        ) => false,
        (
            _,
            Pace::By {
                is_invariant: true, ..
            },
        ) if !is_known(pace) => true,
        (Relation::Below { .. }, Pace::By { lo, .. }) => lo > LEAST_STEP,
        (Relation::Above { .. }, Pace::By { hi, .. }) => hi < -LEAST_STEP,
        (Relation::Not, Pace::By { lo, hi, .. }) => lo == hi,
        // A number that changes its sign and grows passes every limit.
        (Relation::Below { .. } | Relation::Above { .. }, Pace::Times(by)) if by < -1.0 => true,
        (_, Pace::Times(by)) if by < 0.0 => false,
        // Numbers that shrink end at zero: below a positive limit they stay.
        (Relation::Below { .. }, Pace::Times(by)) => by > 1.0 || by < 1.0 && limit.hi.value <= 0.0,
        (Relation::Above { .. }, Pace::Times(by)) => by < 1.0 && limit.hi.value >= 0.0,
        (Relation::Not, Pace::Times(by)) => by < 1.0,
    }
}

/// Whether the step is one constant.
fn is_known(pace: Pace) -> bool {
    matches!(pace, Pace::By { lo, hi, .. } if lo == hi)
}

/// The initial value of a counter; the one with the most iterations if it is not known exactly.
fn start(query: Query, init: DefId, pace: Pace) -> Option<f64> {
    let (module, defs) = (query.module, query.defs);
    let range = query.def(init);
    if let Some(value) = range.single() {
        return Some(value);
    }
    if let Def::Stored { value, .. } = defs.get(defs.unrefined(init)) {
        match module.op(value).kind {
            // The browser initialises every variable to zero.
            OpKind::Undef => return Some(0.0),
            // `min(frame, 0)` is zero; the other operand only prevents the compiler from unrolling.
            OpKind::Builtin(function, list) if matches!(function.transfer(), Transfer::Minimum) => {
                let mut args = module.operands(list).iter();
                return args.find_map(|arg| query.lane(*arg, 0).single());
            }
            _ => {}
        }
    }
    let worst = match is_rising(pace) {
        true => range.lo.value,
        false => range.hi.value,
    };
    worst.is_finite().then_some(worst)
}

/// The value of the limit; the one with the most iterations if it is not known exactly.
fn end(query: Query, limit: OpId, relation: Relation, pace: Pace) -> Option<f64> {
    let range = query.lane(limit, 0);
    if relation == Relation::Not {
        return range.single();
    }
    let worst = match is_rising(pace) {
        true => range.hi.value,
        false => range.lo.value,
    };
    worst.is_finite().then_some(worst)
}

fn is_rising(pace: Pace) -> bool {
    match pace {
        Pace::By { lo, .. } => lo > 0.0,
        Pace::Times(by) => by > 1.0,
    }
}

/// The trip count of a counter from `start` to `end`.
fn iterations(start: f64, relation: Relation, end: f64, pace: Pace) -> Option<u64> {
    let way = match pace {
        Pace::By { lo, hi, .. } if lo == hi => (end - start) / lo,
        Pace::Times(by) if by > 0.0 && start > 0.0 && end > 0.0 => (end / start).ln() / by.ln(),
        Pace::By { .. } | Pace::Times(_) => return None,
    };
    let count = match relation {
        Relation::Below { or_equal: false } | Relation::Above { or_equal: false } => way.ceil(),
        Relation::Below { or_equal: true } | Relation::Above { or_equal: true } => {
            way.floor() + 1.0
        }
        Relation::Not if way >= 0.0 => way.ceil(),
        Relation::Not => return None,
    };
    Some(count.max(0.0) as u64)
}

fn expr_of(query: Query, op: OpId) -> Option<ExprId> {
    match query.module.provenance(op) {
        Provenance::Expr(expr) => Some(expr),
        _ => None,
    }
}

/// The operation that determines a limit: for a parameter, the largest argument of all calls;
/// otherwise the operation itself.
fn source(query: Query, op: OpId) -> OpId {
    let mut at = op;
    for _ in 0..MAX_CALLS {
        let Some(argument) = largest_argument(query, at) else {
            break;
        };
        at = argument;
    }
    at
}

fn largest_argument(query: Query, op: OpId) -> Option<OpId> {
    let (module, defs) = (query.module, query.defs);
    let OpKind::Load(place) = module.op(op).kind else {
        return None;
    };
    let variable = module.variable(module.place(place).variable)?;
    if variable.root != Root::Parameter {
        return None;
    }
    let Def::Entry(slot) = defs.get(defs.unrefined(defs.seen(op, 0))) else {
        return None;
    };
    let passed = defs.passed(module, slot)?;
    let all = passed
        .args()
        .map(|arg| (query.lane(arg, passed.lane).hi.value, arg));
    let largest = all.reduce(|most, next| if next.0 > most.0 { next } else { most });
    largest.map(|(_, arg)| arg)
}
