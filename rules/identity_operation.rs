//! `x * 1.0`, `x + 0.0`, `pow(x, 1.0)`.

use shaderlint_lint::prelude::*;

rule! { identity_operation, Tidy, Info, Strict, Binary(check_binary), Builtin(check_builtin) }

fn check_binary(cx: &mut Context, e: &BinaryExpr) {
    use BinaryOp::*;
    let (left, right) = (literal(cx, e.left), literal(cx, e.right));
    let kept = match (e.op, left, right) {
        (Mul, Some(1.0), None) | (Add, Some(0.0), None) => e.right,
        (Mul | Div, None, Some(1.0)) | (Add | Sub, None, Some(0.0)) => e.left,
        (Mul, Some(0.0), None) | (Mul, None, Some(0.0)) => {
            return report(cx, e.id, "this product is always zero".to_string());
        }
        _ => return,
    };
    // With a vector operand, a scalar becomes a vector.
    let is_same_type = cx.program.ty(kept) == cx.program.ty(e.id);
    if is_same_type {
        let text = cx.program.expr_text(kept);
        let message = format!("this expression is the same as `{text}`");
        report(cx, e.id, message);
    }
}

fn check_builtin(cx: &mut Context, call: &Builtin) {
    let kept = match (call.function, call.args) {
        (BuiltinId::Pow, &[base, power]) if literal(cx, power) == Some(1.0) => base,
        (BuiltinId::Mix, &[a, _, t]) if literal(cx, t) == Some(0.0) => a,
        (BuiltinId::Mix, &[_, b, t]) if literal(cx, t) == Some(1.0) => b,
        _ => return,
    };
    let text = cx.program.expr_text(kept);
    let message = format!("this expression is the same as `{text}`");
    report(cx, call.id, message);
}

fn report(cx: &mut Context, id: ExprId, message: String) {
    if cx.is_direct(id) && !cx.program.expr(id).is_const {
        cx.report_expr(id, message);
    }
}

/// The value of a literal; a named number may be a setting.
fn literal(cx: &Context, id: ExprId) -> Option<f32> {
    let tree = &cx.program.tree;
    match tree.expr(tree.unparen(id)).kind {
        ExprKind::Float(value) => Some(value),
        ExprKind::Int(value) => Some(value as f32),
        _ => None,
    }
}
