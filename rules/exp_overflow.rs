//! Exponential functions of numbers too large for them.

use shaderlint_diagnostic::Severity;
use shaderlint_lint::{Builtin, Check, Context, Group, Rule};
use shaderlint_semantic::BuiltinId;

pub static RULE: Rule = Rule {
    name: "exp-overflow",
    group: Group::Numeric,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("exp_overflow.md"),
    checks: &[Check::Builtin(check)],
};

fn check(cx: &mut Context, call: &Builtin) {
    let &[of] = call.args else { return };
    let limit = match call.function {
        BuiltinId::Exp => 88.72,
        BuiltinId::Exp2 => 128.0,
        BuiltinId::Sinh | BuiltinId::Cosh => 89.41,
        _ => return,
    };
    // A constant has a rule of its own.
    if !cx.program.values(of).is_empty() {
        return;
    }
    let mut ranges = cx.facts.range(of);
    let Some(range) = ranges.find(|r| r.hi.value.is_finite() && r.reaches_above(limit)) else {
        return;
    };
    let name = call.function.name();
    cx.report_expr(of, format!("`{name}` overflows here: its argument is {range}"))
        .note(format!(
            "above {limit} the result is greater than any `float`: an infinity, and a NaN in `x / (1.0 + x)`"
        ))
        .help(format!("bound the argument with `min(..., {:.1})`", limit - 8.72));
}
