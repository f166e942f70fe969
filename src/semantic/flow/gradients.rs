//! Calls that take derivatives between neighbouring pixels, and the code that parts the pixels.

use super::{CallGraph, Loops, Structure, Uniformity, Varying};
use crate::semantic::{BuiltinId, FunctionRef, Program};
use crate::syntax::ast::*;

/// A call that compares neighbouring pixels, in code that not all of them run.
#[derive(Clone, Copy, Debug)]
pub struct Gradient {
    /// The call.
    pub call: ExprId,
    /// The built-in function.
    pub function: BuiltinId,
    /// What parts the pixels.
    pub parted: Parted,
}

/// What parts neighbouring pixels.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Parted {
    /// A loop that some leave before others; the call stands in it, or in a function that is called
    /// from it.
    Loop(StmtId),
    /// A branch, or a return before.
    Branch(StmtId),
}

/// The calls that take derivatives where the pixels may have parted, in the order of the tree.
pub fn gradients(
    program: &Program,
    structure: &Structure,
    calls: &CallGraph,
    loops: &Loops,
    uniformity: &Uniformity,
) -> Vec<Gradient> {
    let mut found = Vec::new();
    let mut looped: Option<Vec<Option<StmtId>>> = None;
    for i in 0..program.tree.exprs.len() as u32 {
        let call = ExprId(i);
        let function = program.builtin_called(call);
        let Some(function) = function.filter(|f| f.kind().takes_derivatives()) else {
            continue;
        };
        let Some(stmt) = structure.stmt_of(call) else {
            continue;
        };
        if !uniformity.varies(Varying::Stmt(stmt)) || !is_different(program, uniformity, call) {
            continue;
        }
        let ends = |s: &StmtId| ends_apart(program, loops, uniformity, *s);
        let around = structure.outwards(stmt).find(ends).or_else(|| {
            let from = looped
                .get_or_insert_with(|| called_from(program, structure, calls, loops, uniformity));
            let function = structure.function_of(stmt)?;
            from.get(function.0 as usize).copied().flatten()
        });
        found.push(Gradient {
            call,
            function,
            parted: around.map_or(Parted::Branch(stmt), Parted::Loop),
        });
    }
    found
}

/// Whether what a call compares differs at all: the same place everywhere has no slope.
fn is_different(program: &Program, uniformity: &Uniformity, call: ExprId) -> bool {
    let ExprKind::Call(_, args) = program.tree.expr(call).kind else {
        return false;
    };
    let args = program.tree.args(args);
    // A sampler is never different, so what is left is the place.
    args.iter().any(|a| uniformity.varies(Varying::Expr(*a)))
}

/// Whether a statement is a loop that some pixels leave before others.
fn ends_apart(program: &Program, loops: &Loops, uniformity: &Uniformity, s: StmtId) -> bool {
    let body = match program.tree.stmt(s).kind {
        StmtKind::For { body, .. } | StmtKind::While { body, .. } | StmtKind::Do { body, .. } => {
            body
        }
        _ => return false,
    };
    let differs = |w| uniformity.varies(w);
    // A loop that only some pixels reach is not yet one that they leave apart.
    let parts = differs(Varying::Stmt(body)) && !differs(Varying::Stmt(s));
    parts || (differs(Varying::Stmt(s)) && loops.get(s).is_some_and(|l| l.ends_early))
}

/// By function: a loop that pixels leave apart from which it is called, directly or not.
fn called_from(
    program: &Program,
    structure: &Structure,
    calls: &CallGraph,
    loops: &Loops,
    uniformity: &Uniformity,
) -> Vec<Option<StmtId>> {
    let mut from: Vec<Option<StmtId>> = vec![None; program.functions.len()];
    let mut apart: Vec<Option<StmtId>> = vec![None; program.tree.stmts.len()];
    // Parents stand behind their children: this hands the loop down.
    for i in (0..program.tree.stmts.len() as u32).rev() {
        let id = StmtId(i);
        let own = Some(id).filter(|s| ends_apart(program, loops, uniformity, *s));
        let outer = structure.outer(id);
        let outer = outer.and_then(|o| apart.get(o.0 as usize).copied().flatten());
        if let Some(slot) = apart.get_mut(i as usize) {
            *slot = own.or(outer);
        }
    }
    let order: Vec<FunctionRef> = calls.bottom_up();
    for &caller in order.iter().rev() {
        let inherited = from.get(caller.0 as usize).copied().flatten();
        for call in calls.calls_by(caller) {
            let stmt = structure.stmt_of(call.expr);
            let own = stmt.and_then(|s| apart.get(s.0 as usize).copied().flatten());
            if let Some(slot @ None) = from.get_mut(call.callee.0 as usize) {
                *slot = own.or(inherited);
            }
        }
    }
    from
}
