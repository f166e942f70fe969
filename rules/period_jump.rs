//! `mod` with a period that is close to, but not, a multiple of the period of `sin`.

use shaderlint_flow::{AngleUse, angle_uses, period};
use shaderlint_lint::prelude::*;
use std::f64::consts::TAU;

rule! { period_jump, Numeric, Warning, Recommended, Program(check) }

/// Smallest jump of the angle that is visible, in radians.
const VISIBLE: f64 = 0.02;
/// Largest jump of the angle that is a mistake in the period; larger ones are periods of something else.
const CLOSE: f64 = 0.13;
/// Most periods of the function in one period of `mod`: among longer ones, some are close by chance.
const MOST: f64 = 4.0;
/// What an angle is usually multiplied by.
const FACTORS: [f64; 5] = [0.5, 1.0, 2.0, 3.0, 4.0];
/// Most calls that are followed, since each takes a pass over the shader.
const MAX_CALLS: usize = 16;

fn check(cx: &mut Context) {
    for call in candidates(cx) {
        let Some(uses) = angle_uses(cx.facts.ranges(), call.op) else {
            continue;
        };
        let jumps = uses.into_iter().filter_map(|used| {
            let period = period(used.function)?;
            let (count, jump) = jump(call.every, used.factor, period)?;
            Some((used, count * period / used.factor.abs(), jump))
        });
        // A period of the slowest use is one of the others.
        if let Some(found) = jumps.max_by(|a, b| a.1.total_cmp(&b.1)) {
            report(cx, &call, found);
        }
    }
}

/// A call of `mod` with a constant period that its first argument leaves.
struct PeriodicCall {
    op: OpId,
    expr: ExprId,
    every: f64,
}

fn candidates(cx: &Context) -> Vec<PeriodicCall> {
    let module = cx.facts.module();
    let calls = (0..).map(OpId).zip(&module.ops).filter_map(|(op, found)| {
        let OpKind::Builtin(BuiltinId::Mod, list) = found.kind else {
            return None;
        };
        let (&[x, every], Provenance::Expr(expr)) = (module.operands(list), module.provenance(op))
        else {
            return None;
        };
        let [every] = module.constant(every) else {
            return None;
        };
        let every = f64::from(every.as_float());
        let is_likely = FACTORS
            .iter()
            .any(|factor| jump(every, *factor, TAU).is_some());
        let range = || cx.facts.ranges().lane(x, 0);
        let leaves = || range().lo.value < 0.0 || range().hi.value > every;
        (found.ty.is_scalar() && is_likely && leaves()).then_some(PeriodicCall { op, expr, every })
    });
    calls.take(MAX_CALLS).collect()
}

/// The periods of a function in one period of `mod`, and by how much the angle is off at its end; `None`
/// if it is not off, or by much.
fn jump(every: f64, factor: f64, period: f64) -> Option<(f64, f64)> {
    let angle = (every * factor).abs();
    let count = (angle / period).round();
    let jump = (angle - count * period).abs();
    let is_close = (VISIBLE..=CLOSE).contains(&jump) && (1.0..=MOST).contains(&count);
    is_close.then_some((count, jump))
}

fn report(cx: &mut Context, call: &PeriodicCall, (used, exact, jump): (AngleUse, f64, f64)) {
    let (tree, module) = (&cx.program.tree, cx.facts.module());
    let ExprKind::Call(_, args) = tree.expr(call.expr).kind else {
        return;
    };
    let &[_, length] = tree.args(args) else {
        return;
    };
    let function = used.function.name();
    let exact = format!("{:?}", exact as f32);
    let is_literal = matches!(tree.expr(length).kind, ExprKind::Float(_));
    let fix = cx.suggest(length, exact.as_str()).filter(|_| is_literal);
    let angle = module.provenance(used.call).extent(tree);
    let angle = angle.map(|extent| cx.program.span(extent));
    let text = cx.program.expr_text(length);
    let message = format!("`{text}` is not a period of `{function}`, which jumps there");
    let has_fix = fix.is_some();
    let finding = cx
        .report_expr(length, message)
        .fix(fix)
        .label(angle, "used as an angle here")
        .note(format!(
            "each time `mod` starts again, the angle jumps by {jump:.3}; a period is {exact}"
        ));
    if !has_fix {
        finding.help(format!("use `{exact}`"));
    }
}
