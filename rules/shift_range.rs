//! Shift amounts that are negative, or 32 and more.

use shaderlint_lint::prelude::*;

rule! { shift_range, Numeric, Warning, Recommended, Expr(&[Shape::Binary, Shape::Assign], check) }

fn check(cx: &mut Context, id: ExprId) {
    let (op, by) = match cx.program.tree.expr(id).kind {
        ExprKind::Binary(op, _, by) | ExprKind::Assign(Some(op), _, by) => (op, by),
        _ => return,
    };
    if !matches!(op, BinaryOp::ShiftLeft | BinaryOp::ShiftRight) {
        return;
    }
    let is_bad = |r: &Interval| r.reaches_below(0.0) || r.reaches_above(31.0);
    let Some(range) = cx.facts.range(by).find(is_bad) else {
        return;
    };
    let is = range.may_or_is(|r| r.is_below(0.0) || r.is_above(31.0));
    let known = range.of_integer();
    let side = match range.reaches_below(0.0) {
        true => Side::Low,
        false => Side::High,
    };
    cx.report_range(
        by,
        (&range, side),
        format!("shift amount {is} outside 0 to 31: {known}"),
    )
    .note(
        "integers have 32 bits; a shift by less than 0 or more than 31 is undefined (section 5.9)",
    )
    .help("mask the shift amount with `& 31`");
    cx.confirm_by_sampling(id, &[FaultKind::Undefined]);
}
