//! `x == true`, `c ? true : false`, `!!a`.

use shaderlint_lint::prelude::*;

/// Longest expression that a fix repeats, in bytes.
const MAX_LENGTH: usize = 200;

rule! {
    needless_bool, Tidy, Info, Strict,
    Binary(check_comparison), Expr(&[Shape::Ternary], check_ternary)
}

/// `x == true`
fn check_comparison(cx: &mut Context, e: &BinaryExpr) {
    let is_equal = match e.op {
        BinaryOp::Equal => true,
        BinaryOp::NotEqual => false,
        _ => return,
    };
    let (value, truth) = match (literal(cx, e.left), literal(cx, e.right)) {
        (None, Some(truth)) => (e.left, truth),
        (Some(truth), None) => (e.right, truth),
        _ => return,
    };
    let message = format!("redundant comparison with `{truth}`");
    report(cx, (e.id, message.as_str()), value, is_equal == truth);
}

/// `c ? true : false`
fn check_ternary(cx: &mut Context, id: ExprId) {
    let ExprKind::Ternary(condition, a, b) = cx.program.tree.expr(id).kind else {
        return;
    };
    if let (Some(a), Some(b)) = (literal(cx, a), literal(cx, b))
        && a != b
    {
        let message = "redundant `?:` between `true` and `false`";
        report(cx, (id, message), condition, a);
    }
}

fn literal(cx: &Context, id: ExprId) -> Option<bool> {
    let tree = &cx.program.tree;
    match tree.expr(tree.unparen(id)).kind {
        ExprKind::Bool(value) => Some(value),
        _ => None,
    }
}

/// Reports that `expression` can be replaced by `value`, or by its negation where `truth` is false.
fn report(cx: &mut Context, (expression, message): (ExprId, &str), value: ExprId, truth: bool) {
    let program = cx.program;
    let tree = &program.tree;
    let text = program.expr_text(value);
    if !cx.is_direct(expression) || text.len() > MAX_LENGTH {
        return;
    }
    let is_short = matches!(
        tree.expr(value).kind,
        ExprKind::Name(_) | ExprKind::Member(..) | ExprKind::Paren(_) | ExprKind::Call(..)
    );
    let code = match (truth, is_short) {
        (true, _) => text.to_string(),
        (false, true) => format!("!{text}"),
        (false, false) => format!("!({text})"),
    };
    let written = match tree.expr(value).kind {
        ExprKind::Binary(..) if truth => cx.in_place_of(expression, code.clone()),
        _ => code.clone(),
    };
    let edit = Edit::replace(program.expr_span(expression), written);
    cx.report_expr(expression, message)
        .fix(Fix::safe(format!("use `{code}`"), vec![edit]));
}
