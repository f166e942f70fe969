//! Which functions give the same answer to the same arguments and change nothing.

use super::calls::arguments;
use super::effects::root;
use super::{CallGraph, Structure};
use crate::semantic::{FunctionRef, Program, Resolution, Storage, VariableId};
use crate::syntax::ast::*;

/// What the functions of a shader do besides giving a value back.
#[derive(Default, Debug)]
pub struct Purity {
    /// By function: whether it, or one that it calls, has effects or depends on them.
    impure: Vec<bool>,
}

impl Purity {
    /// Looks at every expression of a shader once.
    pub fn of(program: &Program, structure: &Structure, calls: &CallGraph) -> Purity {
        let mut impure: Vec<bool> = program
            .functions
            .iter()
            .map(|f| f.definition.is_none() || f.params.iter().any(|p| p.direction.writes()))
            .collect();
        for i in 0..program.tree.exprs.len() as u32 {
            let id = ExprId(i);
            if touches_globals(program, id)
                && let Some(function) = structure.function_of_expr(id)
                && let Some(mark) = impure.get_mut(function.0 as usize)
            {
                *mark = true;
            }
        }
        for function in calls.bottom_up() {
            let calls_impure = calls
                .calls_by(function)
                .any(|c| impure.get(c.callee.0 as usize).is_none_or(|i| *i));
            if let Some(mark) = impure.get_mut(function.0 as usize) {
                *mark |= calls_impure;
            }
        }
        Purity { impure }
    }

    /// Whether a function gives the same answer to the same arguments wherever it is called, and
    /// changes nothing.
    pub fn is_pure(&self, function: FunctionRef) -> bool {
        self.impure
            .get(function.0 as usize)
            .is_some_and(|impure| !impure)
    }
}

/// Whether an expression names a global variable that something writes to, which covers both
/// reading and writing it.
fn touches_globals(program: &Program, id: ExprId) -> bool {
    let Resolution::Variable(variable) = program.expr(id).resolution else {
        return false;
    };
    program.variable(variable).is_some_and(|v| match v.storage {
        Storage::Global => v.written,
        Storage::Output => true,
        _ => false,
    })
}

/// Calls `visit` with every variable that an expression itself writes to, its operands' writes
/// left out.
pub fn each_written(program: &Program, id: ExprId, mut visit: impl FnMut(VariableId)) {
    let mut write = |e: ExprId| root(program, e).into_iter().for_each(&mut visit);
    match program.tree.expr(id).kind {
        ExprKind::Assign(_, target, _) => write(target),
        ExprKind::Postfix(_, target) => write(target),
        ExprKind::Unary(op, target) if op.assigns() => write(target),
        ExprKind::Call(_, args) => {
            if let Resolution::Function(callee) = program.expr(id).resolution {
                let params = program.function(callee).map_or(&[][..], |f| &f.params);
                for (param, &arg) in params.iter().zip(arguments(program, id)) {
                    if param.direction.writes() {
                        write(arg);
                    }
                }
            } else if let Some(overload) = program.overload_called(id).filter(|o| o.out != 0) {
                let args = program.tree.args(args).iter().enumerate();
                let written = args.filter(|(i, _)| overload.writes(*i));
                written.for_each(|(_, &arg)| write(arg));
            }
        }
        _ => {}
    }
}
