//! Luma weights that do not add up to 1.

use shaderlint_lint::prelude::*;

rule! { luma_weights, Numeric, Warning, Recommended, Builtin(check) }

/// Luma weights of red, green and blue in the television standards.
const STANDARDS: [([f64; 3], &str); 3] = [
    ([0.299, 0.587, 0.114], "BT.601"),
    ([0.2126, 0.7152, 0.0722], "BT.709"),
    ([0.2627, 0.6780, 0.0593], "BT.2020"),
];

fn check(cx: &mut Context, call: &Builtin) {
    let (BuiltinId::Dot, &[a, b]) = (call.function, call.args) else {
        return;
    };
    let program = cx.program;
    let known = [a, b]
        .into_iter()
        .find_map(|side| match *program.values(side) {
            [r, g, b] => Some((side, [r, g, b].map(|v| f64::from(v.as_float())))),
            _ => None,
        });
    let Some((side, weights)) = known else { return };
    let sum: f64 = weights.iter().sum();
    let close = |a: f64, b: f64| (a - b).abs() < 0.0051;
    // Two matching weights identify the standard; the sum must be 1 to preserve greys.
    let meant = STANDARDS.into_iter().find(|(right, _)| {
        let count = right
            .iter()
            .zip(weights)
            .filter(|(r, w)| close(**r, *w))
            .count();
        count == 2
    });
    let Some((right, name)) = meant.filter(|_| (sum - 1.0).abs() > 0.011) else {
        return;
    };
    let text = right.map(|w| w.to_string()).join(", ");
    let fix = fix(cx, side, &text);
    cx.report_expr(
        side,
        format!("luma weights add up to {:.3} instead of 1", sum),
    )
    .note(format!("two of them match {name}: `vec3({text})`"))
    .fix(fix);
}

fn fix(cx: &Context, side: ExprId, text: &str) -> Option<Fix> {
    let is_vector = matches!(cx.program.tree.expr(side).kind, ExprKind::Construct(..));
    (is_vector && cx.is_direct(side)).then(|| {
        let weights = format!("vec3({text})");
        let title = format!("use `{weights}`");
        let edit = Edit::replace(cx.program.expr_span(side), weights);
        Fix::suggestion(title, vec![edit])
    })
}
