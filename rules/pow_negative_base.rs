//! `pow` of a negative number.

use shaderlint_lint::prelude::*;

rule! { pow_negative_base, Numeric, Warning, Recommended, Builtin(check) }

fn check(cx: &mut Context, call: &Builtin) {
    let (BuiltinId::Pow, &[base, exponent]) = (call.function, call.args) else {
        return;
    };
    let bad = cx.facts.range(base).find(|r| r.strays_below(0.0));
    let Some(range) = bad else { return };
    let exponents = cx.program.values(exponent);
    let square = !exponents.is_empty() && exponents.iter().all(|e| *e == Value::Float(2.0));
    let text = cx.program.expr_text(base).to_string();
    let fix = (square && is_simple(cx, base) && cx.is_direct(call.id)).then(|| {
        let product = cx.in_place_of(call.id, format!("{text} * {text}"));
        Fix::suggested_replacement(cx.program.expr_span(call.id), product)
    });
    let help = match square {
        true => "multiply the base by itself, which is defined for all numbers".to_string(),
        false => format!("use `max({text}, 0.0)` or `abs({text})`"),
    };
    let is = range.may_or_is(|r| r.is_below(0.0));
    let message = format!("the base of `pow` {is} negative: {range}");
    cx.report_range(base, (&range, Side::Low), message)
        .note(
            "`pow` of a negative base is undefined for every exponent (section 8.2); many GPUs \
            return NaN",
        )
        .help(help)
        .fix(fix);
    cx.confirm_by_sampling(call.id, &[FaultKind::Undefined]);
}

/// Whether an expression is a name or a member of one, and so can be written twice.
fn is_simple(cx: &Context, expr: ExprId) -> bool {
    let tree = &cx.program.tree;
    match tree.expr(expr).kind {
        ExprKind::Name(_) => true,
        ExprKind::Member(object, _) => matches!(tree.expr(object).kind, ExprKind::Name(_)),
        _ => false,
    }
}
