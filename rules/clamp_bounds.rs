//! `clamp` with crossed bounds or misplaced arguments.

use shaderlint_lint::prelude::*;

rule! { clamp_bounds, Numeric, Warning, Recommended, Builtin(check) }

fn check(cx: &mut Context, call: &Builtin) {
    let (BuiltinId::Clamp, &[x, low, high]) = (call.function, call.args) else {
        return;
    };
    let program = cx.program;
    let is_known = |e| !program.values(e).is_empty();
    let mut bounds = cx.facts.range(low).zip(cx.facts.range(high));
    let is_crossed = bounds.any(|(a, b)| a.lo.value > b.hi.value);
    let is_moved = is_known(x) && is_known(low) && !is_known(high);
    if !is_crossed && !is_moved {
        return;
    }
    let text = |e| program.expr_text(e).to_string();
    let (first, second, third) = (text(x), text(low), text(high));
    let (message, instead) = if is_moved {
        let message = "arguments of `clamp` appear to be in the wrong order";
        (message, format!("clamp({third}, {first}, {second})"))
    } else {
        let message = "the lower bound of `clamp` is greater than its upper bound";
        (message, format!("clamp({first}, {third}, {second})"))
    };
    let fix = cx.suggest(call.id, instead.as_str());
    cx.report_expr(call.id, message)
        .note(
            "the order is `clamp(x, minVal, maxVal)`; \
            the result is undefined if `minVal > maxVal` (section 8.3)",
        )
        .fix(fix);
}
