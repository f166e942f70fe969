//! `x = x`.

use crate::diagnostic::{Fix, Severity};
use crate::lint::{Check, Context, Group, Rule, remove_statement, same_code};
use crate::syntax::ast::*;

pub static RULE: Rule = Rule {
    name: "self-assignment",
    group: Group::Tidy,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("self_assignment.md"),
    check: Check::Expr(check),
};

fn check(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    let tree = &program.tree;
    let expr = tree.expr(id);
    let ExprKind::Assign(None, target, value) = expr.kind else {
        return;
    };
    let extents = [target, tree.unparen(value)].map(|e| tree.expr(e).extent);
    let [left, right] = extents;
    if !program.is_direct(expr.extent)
        || !same_code(program, left, right)
        || cx.facts.effects().has(target)
    {
        return;
    }
    let text = program.sources.text(program.span(left));
    let fix = removal(cx, id);
    cx.report(expr.extent, format!("`{text}` is assigned to itself"))
        .fix(fix);
}

fn removal(cx: &Context, id: ExprId) -> Option<Fix> {
    let tree = &cx.program.tree;
    let structure = cx.facts.structure();
    let stmt = structure.stmt_of(id)?;
    let outer = tree.stmt(structure.outer(stmt)?).kind;
    let is_all = tree.stmt(stmt).kind == StmtKind::Expr(id);
    if !is_all || !matches!(outer, StmtKind::Block(_)) {
        return None;
    }
    let edit = remove_statement(cx.program, tree.stmt(stmt).extent)?;
    Some(Fix::safe("take it out", vec![edit]))
}
