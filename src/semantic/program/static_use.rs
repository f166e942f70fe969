//! Live code: what remains when the browser has removed functions that `main` does not reach,
//! statements and locals with unused values, and branches that never run.

use crate::CallGraph;
use crate::{FunctionRef, Program, Resolution, Value};
use shaderlint_syntax::ast::*;

/// By variable: whether any code refers to it, and whether live code does.
pub fn named(program: &Program) -> Vec<(bool, bool)> {
    let tree = &program.tree;
    let names = || {
        let all = program.exprs.iter().zip(&tree.exprs);
        all.filter_map(|(info, expr)| match (info.resolution, expr.kind) {
            (Resolution::Variable(id), ExprKind::Name(_)) => {
                Some((id.0 as usize, expr.extent.first))
            }
            _ => None,
        })
    };
    let mut named = vec![(false, false); program.variables.len()];
    for (id, _) in names() {
        if let Some(slot) = named.get_mut(id) {
            slot.0 = true;
        }
    }
    let live = Live::of(program, &named);
    for (id, token) in names() {
        if let Some(slot) = named.get_mut(id) {
            slot.1 |= live.holds(token);
        }
    }
    named
}

/// Ranges of live code.
struct Live {
    /// Reachable functions, in source order.
    running: Vec<Extent>,
    /// Removed code, in source order and without overlaps.
    dropped: Vec<Extent>,
}

impl Live {
    fn of(program: &Program, named: &[(bool, bool)]) -> Live {
        let mut dropped = dropped(program, named);
        dropped.sort_by_key(|e| (e.first, std::cmp::Reverse(e.last)));
        let mut end = None;
        dropped.retain(|e| {
            let is_new = end.is_none_or(|end| e.last > end);
            end = end.max(Some(e.last));
            is_new
        });
        Live {
            running: running(program),
            dropped,
        }
    }

    fn holds(&self, token: TokenId) -> bool {
        let inside = |all: &[Extent]| {
            let before = all.partition_point(|e| e.first <= token);
            let around = before.checked_sub(1).and_then(|b| all.get(b));
            around.is_some_and(|e| token <= e.last)
        };
        inside(&self.running) && !inside(&self.dropped)
    }
}

/// The functions reachable from `main`.
fn running(program: &Program) -> Vec<Extent> {
    let is_main = |f: &crate::Function| program.names.text(f.name) == "main" && f.params.is_empty();
    let Some(main) = program.functions.iter().position(is_main) else {
        return Vec::new();
    };
    let reached = CallGraph::of(program).reached_from(FunctionRef(main as u32));
    let functions = program.functions.iter().zip(&reached);
    let bodies = functions.filter(|(_, is_reached)| **is_reached);
    let bodies = bodies.filter_map(|(f, _)| program.tree.function(f.definition?));
    let mut running: Vec<Extent> = bodies.map(|f| f.extent).collect();
    running.sort_by_key(|e| e.first);
    running
}

/// Code without effect.
fn dropped(program: &Program, named: &[(bool, bool)]) -> Vec<Extent> {
    let tree = &program.tree;
    let mut dropped = Vec::new();
    // The value of a condition is used.
    let conditions = tree.stmts.iter().filter_map(|stmt| match stmt.kind {
        StmtKind::For { condition, .. } => condition,
        StmtKind::While { condition, .. } => Some(condition),
        _ => None,
    });
    let conditions: Vec<Extent> = conditions.map(|id| tree.stmt(id).extent).collect();
    for stmt in &tree.stmts {
        match stmt.kind {
            StmtKind::Expr(e) if !acts(program, e) && !conditions.contains(&stmt.extent) => {
                dropped.push(stmt.extent);
            }
            StmtKind::If {
                condition,
                then,
                otherwise,
            } => match program.scalar(condition) {
                Some(Value::Bool(true)) => {
                    dropped.extend(otherwise.map(|o| tree.stmt(o).extent));
                }
                Some(Value::Bool(false)) => dropped.push(tree.stmt(then).extent),
                _ => {}
            },
            _ => {}
        }
    }
    for expr in &tree.exprs {
        if let ExprKind::Comma(left, _) = expr.kind
            && !acts(program, left)
        {
            dropped.push(tree.expr(left).extent);
        }
    }
    for (declarator, variable) in tree.declarator_lists.iter().zip(&program.declared) {
        let is_unused = variable.is_some_and(|v| {
            let is_named = named.get(v.0 as usize).is_some_and(|n| n.0);
            let is_local = program.variable(v).is_some_and(|v| v.function.is_some());
            is_local && !is_named
        });
        if let Some(init) = declarator.init.filter(|i| is_unused && !acts(program, *i)) {
            dropped.push(tree.expr(init).extent);
        }
    }
    dropped
}

/// Whether an expression may have side effects; conservative, so that everything reported as
/// removed is.
fn acts(program: &Program, expr: ExprId) -> bool {
    let extent = program.tree.expr(expr).extent;
    // Operands are stored before the expression.
    let before = program.tree.exprs.get(..=expr.0 as usize).unwrap_or(&[]);
    let parts = before.iter().rev();
    let parts = parts.take_while(|e| extent.first <= e.extent.first);
    parts.into_iter().any(|e| match e.kind {
        ExprKind::Assign(..) | ExprKind::Postfix(..) | ExprKind::Call(..) => true,
        ExprKind::Unary(op, _) => op.assigns(),
        _ => false,
    })
}
