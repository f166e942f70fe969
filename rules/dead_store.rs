//! Values that are overwritten or dropped before they are read.

use shaderlint_lint::prelude::*;

rule! {
    dead_store, Tidy, Info, Recommended,
    Expr(&[Shape::Assign], check_assignment), Declaration(check_declaration)
}

fn check_assignment(cx: &mut Context, id: ExprId) {
    let tree = &cx.program.tree;
    let ExprKind::Assign(op, target, value) = tree.expr(id).kind else {
        return;
    };
    let is_statement = cx.facts.structure().stmt_of(id);
    let is_statement = is_statement.is_some_and(|s| tree.stmt(s).kind == StmtKind::Expr(id));
    let place = match tree.expr(target).kind {
        ExprKind::Member(inner, _) => inner,
        _ => target,
    };
    let Some(variable) = cx.program.variable_of(place) else {
        return;
    };
    if is_statement && is_own(cx, variable) && cx.is_direct(id) {
        // `a += b` stores the sum.
        let stored = if op.is_some() { id } else { value };
        check_value(cx, variable, stored, id);
    }
}

fn check_declaration(cx: &mut Context, declared: &DeclaredVariable) {
    let Some(init) = declared.declarator().and_then(|d| d.init) else {
        return;
    };
    // An initial value that is a constant or a copy is a convention and costs nothing.
    let is_plain = cx.program.expr(init).is_const || !is_work(cx, init);
    if declared.stmt.is_some() && !is_plain && is_own(cx, declared.variable) && cx.is_direct(init) {
        check_value(cx, declared.variable, init, init);
    }
}

/// Whether an expression computes something, and is not a copy of a variable or of parts of one.
fn is_work(cx: &Context, expr: ExprId) -> bool {
    let tree = &cx.program.tree;
    let mut at = tree.unparen(expr);
    while let ExprKind::Member(inner, _) | ExprKind::Index(inner, _) = tree.expr(at).kind {
        at = tree.unparen(inner);
    }
    !matches!(tree.expr(at).kind, ExprKind::Name(_))
}

/// Whether a variable is local to its function, is a scalar or vector, and is read at all:
/// another rule reports variables that are never read.
fn is_own(cx: &Context, id: VariableId) -> bool {
    let program = cx.program;
    let Some(variable) = program.variable(id) else {
        return false;
    };
    let is_inside = match variable.storage {
        Storage::Local => true,
        Storage::Param(direction) => !direction.writes(),
        _ => false,
    };
    let name = program.names.text(variable.name);
    is_inside
        && (variable.ty.is_scalar() || variable.ty.is_vector())
        && !name.starts_with('_')
        && cx.facts.writes().is_read(id)
        && !cx.facts.inactive_words().has(name)
}

fn check_value(cx: &mut Context, variable: VariableId, value: ExprId, assignment: ExprId) {
    let program = cx.program;
    let facts = cx.facts;
    let lost = facts.module().op_of(value);
    if !lost.is_some_and(|value| facts.liveness().is_lost(value)) {
        return;
    }
    let name = program.variable(variable).map(|v| v.name);
    let name = name.map_or("", |n| program.names.text(n));
    let extent = program.tree.expr(assignment).extent;
    let writes = facts.writes().to(variable);
    let next = writes.partition_point(|w| program.tree.expr(*w).extent.first <= extent.last);
    let next = writes.get(next).map(|write| program.expr_span(*write));
    // The last update of a running value is redundant, but harmless; so is a constant that is
    // overwritten later.
    let is_step = facts
        .mentions()
        .is_in(program, variable, program.tree.expr(value).extent);
    let is_idle = match next {
        Some(_) => program.expr(value).is_const,
        None => is_step,
    };
    if is_idle {
        return;
    }
    let message = format!("value assigned to `{name}` is never read");
    cx.report_expr(assignment, message)
        .label(next, "next write");
}
