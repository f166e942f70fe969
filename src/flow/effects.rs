//! What expressions and functions do besides giving a value.

use super::calls::Calls;
use super::writes::{Writes, is_temporary};
use shaderlint_ir::{Module, OpId, OpKind, Provenance, Root, Step};
use shaderlint_semantic::{FunctionRef, Program, Structure};
use shaderlint_syntax::ast::ExprId;

/// What a call of a function does besides giving a value.
#[derive(Clone, Copy, Default, Debug)]
struct Summary {
    /// Whether it gives values back through parameters.
    gives_back: bool,
    /// Whether it writes to what outlives it, or ends the shader, wherever it does so.
    acts: bool,
    /// Whether it touches what may hold something else at another call.
    depends: bool,
}

/// Which expressions and functions do something that is seen elsewhere.
#[derive(Default, Debug)]
pub struct Effects {
    /// By expression, its operands included.
    exprs: Vec<bool>,
    functions: Vec<Summary>,
}

impl Effects {
    /// Finds the effects in a shader.
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
        for caller in calls.graph().bottom_up() {
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

    /// An expression does something, and so does each that it is an operand of.
    fn add(&mut self, structure: &Structure, expr: ExprId) {
        let mut at = Some(expr);
        while let Some(expr) = at
            && let Some(slot @ false) = self.exprs.get_mut(expr.0 as usize)
        {
            *slot = true;
            at = structure.parent(expr);
        }
    }

    /// What nobody knows may do anything.
    fn summary(&self, function: FunctionRef) -> Summary {
        let unknown = Summary {
            gives_back: true,
            acts: true,
            depends: true,
        };
        let found = self.functions.get(function.0 as usize);
        found.copied().unwrap_or(unknown)
    }

    /// Whether an expression does more than have a value.
    pub fn has(&self, expr: ExprId) -> bool {
        self.exprs.get(expr.0 as usize).is_none_or(|e| *e)
    }

    /// Whether a function gives the same answer to the same arguments wherever it is called, and
    /// changes nothing.
    pub fn is_pure(&self, function: FunctionRef) -> bool {
        let found = self.summary(function);
        !found.depends && !found.gives_back
    }
}

/// What a function does by itself.
fn summary(module: &Module, writes: &Writes, id: FunctionRef) -> Summary {
    let mut found = Summary::default();
    let Some((function, body)) = module.function(id).and_then(|f| Some((f, f.body?))) else {
        return Summary {
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
