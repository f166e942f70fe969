//! Value ranges: an interval analysis on the SSA definitions.
//!
//! The range of a value is computed from those of its operands, the range of a definition from the
//! stored value, and conditions narrow it. Ranges are computed on demand and cached. Values that
//! depend on each other cyclically, through loops, are solved per strongly connected component
//! (Rodrigues, Campos and Pereira, *A Fast and Low-Overhead Technique to Secure Programs Against
//! Integer Overflows*, 2013): ascending iteration with widening up to a fixed point, followed by
//! descending iteration (narrowing).

mod back;
mod builtin;
mod copies;
mod entry;
mod interval;
mod matrix;
mod node;
mod operation;
mod polynomial;
mod reason;
mod screen;
mod solve;
#[cfg(test)]
mod tests;

pub use interval::{End, Interval, Rounding, Tightness};
pub use reason::{Giver, Reason, Side};

use super::reaching_definitions::condition::each_comparison;
use super::reaching_definitions::{DefId, Guard, ReachingDefinitions};
use super::same::is_same;
use back::RequiredRange;
use node::Node;
use shaderlint_ir::{Binary, Module, OpId, OpKind, length_lane};
use shaderlint_semantic::builtins::Transfer;
use shaderlint_semantic::{FunctionRef, Program, Scalar, VariableId};
use shaderlint_syntax::ast::ExprId;
use solve::SolverState;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Maximum number of guards of an operation that are considered.
const MAX_GUARDS: usize = 24;

/// The cached value ranges of a shader.
#[derive(Default, Debug)]
pub struct Ranges {
    known: Mutex<SolverState>,
    /// By variable: whether code that was not analysed may write to it.
    hidden_variables: Vec<bool>,
    /// By function: whether its arguments and return value are unknown.
    hidden_functions: Vec<bool>,
}

/// Range queries on a shader.
#[derive(Clone, Copy)]
pub struct Query<'x> {
    /// The checked program.
    pub program: &'x Program,
    /// Its IR.
    pub module: &'x Module,
    /// Its reaching definitions.
    pub defs: &'x ReachingDefinitions,
    /// The cache of computed ranges.
    pub ranges: &'x Ranges,
}

impl Ranges {
    /// Discards what is known about globals, parameters and return values that code that was not
    /// analysed may access, as `is_named` reports.
    pub fn forget(&mut self, program: &Program, is_named: impl Fn(&str) -> bool) {
        let is_named = |name| is_named(program.names.text(name));
        let functions = program.functions.iter();
        self.hidden_functions = functions.map(|f| is_named(f.name)).collect();
        let hidden = program.variables.iter().map(|v| match v.function {
            Some(f) => self.hidden_functions.get(f.0 as usize) == Some(&true),
            None => is_named(v.name),
        });
        self.hidden_variables = hidden.collect();
    }

    fn known(&self) -> MutexGuard<'_, SolverState> {
        self.known.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn hides_variable(&self, id: VariableId) -> bool {
        self.hidden_variables.get(id.0 as usize) == Some(&true)
    }

    fn hides_function(&self, id: FunctionRef) -> bool {
        self.hidden_functions.get(id.0 as usize) == Some(&true)
    }
}

impl<'x> Query<'x> {
    /// The range of a component of an operation's value.
    pub fn lane(&self, op: OpId, lane: u32) -> Interval {
        let Some(node) = Node::lane(self.defs, op, lane) else {
            return Interval::ANY;
        };
        let mut known = self.ranges.known();
        // Values that never exist (unreachable code) count as unbounded.
        known.solve(self, node).unwrap_or(Interval::ANY)
    }

    /// The range of a definition.
    pub fn def(&self, def: DefId) -> Interval {
        let mut known = self.ranges.known();
        let node = Node::def(self.defs, def);
        known.solve(self, node).unwrap_or(Interval::ANY)
    }

