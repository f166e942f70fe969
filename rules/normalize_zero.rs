//! `normalize` of a zero vector.

use shaderlint_lint::prelude::*;

rule! { normalize_zero, Numeric, Warning, Recommended, Builtin(check) }

fn check(cx: &mut Context, call: &Builtin) {
    let (BuiltinId::Normalize, &[of]) = (call.function, call.args) else {
        return;
    };
    let mut ranges = cx.facts.range(of).peekable();
    if ranges.peek().is_none() || !ranges.all(|r| r.single() == Some(0.0)) {
        return;
    }
    cx.report_expr(of, "`normalize` is called with a zero vector")
        .note(
            "`normalize` divides by the length, which is zero: the result is undefined, usually \
            NaN",
        );
}
