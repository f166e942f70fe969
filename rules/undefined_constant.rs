//! Constants with an undefined value, or too large for their type.

use shaderlint_lint::prelude::*;
use shaderlint_text::number::significant;

rule! {
    undefined_constant, Numeric, Warning, Recommended,
    Builtin(check_call), Binary(check_overflow), Expr(&[Shape::FloatLiteral], check_literal),
    Expr(&[Shape::Construct], check_conversion)
}

const OVERFLOW: &str =
    "the largest `float` is about 3.4e38; larger values are infinity on most GPUs";

fn floats<'c>(cx: &'c Context, expr: ExprId) -> impl Iterator<Item = f32> + 'c {
    cx.program.values(expr).iter().map(|v| v.as_float())
}

fn check_call(cx: &mut Context, call: &Builtin) {
    let Some(&first) = call.args.first() else {
        return;
    };
    if cx.program.values(first).is_empty() {
        return;
    }
    let name = call.function.name();
    let number = |v: f32| significant(f64::from(v), 7);
    let one = |is_bad: fn(f32) -> bool| floats(cx, first).find(|v| is_bad(*v));
    let both = |is_bad: fn(f32, f32) -> bool| {
        let second = call.args.get(1).copied()?;
        floats(cx, first)
            .zip(floats(cx, second))
            .find(|(a, b)| is_bad(*a, *b))
    };
    let (message, domain) = match call.function {
        BuiltinId::Acosh => (
            one(|v| v < 1.0).map(|v| format!("`acosh` of {} is undefined", number(v))),
            "the argument must be at least 1 (section 8.1)",
        ),
        BuiltinId::Atanh => (
            one(|v| v.abs() >= 1.0).map(|v| format!("`atanh` of {} is undefined", number(v))),
            "the argument must be between -1 and 1 (section 8.1)",
        ),
        BuiltinId::Pow => (
            both(|a, b| a == 0.0 && b <= 0.0)
                .map(|(_, b)| format!("`pow` of 0.0 with exponent {} is undefined", number(b))),
            "if the base is 0.0, the exponent must be greater than 0.0 (section 8.2)",
        ),
        BuiltinId::Atan => (
            both(|a, b| a == 0.0 && b == 0.0).map(|_| "`atan(0.0, 0.0)` is undefined".to_string()),
            "at least one argument must not be 0.0 (section 8.1)",
        ),
        _ => (None, ""),
    };
    if let Some(message) = message {
        cx.report_expr(call.id, message).note(domain);
        return;
    }
    let is_finite = |e: &ExprId| {
        let mut values = floats(cx, *e).peekable();
        values.peek().is_some() && values.all(f32::is_finite)
    };
    let grows = matches!(
        call.function,
        BuiltinId::Exp | BuiltinId::Exp2 | BuiltinId::Pow | BuiltinId::Sinh | BuiltinId::Cosh
    );
    if grows && call.args.iter().all(is_finite) && floats(cx, call.id).any(f32::is_infinite) {
        cx.report_expr(call.id, format!("result of `{name}` overflows `float`"))
            .note(OVERFLOW);
    }
}

fn check_overflow(cx: &mut Context, e: &BinaryExpr) {
    use BinaryOp::{Add, Div, Mul, Sub};
    let is_arithmetic = matches!(e.op, Add | Sub | Mul | Div);
    let is_out = is_arithmetic && floats(cx, e.id).any(f32::is_infinite);
    // `zero-division` reports division by zero.
    let is_zero = |side| e.op == Div && floats(cx, side).any(|v| v == 0.0);
    let sides = [e.left, e.right];
    if is_out && sides.iter().all(|s| floats(cx, *s).all(f32::is_finite)) && !is_zero(e.right) {
        cx.report_expr(e.id, "constant expression overflows `float`")
            .note(OVERFLOW);
    }
}

fn check_literal(cx: &mut Context, id: ExprId) {
    if matches!(cx.program.tree.expr(id).kind, ExprKind::Float(v) if v.is_infinite()) {
        cx.report_expr(id, "literal is too large for `float`")
            .note(OVERFLOW);
    }
}

/// `int(3e9)`
fn check_conversion(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    let ExprKind::Construct(_, args) = program.tree.expr(id).kind else {
        return;
    };
    let ends = match program.ty(id).scalar_kind() {
        Some(Scalar::Int) => -2_147_483_648.0..2_147_483_648.0,
        Some(Scalar::Uint) => f64::NEG_INFINITY..4_294_967_296.0,
        _ => return,
    };
    let is_float = |v: &&Value| matches!(v, Value::Float(_));
    let values = program
        .tree
        .args(args)
        .iter()
        .flat_map(|a| program.values(*a));
    let out = values.filter(is_float).map(|v| f64::from(v.as_float()));
    if let Some(value) = out.into_iter().find(|v| !ends.contains(v) && v.is_finite()) {
        let name = program.type_name(program.ty(id));
        cx.report_expr(
            id,
            format!("{:e} is out of range for `{name}`", value as f32),
        )
        .note("converting a value that the type cannot hold is undefined (section 5.4.1)");
    }
}
