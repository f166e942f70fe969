//! Side effects of expressions and functions.

use super::calls::Calls;
use super::writes::{Writes, is_temporary};
use shaderlint_ir::{Module, OpId, OpKind, Provenance, Root, Step};
use shaderlint_semantic::{FunctionRef, Program, Structure};
use shaderlint_syntax::ast::ExprId;

/// The side effects of one function.
#[derive(Clone, Copy, Default, Debug)]
struct CallSummary {
    /// Whether it has `out` or `inout` parameters.
    gives_back: bool,
    /// Whether it, or a function that it calls, writes to globals or outputs or executes `discard`.
    acts: bool,
    /// Whether it accesses state that may change between calls: mutable globals or outputs.
    depends: bool,
}

/// The expressions and functions with side effects.
#[derive(Default, Debug)]
pub struct Effects {
    /// By expression, including the effects of its operands.
    exprs: Vec<bool>,
    functions: Vec<CallSummary>,
}

impl Effects {
    /// Computes the side effects of all expressions and functions.
    pub fn of(
        program: &Program,
        module: &Module,
        structure: &Structure,
        calls: &Calls,
        writes: &Writes,
    ) -> Effects {
        let mut effects = Effects {
            exprs: vec![false; program.tree.exprs.len()],
            functions: Vec::with_capacity(module.functions.len()),
        };
        effects.functions = (0..module.functions.len() as u32)
            .map(|i| summary(module, writes, FunctionRef(i)))
            .collect();
        for caller in calls.graph.bottom_up() {
            let called = calls.calls_by(caller).map(|c| effects.summary(c.callee));
            let (acts, depends) = called.fold((false, false), |(acts, depends), callee| {
                (
                    acts | callee.acts,
                    depends | callee.depends | callee.gives_back,
                )
            });
            if let Some(slot) = effects.functions.get_mut(caller.0 as usize) {
                slot.acts |= acts;
                slot.depends |= depends;
            }
        }
        for (op, made) in (0..).map(OpId).zip(&module.ops) {
            let acts = match made.kind {
                OpKind::Store(place, _) => !is_temporary(module, place),
                OpKind::Call(callee, _) => effects.summary(callee).acts,
                OpKind::Unknown => true,
                _ => false,
            };
            if let (true, Provenance::Expr(expr)) = (acts, module.provenance(op)) {
                effects.add(structure, expr);
            }
        }
        effects
    }

    /// Marks an expression and all expressions around it.
    fn add(&mut self, structure: &Structure, expr: ExprId) {
        let mut at = Some(expr);
        while let Some(expr) = at
            && let Some(slot @ false) = self.exprs.get_mut(expr.0 as usize)
        {
            *slot = true;
            at = structure.parent(expr);
        }
    }

    /// The summary of a function; a function that is not known may do anything.
    fn summary(&self, function: FunctionRef) -> CallSummary {
        let unknown = CallSummary {
            gives_back: true,
            acts: true,
            depends: true,
        };
        let found = self.functions.get(function.0 as usize);
        found.copied().unwrap_or(unknown)
    }

    /// Whether an expression has side effects, its operands included.
    pub fn has(&self, expr: ExprId) -> bool {
        self.exprs.get(expr.0 as usize).is_none_or(|e| *e)
    }

    /// Whether a call of a function writes to globals or outputs, or executes `discard`.
    pub fn acts(&self, function: FunctionRef) -> bool {
        self.summary(function).acts
    }

    /// Whether a function is pure: equal arguments give equal results, and nothing is written.
    pub fn is_pure(&self, function: FunctionRef) -> bool {
        let found = self.summary(function);
        !found.depends && !found.gives_back
    }
}

/// The effects of a function's own code, without those of the functions that it calls.
fn summary(module: &Module, writes: &Writes, id: FunctionRef) -> CallSummary {
    let mut found = CallSummary::default();
    let Some((function, body)) = module.function(id).and_then(|f| Some((f, f.body?))) else {
        return CallSummary {
            gives_back: true,
            acts: true,
            depends: true,
        };
    };
    let parameters = module.parameters(function).iter();
    found.gives_back = parameters
        .filter_map(|p| module.variable(*p))
        .any(|p| matches!(p.root, Root::ParameterOut | Root::ParameterInout));
    for op in function.ops.ops() {
        let (place, is_store) = match module.op(op).kind {
            OpKind::Load(place) => (place, false),
            OpKind::Store(place, _) => (place, true),
            _ => continue,
        };
        let variable = module.place(place).variable;
        match module.variable(variable).map(|v| v.root) {
            Some(Root::Output) => found.depends = true,
            Some(Root::Global) if is_store || writes.changes(variable) => found.depends = true,
            _ => continue,
        }
        found.acts |= is_store;
    }
    let mut steps = module.steps_in(module.steps(body));
    found.acts |= steps.any(|step| matches!(step, Step::Discard(_)));
    found
}
