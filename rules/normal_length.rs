//! Vectors that must have length 1 and do not.

use shaderlint_lint::prelude::*;

rule! { normal_length, Numeric, Warning, Recommended, Builtin(check) }

/// Tolerance around length 1, for rounding and for constants written with few digits.
const SLACK: f64 = 0.02;

fn check(cx: &mut Context, call: &Builtin) {
    let unit = match (call.function, call.args) {
        (BuiltinId::Reflect, [_, normal]) => std::slice::from_ref(normal),
        (BuiltinId::Refract, [both @ .., _]) => both,
        _ => return,
    };
    let found = unit.iter().find_map(|&of| {
        let count = cx.program.ty(of).components();
        let values = cx.program.values(of);
        let (low, high) = if values.is_empty() {
            let op = cx.facts.module().op_of(of)?;
            let length = cx.facts.ranges().lane(op, count);
            (length.lo.value, length.hi.value)
        } else {
            let squares = values.iter().map(|v| f64::from(v.as_float()).powi(2));
            let length = squares.sum::<f64>().sqrt();
            (length, length)
        };
        let is_wrong = count > 1 && (low > 1.0 + SLACK || high < 1.0 - SLACK);
        is_wrong.then_some((of, low, high))
    });
    let Some((of, low, high)) = found else { return };
    let known = match (low - high).abs() < 1e-6 {
        true => format!("{low:.3}"),
        false if low > 1.0 => format!("at least {low:.3}"),
        false => format!("at most {high:.3}"),
    };
    let (name, text) = (call.function.name(), cx.program.expr_text(of));
    cx.report_expr(
        of,
        format!("`{name}` expects a unit vector, but the length is {known}"),
    )
    .note("with any other length, the result has the wrong direction (section 8.5)")
    .help(format!("use `normalize({text})`"));
}
