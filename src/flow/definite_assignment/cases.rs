//! Satisfiability of path conditions: whether a set of conditions can hold at the same time.
//!
//! A depth-first search over cases decomposes conditions at `&&`, `||`, `!`, `min` and `max` into
//! comparisons, each of which orders two values. A case is contradictory if the order has a strict
//! cycle, or if a condition is both true and false. When the search runs out of steps, the
//! conditions count as satisfiable.

use super::conditions::{Conditions, Fact, KnownCondition};
use crate::ranges::Query;
use crate::reaching_definitions::Def;
use shaderlint_ir::{Binary, OpId, OpKind, Unary};
use shaderlint_semantic::Scalar;
use shaderlint_semantic::builtins::Transfer;

/// Maximum number of values in an order.
const MAX_VALUES: usize = 20;
/// Maximum number of steps; beyond it the answer is "satisfiable".
const MAX_STEPS: u32 = 1000;
/// Maximum number of path conditions considered, the most recent ones.
const MAX_CONDITIONS: usize = 24;

impl Conditions {
    /// Whether a condition may have the value `truth` on the current path.
    pub fn may_be(&self, query: Query, condition: OpId, truth: bool) -> bool {
        let first = self.held.len().saturating_sub(MAX_CONDITIONS);
        let held = self.held.get(first..).unwrap_or(&[]).iter().copied();
        let all: Vec<KnownCondition> = held.chain([(condition, truth)]).collect();
        may_all_be(query, self, &all)
    }
}

/// Whether all of these answers are possible at the same time.
fn may_all_be(query: Query, conditions: &Conditions, answers: &[KnownCondition]) -> bool {
    let answers = answers.iter().rev();
    let mut open = vec![Assumptions {
        goals: answers.map(|(op, truth)| Goal::Is(*op, *truth)).collect(),
        ..Assumptions::default()
    }];
    let cases = Cases { query, conditions };
    for _ in 0..MAX_STEPS {
        let Some(mut case) = open.pop() else {
            return false;
        };
        let Some(goal) = case.goals.pop() else {
            return true;
        };
        match cases.meaning(goal) {
            GoalTruth::Anything => open.push(case),
            GoalTruth::Never => {}
            GoalTruth::All(goals) => {
                case.goals.extend(goals);
                open.push(case);
            }
            GoalTruth::One(first, second) => {
                let mut other = case.clone();
                other.goals.extend(second);
                case.goals.extend(first);
                open.extend([other, case]);
            }
            GoalTruth::Fact(fact) => {
                if !case.facts.contains(&fact.negated()) {
                    case.facts.push(fact);
                    open.push(case);
                }
            }
            GoalTruth::Below {
                low,
                high,
                is_strict,
            } => {
                if case.order.add(low, high, is_strict) {
                    open.push(case);
                }
            }
        }
    }
    true
}

/// A proposition still to be decomposed.
#[derive(Clone, Copy)]
enum Goal {
    Is(OpId, bool),
    /// `low < high` if strict, `low <= high` otherwise.
    Below {
        low: OpId,
        high: OpId,
        is_strict: bool,
    },
}

/// The decomposition of a goal.
enum GoalTruth {
    Anything,
    Never,
    All([Goal; 2]),
    One(Vec<Goal>, Vec<Goal>),
    Fact(Fact),
    Below {
        low: OrderedValue,
        high: OrderedValue,
        is_strict: bool,
    },
}

/// A constant, or an unknown value (identified by a hash) with its range.
#[derive(Clone, Copy)]
enum OrderedValue {
    Known(f64),
    Found { key: u64, lo: f64, hi: f64 },
}

/// A conjunction: one branch of the case analysis.
#[derive(Clone, Default)]
struct Assumptions {
    goals: Vec<Goal>,
    facts: Vec<Fact>,
    order: ValueOrder,
}

struct Cases<'x> {
    query: Query<'x>,
    conditions: &'x Conditions,
}

