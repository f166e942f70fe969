//! Arguments in a different order than the parameters.

use shaderlint_lint::prelude::*;

rule! { swapped_arguments, Numeric, Warning, Recommended, Builtin(check) }

fn check(cx: &mut Context, call: &Builtin) {
    let &[a, b, c] = call.args else { return };
    let program = cx.program;
    let is_known = |e| !program.values(e).is_empty();
    // A named number: a variable that always has the same value.
    let is_number = |e| {
        let ranges: Vec<_> = cx.facts.range(e).collect();
        is_known(e) || !ranges.is_empty() && ranges.iter().all(|r| r.single().is_some())
    };
    let is_share = |e| {
        let mut values = program.values(e).iter().map(|v| v.as_float());
        values.all(|v| (0.0..=1.0).contains(&v))
    };
    let (order, why) = match call.function {
        BuiltinId::Smoothstep if !is_number(a) && is_number(b) && is_number(c) => (
            [b, c, a],
            "the order is `smoothstep(edge0, edge1, x)`; here `edge0` varies and `x` is constant",
        ),
        // `mix(color, vec3(0.5), -0.3)` extrapolates: in the other order the types would differ.
        BuiltinId::Mix
            if !is_known(a)
                && is_known(b)
                && is_known(c)
                && !is_share(c)
                && program.ty(b) == program.ty(c) =>
        {
            (
                [b, c, a],
                "the order is `mix(x, y, a)`; here `a` is a constant outside 0.0 to 1.0",
            )
        }
        BuiltinId::Clamp if is_known(a) && !is_known(b) && is_known(c) => (
            [b, a, c],
            "the order is `clamp(x, minVal, maxVal)`; here `x` is constant and `minVal` varies",
        ),
        _ => return,
    };
    let name = call.function.name();
    let [x, y, z] = order.map(|e| program.expr_text(e));
    let instead = format!("{name}({x}, {y}, {z})");
    // The fix must keep the type of each argument: scalars have fixed positions among vectors.
    let is_same = order
        .iter()
        .zip(call.args)
        .all(|(e, at)| program.ty(*e) == program.ty(*at));
    let fix = cx.suggest(call.id, instead.as_str()).filter(|_| is_same);
    let message = format!("arguments of `{name}` seem to be in the wrong order");
    cx.report_expr(call.id, message).note(why).fix(fix);
}
