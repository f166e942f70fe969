//! `smoothstep` with reversed or equal edges.

use shaderlint_lint::prelude::*;

rule! { smoothstep_edges, Numeric, Info, Strict, Builtin(check) }

fn check(cx: &mut Context, call: &Builtin) {
    let (BuiltinId::Smoothstep, &[low, high, x]) = (call.function, call.args) else {
        return;
    };
    // A constant value and a varying edge: `swapped-arguments` reports it.
    let is_known = |e| !cx.program.values(e).is_empty();
    if is_known(x) && is_known(high) && !is_known(low) {
        return;
    }
    let edges = cx.facts.range(low).zip(cx.facts.range(high));
    let (mut is_wrong, mut is_equal) = (false, false);
    for (a, b) in edges {
        is_equal |= a.single().is_some() && a.single() == b.single();
        is_wrong |= a.lo.value > b.hi.value;
    }
    if !is_wrong && !is_equal {
        return;
    }
    let text = |e| cx.program.expr_text(e).to_string();
    let (a, b, of) = (text(low), text(high), text(x));
    if is_equal {
        cx.report_expr(call.id, "edges of `smoothstep` are equal")
            .note("the result is undefined if `edge0 >= edge1` (section 8.3); equal edges divide by zero")
            .help(format!("use `step({a}, {of})`, or move the edges apart"));
        return;
    }
    let instead = cx.in_place_of(call.id, format!("1.0 - smoothstep({b}, {a}, {of})"));
    let fix = cx.suggest(call.id, instead.as_str());
    cx.report_expr(
        call.id,
        "first edge of `smoothstep` is greater than the second",
    )
    .note("the result is undefined if `edge0 >= edge1` (section 8.3); most drivers draw a falling step")
    .fix(fix);
}
