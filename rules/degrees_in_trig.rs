//! Angles in degrees where radians are expected.

use shaderlint_flow::reaching_definitions::Def;
use shaderlint_lint::prelude::*;

rule! {
    degrees_in_trig, Numeric, Warning, Recommended,
    Builtin(check), Expr(&[Shape::Call], check_passed)
}

fn check(cx: &mut Context, call: &Builtin) {
    let &[angle] = call.args else { return };
    if is_trig(call.function) && is_in_degrees(cx, angle) {
        report(cx, angle, call.function);
    }
}

const fn is_trig(function: BuiltinId) -> bool {
    matches!(function, BuiltinId::Sin | BuiltinId::Cos | BuiltinId::Tan)
}

/// Whether an angle is a constant that looks like degrees: 30, 45, 90, 180.
fn is_in_degrees(cx: &Context, angle: ExprId) -> bool {
    let value = cx.program.scalar(angle).map(|v| v.as_float().abs());
    value.is_some_and(|v| (30.0..=720.0).contains(&v) && v % 15.0 == 0.0)
}

/// `rotate(90.0)`, where the function passes its parameter to `sin`.
fn check_passed(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    let (ExprKind::Call(_, args), Resolution::Function(callee)) =
        (program.tree.expr(id).kind, program.expr(id).resolution)
    else {
        return;
    };
    let args = program.tree.args(args);
    for (position, angle) in args.iter().enumerate() {
        if !is_in_degrees(cx, *angle) {
            continue;
        }
        let parameters = cx.facts.module().function(callee);
        let parameter = parameters
            .and_then(|f| cx.facts.module().parameters(f).get(position))
            .copied();
        let taken = parameter.and_then(|p| taken_by(cx, callee, p));
        if let Some(function) = taken {
            report(cx, *angle, function);
        }
    }
}

/// The trigonometric function that a function passes one of its parameters to unchanged.
fn taken_by(cx: &Context, callee: FunctionRef, parameter: VariableId) -> Option<BuiltinId> {
    let (module, defs) = (cx.facts.module(), cx.facts.reaching_definitions());
    module.function(callee)?.ops.ops().find_map(|op| {
        let OpKind::Builtin(function, operands) = module.op(op).kind else {
            return None;
        };
        let (true, &[angle]) = (is_trig(function), module.operands(operands)) else {
            return None;
        };
        let (load, lane) = defs.through(module, angle, 0)?;
        let from = defs.copied_from(module, defs.seen(load, lane));
        let is_it =
            matches!(defs.get(from), Def::Entry(slot) if defs.variable_at(slot).0 == parameter);
        is_it.then_some(function)
    })
}

fn report(cx: &mut Context, angle: ExprId, function: BuiltinId) {
    let text = cx.program.expr_text(angle).to_string();
    let fix = cx.suggest(angle, format!("radians({text})"));
    let name = function.name();
    cx.report_expr(
        angle,
        format!("`{name}` expects radians, but `{text}` looks like degrees"),
    )
    .note("a full circle is 360 degrees or 6.2832 radians")
    .fix(fix);
}
