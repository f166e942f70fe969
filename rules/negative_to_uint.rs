//! Negative floats that are converted to unsigned integers.

use shaderlint_lint::prelude::*;

rule! { negative_to_uint, Numeric, Warning, Recommended, Expr(&[Shape::Construct], check) }

fn check(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    let ExprKind::Construct(ty, args) = program.tree.expr(id).kind else {
        return;
    };
    let made = program.ty(id);
    if made.scalar_kind() != Some(Scalar::Uint) {
        return;
    }
    for &arg in program.tree.args(args) {
        if program.ty(arg).scalar_kind() != Some(Scalar::Float) {
            continue;
        }
        // The conversion truncates, so -1..0 becomes 0; a negative constant is always reported.
        let is_bad = |r: &Interval| r.reaches_below(-1.0) || r.single().is_some_and(|v| v < 0.0);
        let bad = cx.facts.range(arg).find(is_bad);
        let Some(range) = bad else { continue };
        let is = range.may_or_is(|r| r.is_below(0.0));
        let integer_type = program.type_name(program.ty(arg).with_scalar(Scalar::Int));
        let is_direct = cx.is_direct(id) && program.tree.args(args).len() == 1;
        let fix = is_direct.then(|| {
            let span = program.expr_span(arg);
            let edits = vec![
                Edit::insert(span.start, format!("{integer_type}(")),
                Edit::insert(span.end, ")"),
            ];
            Fix::suggestion(format!("convert to `{integer_type}` first"), edits)
        });
        let name = program
            .sources
            .text(program.span(program.tree.ty(ty).extent))
            .to_string();
        cx.report_range(
            arg,
            (&range, Side::Low),
            format!("value converted to `{name}` {is} negative: {range}"),
        )
        .note(
            "converting a negative float to an unsigned type is undefined (section 5.4.1); \
            results differ between GPUs",
        )
        .fix(fix);
    }
}