impl Cases<'_> {
    fn meaning(&self, goal: Goal) -> GoalTruth {
        match goal {
            Goal::Is(op, truth) => self.answer(op, truth),
            Goal::Below {
                low,
                high,
                is_strict,
            } => self.below(low, high, is_strict),
        }
    }

    fn answer(&self, op: OpId, truth: bool) -> GoalTruth {
        let module = self.query.module;
        let is = |a, truth| Goal::Is(a, truth);
        match module.op(op).kind {
            OpKind::Const(_) => match module.constant(op) {
                [value] if value.as_bool() != truth => GoalTruth::Never,
                _ => GoalTruth::Anything,
            },
            OpKind::Unary(Unary::Not, a) => GoalTruth::All([is(a, !truth), is(a, !truth)]),
            OpKind::Binary(Binary::And, a, b) => match truth {
                true => GoalTruth::All([is(a, true), is(b, true)]),
                false => GoalTruth::One(vec![is(a, false)], vec![is(a, true), is(b, false)]),
            },
            OpKind::Binary(Binary::Or, a, b) => match truth {
                true => GoalTruth::One(vec![is(a, true)], vec![is(a, false), is(b, true)]),
                false => GoalTruth::All([is(a, false), is(b, false)]),
            },
            OpKind::Binary(kind, a, b) if kind.compares() => {
                let (low, high) = match (kind, truth) {
                    (Binary::Less | Binary::LessEqual, true)
                    | (Binary::Greater | Binary::GreaterEqual, false) => (a, b),
                    _ => (b, a),
                };
                let is_strict = matches!(kind, Binary::Less | Binary::Greater) == truth;
                self.below(low, high, is_strict)
            }
            OpKind::Same {
                negated,
                left,
                right,
            } if self.is_number(left) => {
                let below = |low, high, is_strict| Goal::Below {
                    low,
                    high,
                    is_strict,
                };
                match truth != negated {
                    true => GoalTruth::All([below(left, right, false), below(right, left, false)]),
                    false => {
                        let less = below(left, right, true);
                        GoalTruth::One(vec![less], vec![below(right, left, true)])
                    }
                }
            }
            _ => {
                let fact = self.conditions.fact(module, op, truth);
                fact.map_or(GoalTruth::Anything, GoalTruth::Fact)
            }
        }
    }

    fn is_number(&self, op: OpId) -> bool {
        let ty = self.query.module.ty(op);
        ty.is_scalar() && ty.scalar_kind() != Some(Scalar::Bool)
    }

    fn below(&self, low: OpId, high: OpId, is_strict: bool) -> GoalTruth {
        let goal = |low, high| Goal::Below {
            low,
            high,
            is_strict,
        };
        if let Some((is_most, [a, b])) = self.extreme(high) {
            let (a, b) = (goal(low, a), goal(low, b));
            return match is_most {
                true => GoalTruth::One(vec![a], vec![b]),
                false => GoalTruth::All([a, b]),
            };
        }
        if let Some((is_most, [a, b])) = self.extreme(low) {
            let (a, b) = (goal(a, high), goal(b, high));
            return match is_most {
                true => GoalTruth::All([a, b]),
                false => GoalTruth::One(vec![a], vec![b]),
            };
        }
        let (Some(mut left), Some(mut right)) = (self.value(low), self.value(high)) else {
            return GoalTruth::Anything;
        };
        let is_integer = self.query.module.ty(low).scalar_kind() != Some(Scalar::Float);
        let mut is_strict = is_strict;
        // For integers, `a < b` with a constant `b` is `a <= b - 1`.
        if is_integer && is_strict {
            match (&mut left, &mut right) {
                (_, OrderedValue::Known(value)) => (*value, is_strict) = (*value - 1.0, false),
                (OrderedValue::Known(value), _) => (*value, is_strict) = (*value + 1.0, false),
                _ => {}
            }
        }
        GoalTruth::Below {
            low: left,
            high: right,
            is_strict,
        }
    }

    /// The operands of a `max` (`true`) or `min` (`false`), looking through one variable.
    fn extreme(&self, op: OpId) -> Option<(bool, [OpId; 2])> {
        let (module, defs) = (self.query.module, self.query.defs);
        let mut at = op;
        if let OpKind::Load(_) = module.op(op).kind
            && let Def::Stored { value, .. } = defs.get(defs.unrefined(defs.seen(op, 0)))
            && module.ty(value).is_scalar()
        {
            at = value;
        }
        let OpKind::Builtin(function, list) = module.op(at).kind else {
            return None;
        };
        let is_most = match function.transfer() {
            Transfer::Maximum => true,
            Transfer::Minimum => false,
            _ => return None,
        };
        match module.operands(list) {
            [a, b] if module.ty(at).is_scalar() => Some((is_most, [*a, *b])),
            _ => None,
        }
    }

    fn value(&self, op: OpId) -> Option<OrderedValue> {
        let (query, module) = (self.query, self.query.module);
        if !self.is_number(op) {
            return None;
        }
        let range = query.lane(op, 0);
        if let Some(value) = range.single() {
            return Some(OrderedValue::Known(value));
        }
        Some(OrderedValue::Found {
            key: self.conditions.number(module, op)?,
            lo: range.lo.value,
            hi: range.hi.value,
        })
    }
}

