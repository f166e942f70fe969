//! Indices outside their array, vector or matrix.

use shaderlint_lint::prelude::*;

rule! { index_range, Numeric, Warning, Recommended, Expr(&[Shape::Index], check) }

fn check(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    let ExprKind::Index(object, index) = program.tree.expr(id).kind else {
        return;
    };
    let ty = program.ty(object);
    let count = match (ty.is_array(), ty.numeric()) {
        (true, _) if ty.array == Type::UNSIZED => return,
        (true, _) => ty.array,
        (false, Some((_, 1, rows))) => rows as u32,
        (false, Some((_, columns, _))) => columns as u32,
        _ => return,
    };
    let last = count as f64 - 1.0;
    let Some(range) = cx.facts.range(index).next() else {
        return;
    };
    if !range.reaches_below(0.0) && !range.reaches_above(last) {
        return;
    }
    let is = range.may_or_is(|r| r.is_below(0.0) || r.is_above(last));
    let (known, what) = (range.of_integer(), program.type_name(ty));
    let side = match range.reaches_below(0.0) {
        true => Side::Low,
        false => Side::High,
    };
    let message = format!("the index {is} outside 0..={last}: its value is {known}");
    cx.report_range(index, (&range, side), message)
        .note(format!(
            "`{what}` has {count} elements; the result of an access outside them is undefined"
        ));
    cx.confirm_by_sampling(id, &[FaultKind::OutOfRange]);
}
