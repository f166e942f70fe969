//! Square roots of negative numbers.

use shaderlint_lint::prelude::*;

rule! { sqrt_negative, Numeric, Warning, Recommended, Builtin(check) }

fn check(cx: &mut Context, call: &Builtin) {
    let (BuiltinId::Sqrt | BuiltinId::InverseSqrt, &[of]) = (call.function, call.args) else {
        return;
    };
    let is_inverse = call.function == BuiltinId::InverseSqrt;
    let name = call.function.name();
    let ranges: Vec<Interval> = cx.facts.range(of).collect();
    if let Some(range) = ranges.iter().find(|r| r.strays_below(0.0)) {
        let least = if is_inverse { "1e-6" } else { "0.0" };
        let span = cx.program.expr_span(of);
        let fix = cx.is_direct(of).then(|| {
            let edits = vec![
                Edit::insert(span.start, "max("),
                Edit::insert(span.end, format!(", {least})")),
            ];
            Fix::suggestion(format!("clamp it with `max(..., {least})`"), edits)
        });
        let is = range.may_or_is(|r| r.is_below(0.0));
        cx.report_range(
            of,
            (range, Side::Low),
            format!("argument of `{name}` {is} negative: {range}"),
        )
        .note(format!(
            "`{name}` of a negative number is undefined (section 8.2), and NaN on most GPUs"
        ))
        .fix(fix);
        cx.confirm_by_sampling(call.id, &[FaultKind::Undefined]);
    } else if is_inverse && let Some(range) = ranges.iter().find(|r| r.holds(0.0)) {
        let is = range.may_or_is(|r| r.single() == Some(0.0));
        cx.report_range(
            of,
            (range, Side::Low),
            format!("argument of `inversesqrt` {is} zero: {range}"),
        )
        .note("`inversesqrt(0.0)` is undefined (section 8.2)")
        .help("clamp it with `max(..., 1e-6)`");
        cx.confirm_by_sampling(call.id, &[FaultKind::Undefined]);
    }
}
