//! Gamma correction of a colour that is already corrected.

use shaderlint_lint::prelude::*;

rule! { double_gamma, Look, Warning, Recommended, Builtin(check) }

fn check(cx: &mut Context, call: &Builtin) {
    let (BuiltinId::Pow, &[base, _]) = (call.function, call.args) else {
        return;
    };
    let program = cx.program;
    let module = cx.facts.module();
    let ops = module.op_of(call.id).zip(module.op_of(base));
    let Some((op, base)) = ops.filter(|_| program.ty(call.id).components() >= 3) else {
        return;
    };
    if !is_gamma(cx, op) {
        return;
    }
    let mut before = None;
    cx.facts.trace(base, 0, |start| {
        let Start::Made(made, _) = start else {
            return false;
        };
        if made != op && is_gamma(cx, made) {
            before = before.or(Some(made));
        }
        use BuiltinId::{Clamp, Max, Min};
        matches!(
            module.op(made).kind,
            OpKind::Builtin(Clamp | Max | Min, _) | OpKind::Binary(Binary::Multiply, ..)
        )
    });
    let Some(before) = before else { return };
    let Some(extent) = module.provenance(before).extent(&program.tree) else {
        return;
    };
    let at = program.span(extent);
    cx.report_expr(call.id, "gamma correction is applied twice to this colour")
        .label(at, "already gamma-corrected here")
        .note("a second correction makes dark colours gray and reduces their saturation")
        .help("remove one correction; keep the one after all lighting calculations");
}

/// Whether this is `pow(c, 1.0 / 2.2)` or a similar correction.
fn is_gamma(cx: &Context, op: OpId) -> bool {
    let module = cx.facts.module();
    let OpKind::Builtin(BuiltinId::Pow, operands) = module.op(op).kind else {
        return false;
    };
    let &[base, exponent] = module.operands(operands) else {
        return false;
    };
    let value = cx.facts.ranges().lane(exponent, 0).single();
    // One over 2.6 to one over 1.8.
    module.ty(base).components() >= 3 && value.is_some_and(|v| (0.38..=0.56).contains(&v))
}
