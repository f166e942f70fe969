//! `asin` and `acos` of arguments outside -1.0..1.0.

use shaderlint_lint::prelude::*;

rule! { inverse_trig_range, Numeric, Warning, Recommended, Builtin(check) }

fn check(cx: &mut Context, call: &Builtin) {
    let (BuiltinId::Asin | BuiltinId::Acos, &[of]) = (call.function, call.args) else {
        return;
    };
    let (least, most) = (-1.0, 1.0);
    let is_beyond = |r: &Interval| r.strays_below(least) || r.strays_above(most);
    let Some(range) = cx.facts.range(of).find(is_beyond) else {
        return;
    };
    let span = cx.program.expr_span(of);
    let fix = cx.is_direct(of).then(|| {
        let edits = vec![
            Edit::insert(span.start, "clamp("),
            Edit::insert(span.end, ", -1.0, 1.0)"),
        ];
        Fix::suggestion("limit it with `clamp(..., -1.0, 1.0)`", edits)
    });
    let is = range.may_or_is(|r| r.is_below(least) || r.is_above(most));
    let side = match range.strays_below(least) {
        true => Side::Low,
        false => Side::High,
    };
    cx.report_range(
        of,
        (&range, side),
        format!(
            "argument of `{}` {is} outside -1.0..=1.0: its value is {range}",
            call.function.name()
        ),
    )
    .note("the result is undefined for arguments below -1.0 or above 1.0 (section 8.1)")
    .fix(fix);
    cx.confirm_by_sampling(call.id, &[FaultKind::Undefined]);
}
