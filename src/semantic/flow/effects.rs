//! What an expression does besides having a value, and what a function does besides returning one.

use super::{CallGraph, Structure, each_operand};
use crate::semantic::builtins::Builtins;
use crate::semantic::{Direction, FunctionRef, Program, Resolution, Storage, VariableId};
use crate::syntax::Name;
use crate::syntax::ast::*;

/// Which expressions and functions do something that is seen elsewhere.
#[derive(Default, Debug)]
pub struct Effects {
    /// By expression, its operands included.
    exprs: Vec<bool>,
    /// By function: whether a call does more than give a value.
    functions: Vec<bool>,
}

impl Effects {
    /// Finds the effects in a shader.
    pub fn of(program: &Program, structure: &Structure, calls: &CallGraph) -> Effects {
        let functions = functions(program, structure, calls);
        let tree = &program.tree;
        let mut exprs = vec![false; tree.exprs.len()];
        for (i, expr) in tree.exprs.iter().enumerate() {
            let mut found = match expr.kind {
                ExprKind::Error | ExprKind::Assign(..) | ExprKind::Postfix(..) => true,
                ExprKind::Unary(op, _) => op.assigns(),
                ExprKind::Call(..) => match program.expr(ExprId(i as u32)).resolution {
                    Resolution::Function(f) => functions.get(f.0 as usize).is_none_or(|f| *f),
                    Resolution::Builtin(overload) => builtin_writes(program, overload),
                    _ => false,
                },
                _ => false,
            };
            each_operand(tree, expr, |child| {
                found |= exprs.get(child.0 as usize).is_none_or(|e| *e);
            });
            if let Some(slot) = exprs.get_mut(i) {
                *slot = found;
            }
        }
        Effects { exprs, functions }
    }

    /// Whether an expression does more than have a value.
    pub fn has(&self, expr: ExprId) -> bool {
        self.exprs.get(expr.0 as usize).is_none_or(|e| *e)
    }

    /// Whether a call of a function does more than give a value.
    pub fn of_call(&self, function: FunctionRef) -> bool {
        self.functions.get(function.0 as usize).is_none_or(|f| *f)
    }
}

fn builtin_writes(program: &Program, overload: u32) -> bool {
    Builtins::of(program.version, program.stage)
        .overload(overload)
        .is_none_or(|o| o.out != 0)
}

/// By function: whether it writes to anything that outlives it, or ends the shader.
fn functions(program: &Program, structure: &Structure, calls: &CallGraph) -> Vec<bool> {
    let tree = &program.tree;
    let mut found: Vec<bool> = program
        .functions
        .iter()
        .map(|f| f.definition.is_none() || f.params.iter().any(|p| p.direction.writes()))
        .collect();
    let mut mark = |function: Option<FunctionRef>| {
        if let Some(slot) = function.and_then(|f| found.get_mut(f.0 as usize)) {
            *slot = true;
        }
    };
    for (i, stmt) in tree.stmts.iter().enumerate() {
        if stmt.kind == StmtKind::Discard {
            mark(structure.function_of(StmtId(i as u32)));
        }
    }
    for (i, expr) in tree.exprs.iter().enumerate() {
        let id = ExprId(i as u32);
        let writes = match expr.kind {
            ExprKind::Assign(_, target, _) | ExprKind::Postfix(_, target) => {
                outlives(program, target)
            }
            ExprKind::Unary(op, target) => op.assigns() && outlives(program, target),
            ExprKind::Call(_, args) => {
                let written = tree.args(args).iter().enumerate();
                let mut written = written.filter(|(place, _)| writes_argument(program, id, *place));
                written.any(|(_, &arg)| outlives(program, arg))
            }
            _ => false,
        };
        if writes {
            mark(structure.function_of_expr(id));
        }
    }
    spread(calls, &mut found);
    found
}

/// Whether a call writes to the argument at a place.
fn writes_argument(program: &Program, call: ExprId, place: usize) -> bool {
    match program.expr(call).resolution {
        Resolution::Function(f) => program
            .function(f)
            .and_then(|f| f.params.get(place))
            .is_some_and(|p| p.direction.writes()),
        Resolution::Builtin(overload) => Builtins::of(program.version, program.stage)
            .overload(overload)
            .is_some_and(|o| o.writes(place)),
        _ => false,
    }
}

/// Whether what an assignment writes to is still there when the function has returned.
fn outlives(program: &Program, target: ExprId) -> bool {
    let storage = root(program, target)
        .and_then(|v| program.variable(v))
        .map(|v| v.storage);
    !matches!(
        storage,
        Some(Storage::Local | Storage::Param(Direction::In | Direction::ConstIn))
    )
}

/// The variable that an assignment to `target` writes to, wholly or in part.
pub fn root(program: &Program, target: ExprId) -> Option<VariableId> {
    let mut at = target;
    while let ExprKind::Paren(inner) | ExprKind::Member(inner, _) | ExprKind::Index(inner, _) =
        program.tree.expr(at).kind
    {
        at = inner;
    }
    program.variable_of(at)
}

/// The components of a vector that a member expression picks, a bit each; `None` where it picks a
/// member of a struct.
pub fn swizzled(program: &Program, object: ExprId, name: Name) -> Option<u8> {
    let text = program.names.text(name);
    let number = |c| {
        let mut sets = ["xyzw", "rgba", "stpq"].iter();
        sets.find_map(|set| set.find(c))
    };
    let is_vector = program.ty(object).is_vector();
    let numbers = text.chars().map(|c| number(c).filter(|_| is_vector));
    numbers
        .into_iter()
        .try_fold(0, |mask, n| Some(mask | 1 << n?))
}

/// Who calls a function with effects has effects. A function with `out` parameters of its own may
/// be called on locals, which is not told apart.
fn spread(calls: &CallGraph, found: &mut [bool]) {
    let marked = |(i, f): (usize, &bool)| f.then_some(FunctionRef(i as u32));
    let mut todo: Vec<FunctionRef> = found.iter().enumerate().filter_map(marked).collect();
    while let Some(next) = todo.pop() {
        for caller in calls.calls_of(next).filter_map(|c| c.caller) {
            match found.get_mut(caller.0 as usize) {
                Some(slot) if !*slot => *slot = true,
                _ => continue,
            }
            todo.push(caller);
        }
    }
}
