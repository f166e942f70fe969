//! Exponential functions of arguments that are too large.

use shaderlint_lint::prelude::*;

rule! { exp_overflow, Numeric, Warning, Recommended, Builtin(check) }

fn check(cx: &mut Context, call: &Builtin) {
    let &[of] = call.args else { return };
    let limit = match call.function {
        BuiltinId::Exp => 88.72,
        BuiltinId::Exp2 => 128.0,
        BuiltinId::Sinh | BuiltinId::Cosh => 89.41,
        _ => return,
    };
    // Another rule reports constants.
    if !cx.program.values(of).is_empty() {
        return;
    }
    let mut ranges = cx.facts.range(of);
    let Some(range) = ranges.find(|r| r.hi.value.is_finite() && r.reaches_above(limit)) else {
        return;
    };
    let name = call.function.name();
    cx.report_expr(
        of,
        format!("`{name}` overflows: its argument can be {range}"),
    )
    .note(format!(
        "above {limit} the result is infinite, and `x / (1.0 + x)` is NaN"
    ))
    .help(format!(
        "limit the argument with `min(..., {:.1})`",
        limit - 8.72
    ));
}
