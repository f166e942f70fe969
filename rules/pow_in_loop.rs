//! `pow` with a small integer exponent in a loop.

use shaderlint_lint::prelude::*;

rule! { pow_in_loop, Budget, Info, Performance, Builtin(check) }

/// Maximum exponent that a few multiplications can replace.
const MAX_EXPONENT: f32 = 8.0;
/// An exponent that compilers replace by multiplications, as they do with 2.
const MULTIPLIED: f32 = 4.0;

fn check(cx: &mut Context, call: &Builtin) {
    let (BuiltinId::Pow, &[base, exponent]) = (call.function, call.args) else {
        return;
    };
    let program = cx.program;
    // A named exponent is meant to be changed.
    let is_literal = matches!(program.tree.expr(exponent).kind, ExprKind::Float(_));
    let Some(Value::Float(power)) = program.scalar(exponent).filter(|_| is_literal) else {
        return;
    };
    let is_integer = power.fract() == 0.0 && (3.0..=MAX_EXPONENT).contains(&power);
    if !is_integer
        || power == MULTIPLIED
        || program.expr(call.id).is_const
        || !program.ty(base).is_scalar()
    {
        return;
    }
    let structure = cx.facts.structure();
    let Some(stmt) = structure.stmt_of(call.id) else {
        return;
    };
    let mut around = structure
        .outwards(stmt)
        .filter_map(|s| cx.facts.loops().get(s));
    let Some(head) = around
        .find(|l| l.bound.iterations() != Some(1))
        .map(|l| l.stmt)
    else {
        return;
    };
    // A base that may be negative is reported by `pow-negative-base`.
    if cx.facts.range(base).any(|r| r.reaches_below(0.0)) {
        return;
    }
    let text = program.expr_text(base).to_string();
    let is_name = matches!(program.tree.expr(base).kind, ExprKind::Name(_));
    let fix = (is_name && power == 3.0 && cx.is_direct(call.id)).then(|| {
        let factors = vec![text.as_str(); power as usize];
        let product = cx.in_place_of(call.id, factors.join(" * "));
        Fix::suggested_replacement(program.expr_span(call.id), product)
    });
    let place = program.span(Extent::token(program.tree.stmt(head).extent.first));
    let most = if power > 4.0 {
        "three or four multiplications"
    } else {
        "two multiplications"
    };
    cx.report_expr(
        call.id,
        format!("`pow` with constant exponent {power} in a loop"),
    )
    .label(place, "in this loop")
    .note(format!(
        "`pow` computes a logarithm and an exponential and is inexact; {most} give the same result"
    ))
    .fix(fix);
}