    /// The ranges of the components of a scalar or vector, narrowed by the guards that test the
    /// same value. Unbounded if the guards contradict each other.
    pub fn components(self, op: OpId) -> impl Iterator<Item = Interval> + use<'x> {
        let ty = self.module.ty(op);
        let count = if ty.is_matrix() { 0 } else { ty.components() };
        let mut is_reached = None;
        (0..count).map(move |lane| {
            let mut range = self.lane(op, lane);
            if range.is_any() {
                return range;
            }
            if !*is_reached.get_or_insert_with(|| self.is_reached(op)) {
                return Interval::ANY.like(&range);
            }
            if count == 1 || range.lo.is_reached() || range.hi.is_reached() {
                self.narrow_written(op, lane, &mut range);
            }
            range
        })
    }

    /// The ranges of the components of an expression.
    pub fn expr(self, expr: ExprId) -> impl Iterator<Item = Interval> + use<'x> {
        let values = self.program.values(expr);
        let is_known =
            self.program.ty(expr).numeric().is_some() && !self.program.ty(expr).is_matrix();
        let constants = values
            .iter()
            .filter(move |_| is_known)
            .map(|v| Interval::constant(v.as_number()));
        let op = self.module.op_of(expr).filter(|_| values.is_empty());
        constants.chain(op.into_iter().flat_map(move |op| self.components(op)))
    }

    /// Whether all guards of an operation may hold.
    fn is_reached(&self, op: OpId) -> bool {
        let guards = self.defs.guards(op).take(MAX_GUARDS);
        let mut guards = guards.map(|(number, guard)| {
            let known = self.ranges.known().is_met(number);
            known.unwrap_or_else(|| {
                let is_met = self.is_met(guard);
                let mut known = self.ranges.known();
                known.keep_met(number, is_met, self.defs);
                is_met
            })
        });
        guards.all(|is_met| is_met)
    }

    /// Whether a guard may hold where it is evaluated.
    fn is_met(&self, guard: Guard) -> bool {
        let mut is_met = true;
        let (module, defs) = (self.module, self.defs);
        let (condition, truth) = (guard.condition, guard.truth);
        each_comparison(module, defs, condition, truth, |premise| {
            let (comparison, truth) = (premise.comparison, premise.truth);
            if let OpKind::Binary(_, left, _) | OpKind::Same { left, .. } =
                module.op(comparison).kind
            {
                let mut range = self.lane(left, 0);
                let required = self.required(comparison, truth, false);
                required.narrow(&mut range, self.is_float(left));
                is_met &= range.lo.value <= range.hi.value;
            }
        });
        is_met
    }

    fn required(&self, comparison: OpId, truth: bool, is_right: bool) -> RequiredRange {
        RequiredRange::of(self, comparison, truth, (is_right, 0), |node| {
            let known = self.ranges.known().solve(self, node);
            Some(known.unwrap_or(Interval::ANY))
        })
    }

    /// Narrows a range by guards that test the same expression, computed again: `f(x) > 0.0 ?
    /// log(f(x)) : 0.0`.
    fn narrow_written(&self, op: OpId, lane: u32, range: &mut Interval) {
        let is_load = matches!(self.module.op(op).kind, OpKind::Load(_));
        let is_written = !is_load && self.module.ty(op).is_scalar();
        let mut own = None;
        for (_, guard) in self.defs.guards(op).take(MAX_GUARDS) {
            let (condition, truth) = (guard.condition, guard.truth);
            let (module, defs) = (self.module, self.defs);
            each_comparison(module, defs, condition, truth, |premise| {
                if premise.call.is_some() {
                    return;
                }
                if is_written {
                    self.narrow_by(premise.comparison, premise.truth, op, range);
                }
                if let OpKind::Binary(relation, left, right) = module.op(premise.comparison).kind
                    && self.is_float(op)
                    && self.is_float(left)
                    && (is_written || range.lo.is_reached() || range.hi.is_reached())
                    && let Some(own) = own.get_or_insert_with(|| self.terms(op, lane))
                {
                    let relation = if premise.truth {
                        relation
                    } else {
                        negated(relation)
                    };
                    self.narrow_by_terms((left, right), relation, own, range);
                }
            });
        }
        if range.lo.value > range.hi.value {
            *range = Interval::ANY.like(range);
        }
    }

    fn narrow_by(&self, comparison: OpId, truth: bool, op: OpId, range: &mut Interval) {
        let (OpKind::Binary(_, left, right) | OpKind::Same { left, right, .. }) =
            self.module.op(comparison).kind
        else {
            return;
        };
        let same = |side| is_same(self.module, self.defs, side, op);
        for (side, is_right) in [(left, false), (right, true)] {
            let magnitude = match self.module.op(side).kind {
                OpKind::Builtin(function, list) => {
                    let is_magnitude = matches!(function.transfer(), Transfer::Magnitude);
                    self.module.operands(list).first().filter(|_| is_magnitude)
                }
                _ => None,
            };
            let required = match magnitude.is_some_and(|inner| same(*inner)) {
                true => self.required(comparison, truth, is_right).magnitude(),
                false if same(side) => self.required(comparison, truth, is_right),
                false => continue,
            };
            let before = *range;
            required.narrow(range, self.is_float(op));
            if range.lo.value > range.hi.value {
                *range = Interval::ANY.like(&before);
            }
        }
    }

    fn is_float(&self, op: OpId) -> bool {
        self.module.ty(op).scalar_kind() == Some(Scalar::Float)
    }

    /// Rounds an integer range to integers, and makes it unbounded if it may overflow.
    fn fit(&self, op: OpId, lane: u32, range: &mut Interval) {
        let ty = self.module.ty(op);
        let scalar = ty.element().scalar_kind();
        if scalar != Some(Scalar::Float) && length_lane(ty) != Some(lane) {
            *range = fitting(scalar, *range);
        }
    }
}

/// See [`Query::fit`].
fn fitting(scalar: Option<Scalar>, range: Interval) -> Interval {
    let (lo, hi) = match scalar {
        Some(Scalar::Int) => (i32::MIN as f64, i32::MAX as f64),
        Some(Scalar::Uint) => (0.0, u32::MAX as f64),
        Some(Scalar::Bool) => (0.0, 1.0),
        _ => return range,
    };
    let wraps = |r: &Interval| {
        (r.lo.value < lo && r.lo.value.is_finite()) || (r.hi.value > hi && r.hi.value.is_finite())
    };
    let mut fitting = match wraps(&range) {
        true => Interval::ANY.like(&range),
        false => range,
    };
    if lo == 0.0 && fitting.lo.value < 0.0 {
        fitting = Interval::new(0.0, f64::INFINITY, Tightness::Loose).like(&range);
    }
    fitting.exactly()
}

/// The comparison operator that is true where `op` is false.
const fn negated(op: Binary) -> Binary {
    match op {
        Binary::Less => Binary::GreaterEqual,
        Binary::LessEqual => Binary::Greater,
        Binary::Greater => Binary::LessEqual,
        Binary::GreaterEqual => Binary::Less,
        op => op,
    }
}

/// The comparison operator with its operands swapped.
const fn flipped(op: Binary) -> Binary {
    match op {
        Binary::Less => Binary::Greater,
        Binary::LessEqual => Binary::GreaterEqual,
        Binary::Greater => Binary::Less,
        Binary::GreaterEqual => Binary::LessEqual,
        op => op,
    }
}
