//! Logarithms of zero and of negative numbers.

use shaderlint_lint::prelude::*;

rule! { log_nonpositive, Numeric, Warning, Recommended, Builtin(check) }

fn check(cx: &mut Context, call: &Builtin) {
    let (BuiltinId::Log | BuiltinId::Log2, &[of]) = (call.function, call.args) else {
        return;
    };
    let ranges: Vec<Interval> = cx.facts.range(of).collect();
    let negative = ranges.iter().find(|r| r.strays_below(0.0));
    let Some(range) = negative.or(ranges.iter().find(|r| r.holds(0.0))) else {
        return;
    };
    let what = if negative.is_some() {
        "negative"
    } else {
        "zero"
    };
    let is = range.may_or_is(|r| r.is_below(0.0) || r.single() == Some(0.0));
    let text = cx.program.expr_text(of).to_string();
    cx.report_range(
        of,
        (range, Side::Low),
        format!(
            "the argument of `{}` {is} {what}: {range}",
            call.function.name()
        ),
    )
    .note("the logarithm of zero or less is undefined (section 8.2): infinity or NaN")
    .help(format!("use `max({text}, 1e-6)`"));
    cx.confirm_by_sampling(call.id, &[FaultKind::Undefined]);
}
