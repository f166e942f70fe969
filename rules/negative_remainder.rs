//! `%` with negative operands.

use shaderlint_lint::prelude::*;

/// Limit of the number that the help adds, so that the sum does not overflow.
const MAX_ADDED: f64 = 1e6;

rule! {
    negative_remainder, Numeric, Warning, Recommended,
    Expr(&[Shape::Binary, Shape::Assign], check)
}

fn check(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    let (ExprKind::Binary(BinaryOp::Rem, left, right)
    | ExprKind::Assign(Some(BinaryOp::Rem), left, right)) = program.tree.expr(id).kind
    else {
        return;
    };
    if program.ty(left).scalar_kind() != Some(Scalar::Int) {
        return;
    }
    let bad = [left, right].into_iter().find_map(|side| {
        let range = cx.facts.range(side).find(|r| r.reaches_below(0.0))?;
        Some((side, range))
    });
    let Some((side, range)) = bad else { return };
    let is = range.may_or_is(|r| r.is_below(0.0));
    let (x, n) = (program.expr_text(left), program.expr_text(right));
    // A multiple of the divisor that makes every value positive.
    let divisor = cx.facts.range(right).find_map(|r| r.single());
    let divisor = divisor.filter(|n| *n > 0.0 && range.lo.value.is_finite());
    let multiple = divisor.map(|n| (-range.lo.value / n).ceil());
    let code = match (multiple, divisor) {
        (Some(1.0), _) => format!("({x} + {n}) % {n}"),
        (Some(multiple), Some(divisor)) if multiple * divisor < MAX_ADDED => {
            format!("({x} + {}) % {n}", multiple * divisor)
        }
        _ => format!("{x} - {n} * int(floor(float({x}) / float({n})))"),
    };
    let known = range.of_integer();
    let finding = cx
        .report_expr(side, format!("operand of `%` {is} negative: {known}"))
        .note(
            "`%` with a negative operand is undefined (section 5.9); most GPUs return a \
            negative result",
        );
    if side == left {
        finding.help(format!("keep the operand positive: `{code}`"));
    }
    cx.confirm_by_sampling(id, &[FaultKind::Undefined]);
}
