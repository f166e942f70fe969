//! Comparisons of literals, and of a `uint` with zero, that always give the same result.

use shaderlint_lint::prelude::*;

rule! { constant_condition, Tidy, Warning, Recommended, Binary(check) }

fn check(cx: &mut Context, e: &BinaryExpr) {
    let program = cx.program;
    if !e.op.compares() {
        return;
    }
    let extent = program.tree.expr(e.id).extent;
    if let Some(answer) = literal_answer(cx, e).or_else(|| sign_answer(cx, e))
        && program.is_direct(extent)
    {
        let finding = cx.report_expr(e.id, format!("this comparison is always {answer}"));
        if matches!(
            e.op,
            BinaryOp::Less | BinaryOp::GreaterEqual | BinaryOp::Greater | BinaryOp::LessEqual
        ) && program.ty(e.left).scalar_kind() == Some(Scalar::Uint)
        {
            finding.note("a `uint` is never negative");
        }
    }
}

/// The result if both sides are literals. A name may be a switch that the author sets.
fn literal_answer(cx: &Context, e: &BinaryExpr) -> Option<bool> {
    let program = cx.program;
    let tree = &program.tree;
    let literal = |id| match tree.expr(tree.unparen(id)).kind {
        ExprKind::Bool(value) => Some(value),
        _ => None,
    };
    // A literal `true` or `false` switches something on or off.
    let is_switch = literal(e.left).or(literal(e.right)).is_some();
    if is_switch || !e.op.compares() || has_name(cx, e.id) {
        return None;
    }
    match program.scalar(e.id)? {
        Value::Bool(value) => Some(value),
        _ => None,
    }
}

/// Whether an expression contains a name, or is too large to search: each comparison of a long
/// chain contains all those before it.
fn has_name(cx: &Context, id: ExprId) -> bool {
    const MAX_LOOK: usize = 100;
    let tree = &cx.program.tree;
    let mut todo = vec![id];
    for _ in 0..MAX_LOOK {
        let Some(next) = todo.pop() else {
            return false;
        };
        let expr = tree.expr(next);
        if let ExprKind::Name(_) = expr.kind {
            return true;
        }
        each_operand(tree, expr, |child| todo.push(child));
    }
    true
}

/// The result if a value that is never negative is compared with zero.
fn sign_answer(cx: &Context, e: &BinaryExpr) -> Option<bool> {
    let program = cx.program;
    let is_zero = |id| program.scalar(id).is_some_and(|v| v.as_float() == 0.0);
    let is_uint = |id| program.ty(id).scalar_kind() == Some(Scalar::Uint);
    match e.op {
        BinaryOp::Less if is_uint(e.left) && is_zero(e.right) => Some(false),
        BinaryOp::GreaterEqual if is_uint(e.left) && is_zero(e.right) => Some(true),
        BinaryOp::Greater if is_uint(e.right) && is_zero(e.left) => Some(false),
        BinaryOp::LessEqual if is_uint(e.right) && is_zero(e.left) => Some(true),
        _ => None,
    }
}
