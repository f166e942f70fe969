//! Constants whose value the language does not define, or that no `float` can hold.

use shaderlint_diagnostic::Severity;
use shaderlint_lint::{BinaryExpr, Builtin, Check, Context, Group, Rule, Shape};
use shaderlint_semantic::{BuiltinId, Scalar, Value};
use shaderlint_syntax::ast::{BinaryOp, ExprId, ExprKind};

pub static RULE: Rule = Rule {
    name: "undefined-constant",
    group: Group::Numeric,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("undefined_constant.md"),
    checks: &[
        Check::Builtin(check_call),
        Check::Binary(check_overflow),
        Check::Expr(&[Shape::FloatLiteral], check_literal),
        Check::Expr(&[Shape::Construct], check_conversion),
    ],
};

const OVERFLOW: &str = "no `float` goes beyond 3.4e38: it is an infinity on most GPUs";

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
    let one = |is_bad: fn(f32) -> bool| floats(cx, first).find(|v| is_bad(*v));
    let both = |is_bad: fn(f32, f32) -> bool| {
        let second = call.args.get(1).copied()?;
        floats(cx, first)
            .zip(floats(cx, second))
            .find(|(a, b)| is_bad(*a, *b))
    };
    let said = match call.function {
        BuiltinId::Acosh => one(|v| v < 1.0).map(|v| format!("`acosh` of {v:?}, which is below 1")),
        BuiltinId::Atanh => one(|v| v.abs() >= 1.0)
            .map(|v| format!("`atanh` of {v:?}, which is not between -1 and 1")),
        BuiltinId::Pow => both(|a, b| a == 0.0 && b <= 0.0)
            .map(|(_, b)| format!("`pow` of zero with the exponent {b:?}")),
        BuiltinId::Atan => both(|a, b| a == 0.0 && b == 0.0)
            .map(|_| "`atan` of the point (0, 0), which lies in no direction".to_string()),
        _ => None,
    };
    if let Some(said) = said {
        cx.report_expr(call.id, said)
            .note("the result is undefined; each GPU gives what it likes");
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
        cx.report_expr(call.id, format!("the result of `{name}` overflows"))
            .note(OVERFLOW);
    }
}

fn check_overflow(cx: &mut Context, e: &BinaryExpr) {
    use BinaryOp::{Add, Div, Mul, Sub};
    let is_arithmetic = matches!(e.op, Add | Sub | Mul | Div);
    let is_out = is_arithmetic && floats(cx, e.id).any(f32::is_infinite);
    // Division by zero is another mistake.
    let is_zero = |side| e.op == Div && floats(cx, side).any(|v| v == 0.0);
    let sides = [e.left, e.right];
    if is_out && sides.iter().all(|s| floats(cx, *s).all(f32::is_finite)) && !is_zero(e.right) {
        cx.report_expr(e.id, "the value of this constant overflows")
            .note(OVERFLOW);
    }
}

fn check_literal(cx: &mut Context, id: ExprId) {
    if matches!(cx.program.tree.expr(id).kind, ExprKind::Float(v) if v.is_infinite()) {
        cx.report_expr(id, "this number is greater than any `float`")
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
        cx.report_expr(id, format!("{value:e} does not fit into `{name}`"))
            .note("the result of such a conversion is undefined");
    }
}
