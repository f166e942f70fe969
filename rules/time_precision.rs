//! Time multiplied by a factor so large that a `float` loses its precision.

use shaderlint_lint::prelude::*;

rule! { time_precision, Numeric, Info, Strict, [Number(&FACTOR)], Builtin(check) }

static FACTOR: Setting<f64> = Setting::new(
    "factor",
    250.0,
    "Smallest factor of the time that is reported",
);

/// Running time in seconds at which the distance between two floats is reported.
const LATER: f64 = 900.0;

/// Most operations followed for one component; longer chains are not a plain multiple of the time.
const MAX_PARTS: u32 = 16;

fn check(cx: &mut Context, call: &Builtin) {
    use BuiltinId::{Cos, Fract, Mod, Sin, Tan};
    let Some(&of) = call.args.first() else { return };
    if !matches!(call.function, Sin | Cos | Tan | Fract | Mod) {
        return;
    }
    let Some(op) = cx.facts.module().op_of(of) else {
        return;
    };
    let limit = cx.option(&FACTOR);
    let lanes = 0..cx.program.ty(of).components();
    let factors = lanes.filter_map(|lane| factor(cx, op, lane, &mut { MAX_PARTS }));
    let Some(factor) = factors.reduce(f64::max).filter(|f| *f >= limit) else {
        return;
    };
    let period = match call.function {
        Mod => call
            .args
            .get(1)
            .and_then(|y| cx.program.scalar(*y))
            .map(|y| f64::from(y.as_float().abs())),
        Fract => Some(1.0),
        _ => Some(std::f64::consts::TAU),
    };
    // A long period tolerates the lost digits.
    let Some(period) = period.filter(|p| factor >= limit * p.max(1.0)) else {
        return;
    };
    let step = f64::from((LATER as f32).next_up() - LATER as f32) * factor;
    let name = call.function.name();
    let message = format!("`{name}` of the time multiplied by {factor} loses precision");
    cx.report_expr(of, message)
        .note(format!(
            "after 15 minutes the argument changes in steps of {step:.2} (period: {period:.2}); before that, it already repeats faster than the frame rate"
        ))
        .help("reduce the time first with `mod(iTime, period)`, or use a smaller factor");
}

/// The factor of the time in a component.
fn factor(cx: &Context, op: OpId, lane: u32, left: &mut u32) -> Option<f64> {
    *left = left.checked_sub(1)?;
    let module = cx.facts.module();
    let origin = cx.facts.origin(op, lane);
    if cx.facts.is_given(origin, "iTime") {
        return Some(1.0);
    }
    let Start::Made(made, lane) = origin? else {
        return None;
    };
    let lane_of = |op| module.operand_lane(op, lane);
    let mut of = |op| factor(cx, op, lane_of(op), left);
    let constant = |op| {
        let range = cx.facts.ranges().lane(op, lane_of(op));
        range.single().map(f64::abs)
    };
    match module.op(made).kind {
        OpKind::Unary(Unary::Negate, a) => of(a),
        OpKind::Binary(Binary::Add | Binary::Subtract, a, b) => match (of(a), of(b)) {
            (Some(a), Some(b)) => Some(a.max(b)),
            (a, b) => a.or(b),
        },
        OpKind::Binary(Binary::Multiply, a, b) => match constant(a) {
            Some(value) => Some(value * of(b)?),
            None => Some(constant(b)? * of(a)?),
        },
        OpKind::Binary(Binary::Divide, a, b) => Some(of(a)? / constant(b).filter(|v| *v > 0.0)?),
        _ => None,
    }
}
