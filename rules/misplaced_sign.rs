//! `x =- 1.0` where `x -= 1.0` is meant.

use shaderlint_lint::prelude::*;

rule! { misplaced_sign, Tidy, Warning, Recommended, Expr(&[Shape::Assign], check) }

fn check(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    let tree = &program.tree;
    let ExprKind::Assign(None, target, value) = tree.expr(id).kind else {
        return;
    };
    let Some(op) = leading_sign(tree, value) else {
        return;
    };
    // `x =- x` changes the sign.
    if let ExprKind::Unary(_, operand) = tree.expr(value).kind
        && program.expr_text(operand) == program.expr_text(target)
    {
        return;
    }
    let sign = tree.expr(value).extent.first;
    let [before, equal, sign, after] = [
        tree.expr(target).extent.last,
        sign.saturating_sub(1),
        sign,
        sign + 1,
    ]
    .map(|t| program.token(t).filter(|t| t.is_direct()).map(|t| t.span));
    let (Some(before), Some(equal), Some(sign), Some(after)) = (before, equal, sign, after) else {
        return;
    };
    // In `x =-1.0` the sign belongs to the number; `=- 1.0` separates it from its operand. A unary
    // plus does nothing, with or without a space.
    let is_apart = before.end < equal.start && sign.end < after.start;
    if equal.end != sign.start || !(is_apart || op == UnaryOp::Plus) {
        return;
    }
    let symbol = op.symbol();
    let operator = Span::new(equal.start, sign.end);
    let fix = Fix::suggestion(
        format!("did you mean `{symbol}=`?"),
        vec![Edit::replace(operator, format!("{symbol}="))],
    );
    let text = program.expr_text(target);
    let message = match op {
        UnaryOp::Plus => format!("`=+` assigns to `{text}` instead of adding to it"),
        _ => format!("`=-` assigns to `{text}` instead of subtracting from it"),
    };
    cx.report_span(operator, message).fix(fix);
}

/// The unary sign at the start of an expression.
fn leading_sign(tree: &Tree, mut expr: ExprId) -> Option<UnaryOp> {
    loop {
        match tree.expr(expr).kind {
            ExprKind::Unary(op @ (UnaryOp::Plus | UnaryOp::Minus), _) => return Some(op),
            ExprKind::Binary(_, left, _) | ExprKind::Ternary(left, ..) => expr = left,
            _ => return None,
        }
    }
}
