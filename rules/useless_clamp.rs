//! `clamp`, `min` and `max` that never change their value, or always replace it.

use shaderlint_lint::given::{is_computed_here, is_exact, is_of_uniforms};
use shaderlint_lint::prelude::*;

rule! { useless_clamp, Numeric, Info, Recommended, Builtin(check) }

/// How often a bound changes a value.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Cut {
    Never,
    Sometimes,
    Always,
}

fn check(cx: &mut Context, call: &Builtin) {
    let program = cx.program;
    let (low, high) = match *call.args {
        [_, _] if call.function == BuiltinId::Max => (true, false),
        [_, _] if call.function == BuiltinId::Min => (false, true),
        [_, _, _] if call.function == BuiltinId::Clamp => (true, true),
        _ => return,
    };
    if program.expr(call.id).is_const || !cx.is_direct(call.id) {
        return;
    }
    // The bound of `min` and `max` may be either argument.
    let is_known = |e: &ExprId| !program.values(*e).is_empty();
    let (value, low, high) = match *call.args {
        [value, a, b] => (value, low.then_some(a), high.then_some(b)),
        [a, b] if is_known(&a) != is_known(&b) => {
            let (value, bound) = if is_known(&a) { (b, a) } else { (a, b) };
            (value, low.then_some(bound), high.then_some(bound))
        }
        _ => return,
    };
    if ![low, high].iter().flatten().all(is_known) {
        return;
    }
    let below = low.map(|bound| cut(cx, value, bound, true));
    let above = high.map(|bound| cut(cx, value, bound, false));
    let all = [below, above];
    let always = all
        .iter()
        .zip([low, high])
        .find(|(cut, _)| **cut == Some(Cut::Always));
    let Some(range) = cx.facts.range(value).next() else {
        return;
    };
    let name = call.function.name();
    let message = match always.and_then(|(_, bound)| bound) {
        Some(bound) => format!("`{name}` always returns `{}`", program.expr_text(bound)),
        None if all.iter().flatten().all(|c| *c == Cut::Never) => {
            format!("`{name}` has no effect")
        }
        None => return,
    };
    // Clamping what callers and the host pass is reasonable.
    let is_own = is_computed_here(program, cx.facts, value) && !is_of_uniforms(program, value);
    if !is_own || may_be_nan(cx, value) {
        return;
    }
    let place = program.expr_span(value);
    cx.report_expr(call.id, message)
        .label(place, format!("range: {range}"));
}

/// Whether the value is that of a function outside its domain, such as `sqrt` of a negative number:
/// a bound then replaces NaN.
fn may_be_nan(cx: &Context, value: ExprId) -> bool {
    let (module, ranges) = (cx.facts.module(), cx.facts.ranges());
    let Some(op) = module.op_of(value) else {
        return false;
    };
    let OpKind::Builtin(function, list) = module.op(op).kind else {
        return false;
    };
    let args = module.operands(list);
    (0..module.ty(op).components()).any(|lane| {
        function.undefined().may_hold(|operand| {
            let arg = *args.get(operand)?;
            let range = ranges.lane(arg, module.operand_lane(arg, lane));
            Some((range.lo.value, range.hi.value))
        })
    })
}

/// How often a bound changes the components of a value; `Sometimes` where they differ.
fn cut(cx: &Context, value: ExprId, bound: ExprId, is_low: bool) -> Cut {
    let exact = is_exact(cx.facts, cx.program, value, is_low);
    let bounds: Vec<Interval> = cx.facts.range(bound).collect();
    let mut all = None;
    for (at, range) in cx.facts.range(value).enumerate() {
        let Some(bound) = bounds.get(at).or(bounds.first()).and_then(Interval::single) else {
            return Cut::Sometimes;
        };
        let (near, far) = match is_low {
            true => (range.lo.value - bound, range.hi.value - bound),
            false => (bound - range.hi.value, bound - range.lo.value),
        };
        let slack = 1e-3 * bound.abs().max(0.1);
        let cut = match () {
            _ if range.single().is_some() => Cut::Sometimes,
            _ if near > slack || near >= 0.0 && exact => Cut::Never,
            _ if far < -slack => Cut::Always,
            _ => Cut::Sometimes,
        };
        if *all.get_or_insert(cut) != cut {
            return Cut::Sometimes;
        }
    }
    all.unwrap_or(Cut::Sometimes)
}
