//! `isnan` and `isinf`, which compilers may leave out.

use shaderlint_diagnostic::Severity;
use shaderlint_lint::{Builtin, Check, Context, Group, Rule};
use shaderlint_semantic::BuiltinId;

pub static RULE: Rule = Rule {
    name: "isnan-optimised",
    group: Group::Portability,
    severity: Severity::Info,
    default: true,
    options: &[],
    page: include_str!("isnan_optimised.md"),
    checks: &[Check::Builtin(check)],
};

fn check(cx: &mut Context, call: &Builtin) {
    if !matches!(call.function, BuiltinId::IsNan | BuiltinId::IsInf) {
        return;
    }
    let name = call.function.name();
    let finding = cx
        .report_expr(call.id, format!("the compiler may leave `{name}` out"))
        .note("it may take it that such numbers never come up, and on some machines it does");
    finding.help(match call.function {
        BuiltinId::IsNan => {
            "keep the number from becoming one: guard the division, root or power before"
        }
        _ => "compare with a large number: `abs(x) > 1e30`",
    });
}
