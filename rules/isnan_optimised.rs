//! `isnan` and `isinf`, which compilers may optimise away.

use shaderlint_lint::prelude::*;

rule! { isnan_optimised, Portability, Info, Strict, Builtin(check) }

fn check(cx: &mut Context, call: &Builtin) {
    if !matches!(call.function, BuiltinId::IsNan | BuiltinId::IsInf) {
        return;
    }
    let name = call.function.name();
    let finding = cx
        .report_expr(call.id, format!("the compiler may optimise `{name}` away"))
        .note("it may assume that such values never occur (section 4.5.1), and some compilers do");
    finding.help(match call.function {
        BuiltinId::IsNan => {
            "prevent the NaN instead: guard the division, square root or power that produces it"
        }
        _ => "compare with a large number: `abs(x) > 1e30`",
    });
}
