//! Arguments in another order than the function takes them.

use shaderlint_diagnostic::{Fix, Severity};
use shaderlint_lint::{Builtin, Check, Context, Group, Rule};
use shaderlint_semantic::BuiltinId;
use shaderlint_text::Edit;

pub static RULE: Rule = Rule {
    name: "swapped-arguments",
    group: Group::Numeric,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("swapped_arguments.md"),
    checks: &[Check::Builtin(check)],
};

fn check(cx: &mut Context, call: &Builtin) {
    let &[a, b, c] = call.args else { return };
    let program = cx.program;
    let is_known = |e| !program.values(e).is_empty();
    let is_share = |e| {
        let mut values = program.values(e).iter().map(|v| v.as_float());
        values.all(|v| (0.0..=1.0).contains(&v))
    };
    let (wrong, order, why) = match call.function {
        BuiltinId::Smoothstep if !is_known(a) && is_known(b) && is_known(c) => (
            "takes an edge from what varies, and a constant between its edges",
            [b, c, a],
            "both edges stand first, then the value between them",
        ),
        BuiltinId::Mix if !is_known(a) && is_known(b) && is_known(c) && !is_share(c) => (
            "has a constant share that is not between 0 and 1",
            [b, c, a],
            "both ends stand first, then the share of the second",
        ),
        BuiltinId::Clamp if is_known(a) && !is_known(b) && is_known(c) => (
            "bounds a constant, and takes its lower bound from what varies",
            [b, a, c],
            "the value stands first, then the lower bound, then the upper",
        ),
        _ => return,
    };
    let name = call.function.name();
    let [x, y, z] = order.map(|e| program.expr_text(e));
    let instead = format!("{name}({x}, {y}, {z})");
    // What is scalar among vectors has one place alone.
    let is_same = order
        .iter()
        .zip(call.args)
        .all(|(e, at)| program.ty(*e) == program.ty(*at));
    let fix = (is_same && cx.is_direct(call.id)).then(|| {
        let edit = Edit::replace(program.expr_span(call.id), instead.clone());
        Fix::suggestion(format!("write `{instead}`"), vec![edit])
    });
    cx.report_expr(call.id, format!("this `{name}` {wrong}"))
        .note(why)
        .fix(fix);
}
