//! Division by zero.

use shaderlint_lint::prelude::*;

rule! {
    zero_division, Numeric, Warning, Recommended,
    Expr(&[Shape::Binary, Shape::Assign, Shape::Call], check)
}

fn check(cx: &mut Context, id: ExprId) {
    let (op, divisor) = match cx.program.tree.expr(id).kind {
        // `1.0 / 0.0` is the usual way to write infinity.
        ExprKind::Binary(BinaryOp::Div, dividend, divisor)
            if is_infinity(cx, dividend, divisor) =>
        {
            return;
        }
        ExprKind::Binary(op, _, divisor) | ExprKind::Assign(Some(op), _, divisor) => (op, divisor),
        ExprKind::Call(_, args) if cx.program.builtin_called(id) == Some(BuiltinId::Mod) => {
            match cx.program.tree.args(args) {
                &[_, divisor] => (BinaryOp::Rem, divisor),
                _ => return,
            }
        }
        _ => return,
    };
    if !matches!(op, BinaryOp::Div | BinaryOp::Rem) {
        return;
    }
    let Some(range) = cx.facts.range(divisor).find(|r| r.holds(0.0)) else {
        return;
    };
    let is_float = cx.program.ty(divisor).scalar_kind() == Some(Scalar::Float);
    let is_zero = range.single() == Some(0.0);
    if is_float && !is_zero && is_bounded(cx, id) {
        return;
    }
    let known = match is_float {
        true => range.to_string(),
        false => range.of_integer(),
    };
    let message = match is_zero {
        true => "division by zero".to_string(),
        false => format!("divisor may be zero: {known}"),
    };
    let side = if range.lo.value == 0.0 {
        Side::Low
    } else {
        Side::High
    };
    let finding = cx.report_range(divisor, (&range, side), message);
    let finding = finding.note(match is_float {
        true => {
            "the result is undefined (section 4.5.1): on most GPUs infinity, or NaN for `0.0 / 0.0`"
        }
        false => "integer division by zero is undefined",
    });
    if !is_zero && range.lo.value >= 0.0 {
        finding.help("start the counter at 1, skip this case, or use `max(x, smallest)` with the smallest meaningful divisor");
    }
    cx.confirm_by_sampling(id, &[FaultKind::DivisionByZero]);
}

/// Whether both sides of a division of floats are constants.
fn is_infinity(cx: &Context, dividend: ExprId, divisor: ExprId) -> bool {
    let is_constant = |e| cx.program.expr(e).is_const;
    let is_float = cx.program.ty(divisor).scalar_kind() == Some(Scalar::Float);
    is_float && is_constant(dividend) && is_constant(divisor)
}

/// Whether `min` or `clamp` bounds the quotient, so that infinity acts as a large number.
fn is_bounded(cx: &Context, quotient: ExprId) -> bool {
    let mut at = quotient;
    while let Some(parent) = cx.facts.structure().parent(at) {
        match cx.program.tree.expr(parent).kind {
            ExprKind::Paren(_) | ExprKind::Binary(BinaryOp::Mul, ..) => at = parent,
            ExprKind::Call(_, args) => {
                let first = cx.program.tree.args(args).first();
                return match cx.program.builtin_called(parent) {
                    Some(BuiltinId::Min) => true,
                    Some(BuiltinId::Clamp) => first == Some(&at),
                    _ => false,
                };
            }
            _ => return false,
        }
    }
    false
}