/// A transitively closed order of values: by pair, whether the first is `<=` or `<` the second.
#[derive(Clone, Default)]
struct ValueOrder {
    values: Vec<OrderedValue>,
    pairs: [[OrderStep; MAX_VALUES]; MAX_VALUES],
}

/// The known relation of one value to another.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
enum OrderStep {
    #[default]
    Unknown,
    AtMost,
    Less,
}

impl ValueOrder {
    /// Adds `low < high` or `low <= high`; `false` if that is a contradiction.
    fn add(&mut self, low: OrderedValue, high: OrderedValue, is_strict: bool) -> bool {
        let (Some(low), Some(high)) = (self.place(low), self.place(high)) else {
            // Too many values.
            return true;
        };
        let step = match is_strict {
            true => OrderStep::Less,
            false => OrderStep::AtMost,
        };
        self.join(low, high, step)
    }

    fn step(&self, from: usize, to: usize) -> OrderStep {
        match from == to {
            true => OrderStep::AtMost,
            false => self
                .pairs
                .get(from)
                .and_then(|row| row.get(to))
                .copied()
                .unwrap_or_default(),
        }
    }

    fn join(&mut self, low: usize, high: usize, step: OrderStep) -> bool {
        let mut may_be = true;
        for from in 0..self.values.len() {
            let before = self.step(from, low);
            for to in 0..self.values.len() {
                let after = self.step(high, to);
                if before == OrderStep::Unknown || after == OrderStep::Unknown {
                    continue;
                }
                let all = step.max(before).max(after);
                may_be &= from != to || all != OrderStep::Less;
                if let Some(slot) = self.pairs.get_mut(from).and_then(|row| row.get_mut(to)) {
                    *slot = all.max(*slot);
                }
            }
        }
        may_be
    }

    /// The index of a value, which is added if necessary; `None` if there are too many.
    fn place(&mut self, value: OrderedValue) -> Option<usize> {
        let is_it = |other: &OrderedValue| match (value, *other) {
            (OrderedValue::Known(a), OrderedValue::Known(b)) => a == b,
            (OrderedValue::Found { key: a, .. }, OrderedValue::Found { key: b, .. }) => a == b,
            _ => false,
        };
        if let Some(known) = self.values.iter().position(is_it) {
            return Some(known);
        }
        let own = self.values.len();
        if own >= MAX_VALUES {
            return None;
        }
        self.values.push(value);
        match value {
            OrderedValue::Known(number) => {
                for other in 0..own {
                    match self.values.get(other) {
                        Some(OrderedValue::Known(known)) if *known < number => {
                            self.join(other, own, OrderStep::Less);
                        }
                        Some(OrderedValue::Known(_)) => {
                            self.join(own, other, OrderStep::Less);
                        }
                        _ => {}
                    }
                }
            }
            OrderedValue::Found { lo, hi, .. } => {
                if lo.is_finite()
                    && let Some(low) = self.place(OrderedValue::Known(lo))
                {
                    self.join(low, own, OrderStep::AtMost);
                }
                if hi.is_finite()
                    && let Some(high) = self.place(OrderedValue::Known(hi))
                {
                    self.join(own, high, OrderStep::AtMost);
                }
            }
        }
        Some(own)
    }
}
