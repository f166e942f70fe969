//! Whether the range of a value depends on the code around it, or on the arguments of current callers.

use super::facts::Facts;
use rustc_hash::FxHashSet;
use shaderlint_flow::reaching_definitions::{Def, DefId};
use shaderlint_ir::{OpId, OpKind, Root};
use shaderlint_semantic::{BuiltinId, Program, Resolution, Storage, each_operand};
use shaderlint_syntax::ast::{BinaryOp, ExprId, ExprKind};

/// Most operations and definitions that are followed.
const MAX_PARTS: usize = 160;

/// Whether the function itself computes a value; callers and the host may pass anything.
pub fn is_computed_here(program: &Program, facts: &Facts, expr: ExprId) -> bool {
    let variable = program.variable_of(expr).and_then(|v| program.variable(v));
    let storage = variable.map(|v| v.storage);
    matches!(storage, None | Some(Storage::Local)) && !depends_on_callers(facts, expr)
}

/// Whether the range of an expression depends on arguments of callers or on globals: a check of such a
/// value is reasonable. Also true if the value takes too long to follow.
pub fn depends_on_callers(facts: &Facts, expr: ExprId) -> bool {
    let Some(op) = facts.module().op_of(expr) else {
        return false;
    };
    let mut search = GivenSearch {
        facts,
        ops: vec![op],
        defs: Vec::new(),
        seen_ops: FxHashSet::default(),
        seen_defs: FxHashSet::default(),
    };
    search.run()
}

/// Whether all variables of an expression are uniforms: `max(-iFrame, 1)` hides a constant from the
/// compiler on purpose.
pub fn is_of_uniforms(program: &Program, expr: ExprId) -> bool {
    let mut todo = vec![expr];
    let mut has_uniform = false;
    for _ in 0..MAX_PARTS {
        let Some(next) = todo.pop() else {
            return has_uniform;
        };
        if let Resolution::Variable(v) = program.expr(next).resolution {
            let variable = program.variable(v);
            if variable.is_none_or(|v| v.storage != Storage::Uniform && !v.is_const) {
                return false;
            }
            has_uniform |= variable.is_some_and(|v| v.storage == Storage::Uniform);
        }
        let tree = &program.tree;
        each_operand(tree, tree.expr(next), |child| todo.push(child));
    }
    false
}

/// Whether rounding cannot take a value beyond the end of its range: non-negative results never fall
/// below zero, and clamped results stay within their bounds.
pub fn is_exact(facts: &Facts, program: &Program, value: ExprId, is_low: bool) -> bool {
    use BuiltinId::*;
    let tree = &program.tree;
    let at = tree.unparen(value);
    match (tree.expr(at).kind, program.builtin_called(at)) {
        (_, Some(Clamp | Min | Max | Step | Fract | Smoothstep)) => true,
        (_, Some(Abs | Length | Distance | Exp | Exp2 | Sqrt)) => is_low,
        (ExprKind::Binary(BinaryOp::Mul, a, b), _) => is_low && facts.is_same(a, b),
        _ => false,
    }
}

struct GivenSearch<'a, 'p> {
    facts: &'a Facts<'p>,
    ops: Vec<OpId>,
    defs: Vec<DefId>,
    seen_ops: FxHashSet<OpId>,
    seen_defs: FxHashSet<DefId>,
}

impl GivenSearch<'_, '_> {
    fn run(&mut self) -> bool {
        while self.seen_ops.len() + self.seen_defs.len() < MAX_PARTS {
            if let Some(op) = self.ops.pop() {
                if self.seen_ops.insert(op) {
                    self.op(op);
                }
            } else if let Some(def) = self.defs.pop() {
                if self.seen_defs.insert(def) && self.def(def) {
                    return true;
                }
            } else {
                return false;
            }
        }
        true
    }

    fn op(&mut self, op: OpId) {
        let (module, defs) = (self.facts.module(), self.facts.reaching_definitions());
        match module.op(op).kind {
            OpKind::Load(_) => {
                let width = module.ty(op).components().max(1).min(defs.lanes_of(op));
                let seen = (0..width).map(|lane| defs.unrefined(defs.seen(op, lane)));
                self.defs.extend(seen);
            }
            OpKind::Call(function, _) => self.ops.extend(defs.returns_of(function)),
            _ => {
                let ops = &mut self.ops;
                module.each_operand(op, |operand| ops.push(operand));
            }
        }
    }

    /// Follows a definition; returns whether it is an argument or global with a known range.
    fn def(&mut self, def: DefId) -> bool {
        let (module, defs) = (self.facts.module(), self.facts.reaching_definitions());
        match defs.get(def) {
            Def::Stored { value, .. } => self.ops.push(value),
            Def::Merge { sides, .. } | Def::Measured(sides) => {
                let sides = defs.list(sides).iter();
                self.defs.extend(sides.map(|d| defs.unrefined(*d)));
            }
            Def::Head { init, back, .. } => {
                self.defs.extend([init, back].map(|d| defs.unrefined(d)));
            }
            Def::Refined { of, .. } => self.defs.push(defs.unrefined(of)),
            Def::Entry(slot) => {
                let (variable, _) = defs.variable_at(slot);
                let Some(variable) = module.variable(variable) else {
                    return true;
                };
                let is_inner = variable.function != self.facts.entry();
                let is_given = match variable.root {
                    Root::Parameter | Root::ParameterInout => is_inner,
                    Root::Global => true,
                    _ => false,
                };
                return is_given && !self.facts.ranges().def(def).is_any();
            }
            Def::Unknown => {}
        }
        false
    }
}
