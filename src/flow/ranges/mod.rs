//! What numbers the values of a shader may be: an interval analysis on definitions.
//!
//! A value's range follows from those of its operands, a definition's from what was stored, and
//! conditions narrow it down. Only what is asked for is computed, and each answer is kept. Values
//! that hang on themselves, through the turns of a loop, are solved together (Rodrigues, Campos and
//! Pereira, *A Fast and Low-Overhead Technique to Secure Programs Against Integer Overflows*, 2013):
//! from below, with bounds that keep moving widened, and then narrowed by the conditions again.

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

use super::defs::condition::each_comparison;
use super::defs::{DefId, Defs, Guard};
use super::same::is_same;
use back::Wanted;
use node::Node;
use shaderlint_ir::{Binary, Module, OpId, OpKind, length_lane};
use shaderlint_semantic::builtins::Transfer;
use shaderlint_semantic::{FunctionRef, Program, Scalar, Value, VariableId};
use shaderlint_syntax::ast::ExprId;
use solve::Known;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// How many conditions around an operation are looked at.
const MAX_GUARDS: usize = 24;

/// What is known of a shader's numbers so far.
#[derive(Default, Debug)]
pub struct Ranges {
    known: Mutex<Known>,
    /// By variable: whether code that is not understood may write to it.
    hidden_variables: Vec<bool>,
    /// By function: whether nobody knows what it returns, and what it is given.
    hidden_functions: Vec<bool>,
}

/// Answers questions about the ranges of a shader.
#[derive(Clone, Copy)]
pub struct Query<'x> {
    /// The shader.
    pub program: &'x Program,
    /// Its middle form.
    pub module: &'x Module,
    /// Which write each read sees.
    pub defs: &'x Defs,
    /// What is known already.
    pub ranges: &'x Ranges,
}

impl Ranges {
    /// Forgets what is known of globals, of parameters of functions and of what functions return,
    /// where code that is not understood may name them.
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

    fn known(&self) -> MutexGuard<'_, Known> {
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
    /// The range of a lane of an operation's value.
    pub fn lane(&self, op: OpId, lane: u32) -> Interval {
        let Some(node) = Node::lane(self.defs, op, lane) else {
            return Interval::ANY;
        };
        let mut known = self.ranges.known();
        // What never has a value is not looked into.
        known.solve(self, node).unwrap_or(Interval::ANY)
    }

    /// The range of a definition.
    pub fn def(&self, def: DefId) -> Interval {
        let mut known = self.ranges.known();
        let node = Node::def(self.defs, def);
        known.solve(self, node).unwrap_or(Interval::ANY)
    }

    /// The ranges of the components of a number or vector. What the conditions around it tell of the
    /// very same value counts too; where they contradict each other, nothing is known.
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
            .map(|v| Interval::constant(number(*v)));
        let op = self.module.op_of(expr).filter(|_| values.is_empty());
        constants.chain(op.into_iter().flat_map(move |op| self.components(op)))
    }

    /// Whether the conditions around an operation may all hold.
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

    /// Whether a condition may hold where it is looked at.
    fn is_met(&self, guard: Guard) -> bool {
        let mut is_met = true;
        let (module, defs) = (self.module, self.defs);
        let (condition, truth) = (guard.condition, guard.truth);
        each_comparison(module, defs, condition, truth, |told| {
            let (comparison, truth) = (told.comparison, told.truth);
            if let OpKind::Binary(_, left, _) | OpKind::Same { left, .. } =
                module.op(comparison).kind
            {
                let mut range = self.lane(left, 0);
                let wanted = self.wanted(comparison, truth, false);
                wanted.narrow(&mut range, self.is_float(left));
                is_met &= range.lo.value <= range.hi.value;
            }
        });
        is_met
    }

    fn wanted(&self, comparison: OpId, truth: bool, is_right: bool) -> Wanted {
        Wanted::of(self, comparison, truth, (is_right, 0), |node| {
            let known = self.ranges.known().solve(self, node);
            Some(known.unwrap_or(Interval::ANY))
        })
    }

    /// Narrows by the conditions around that speak of the same value, computed once more:
    /// `f(x) > 0.0 ? log(f(x)) : 0.0`.
    fn narrow_written(&self, op: OpId, lane: u32, range: &mut Interval) {
        let is_load = matches!(self.module.op(op).kind, OpKind::Load(_));
        let is_written = !is_load && self.module.ty(op).is_scalar();
        let mut own = None;
        for (_, guard) in self.defs.guards(op).take(MAX_GUARDS) {
            let (condition, truth) = (guard.condition, guard.truth);
            let (module, defs) = (self.module, self.defs);
            each_comparison(module, defs, condition, truth, |told| {
                if told.call.is_some() {
                    return;
                }
                if is_written {
                    self.narrow_by(told.comparison, told.truth, op, range);
                }
                if let OpKind::Binary(relation, left, right) = module.op(told.comparison).kind
                    && self.is_float(op)
                    && self.is_float(left)
                    && (is_written || range.lo.is_reached() || range.hi.is_reached())
                    && let Some(own) = own.get_or_insert_with(|| self.terms(op, lane))
                {
                    let relation = if told.truth {
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
            let wanted = match magnitude.is_some_and(|inner| same(*inner)) {
                true => self.wanted(comparison, truth, is_right).magnitude(),
                false if same(side) => self.wanted(comparison, truth, is_right),
                false => continue,
            };
            let before = *range;
            wanted.narrow(range, self.is_float(op));
            if range.lo.value > range.hi.value {
                *range = Interval::ANY.like(&before);
            }
        }
    }

    fn is_float(&self, op: OpId) -> bool {
        self.module.ty(op).scalar_kind() == Some(Scalar::Float)
    }

    /// Integers are whole, and wrap round where they are too large.
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

/// A scalar as a number.
pub(super) fn number(value: Value) -> f64 {
    match value {
        Value::Int(v) => v as f64,
        Value::Uint(v) => v as f64,
        v => v.as_float() as f64,
    }
}

/// The operator that is true where `op` is false.
const fn negated(op: Binary) -> Binary {
    match op {
        Binary::Less => Binary::GreaterEqual,
        Binary::LessEqual => Binary::Greater,
        Binary::Greater => Binary::LessEqual,
        Binary::GreaterEqual => Binary::Less,
        op => op,
    }
}

/// The operator with its sides changed.
const fn turned(op: Binary) -> Binary {
    match op {
        Binary::Less => Binary::Greater,
        Binary::LessEqual => Binary::GreaterEqual,
        Binary::Greater => Binary::Less,
        Binary::GreaterEqual => Binary::LessEqual,
        op => op,
    }
}
