//! Formulas that a built-in function computes.

use BinaryOp::{Add, Div, Mul, Sub};
use Formula::{Binary, Call, Number, Operand, Unary};
use shaderlint_lint::formula::{Formula, operands};
use shaderlint_lint::prelude::*;

rule! { manual_builtin, Tidy, Info, Strict, Expr(&[Shape::Binary, Shape::Call], check) }

/// Whether the built-in accepts the operands and is shorter than the formula.
type Fits = fn(&Context, ExprId, &[ExprId]) -> bool;

const A: &Formula = &Operand(0);
const B: &Formula = &Operand(1);
const C: &Formula = &Operand(2);
const ONE: &Formula = &Number(1.0);
const TWO: &Formula = &Number(2.0);

/// Formulas, and the built-in that computes the same from the operands in their order.
#[rustfmt::skip]
static FORMULAS: [(Formula, BuiltinId, Fits); 10] = [
    // min(max(a, b), c) and max(min(a, c), b)
    (Call(BuiltinId::Min, &Call(BuiltinId::Max, A, B), C), BuiltinId::Clamp, are_bounds),
    (Call(BuiltinId::Max, &Call(BuiltinId::Min, A, C), B), BuiltinId::Clamp, are_bounds),
    // sqrt(dot(a, a))
    (Unary(BuiltinId::Sqrt, &Call(BuiltinId::Dot, A, A)), BuiltinId::Length, any),
    // a + (b - a) * c
    (Binary(Add, A, &Binary(Mul, &Binary(Sub, B, A), C)), BuiltinId::Mix, is_mixture),
    // a * (1.0 - c) + b * c
    (Binary(Add, &Binary(Mul, A, &Binary(Sub, ONE, C)), &Binary(Mul, B, C)), BuiltinId::Mix, is_mixture),
    // a - 2.0 * dot(a, b) * b, for each order of multiplication
    (Binary(Sub, A, &Binary(Mul, &Binary(Mul, TWO, &Call(BuiltinId::Dot, A, B)), B)), BuiltinId::Reflect, any),
    (Binary(Sub, A, &Binary(Mul, &Binary(Mul, TWO, B), &Call(BuiltinId::Dot, A, B))), BuiltinId::Reflect, any),
    (Binary(Sub, A, &Binary(Mul, &Binary(Mul, &Call(BuiltinId::Dot, A, B), B), TWO)), BuiltinId::Reflect, any),
    // a - floor(a)
    (Binary(Sub, A, &Unary(BuiltinId::Floor, A)), BuiltinId::Fract, any),
    // a / length(a)
    (Binary(Div, A, &Unary(BuiltinId::Length, A)), BuiltinId::Normalize, is_vector),
];

fn check(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    let is_float = program.ty(id).scalar_kind() == Some(Scalar::Float);
    if !is_float || program.ty(id).is_matrix() || program.expr(id).is_const {
        return;
    }
    let found = FORMULAS.iter().find_map(|(formula, function, fits)| {
        let arguments = operands(cx, formula, id, |all| fits(cx, id, all))?;
        Some((function, arguments))
    });
    let Some((function, arguments)) = found else {
        return;
    };
    // An operand that occurs twice in the formula must have the same value each time.
    let extent = program.tree.expr(id).extent;
    if cx.facts.effects().has(id) || !program.is_direct(extent) {
        return;
    }
    let texts: Vec<&str> = arguments.iter().map(|&a| program.expr_text(a)).collect();
    let call = format!("{}({})", function.name(), texts.join(", "));
    let message = format!("manual implementation of `{}`", function.name());
    cx.report_expr(id, message)
        .fix(Fix::suggested_replacement(program.span(extent), call));
}

fn any(_: &Context, _: ExprId, _: &[ExprId]) -> bool {
    true
}

fn is_vector(cx: &Context, _: ExprId, operands: &[ExprId]) -> bool {
    operands.iter().all(|e| cx.program.ty(*e).is_vector())
}

/// Whether the operands are a value and its constant bounds, in order.
fn are_bounds(cx: &Context, _: ExprId, operands: &[ExprId]) -> bool {
    let program = cx.program;
    let bound = |e: ExprId| {
        let values = program.values(e);
        let first = values.first()?.as_float();
        values
            .iter()
            .all(|v| v.as_float() == first)
            .then_some(first)
    };
    let &[x, low, high] = operands else {
        return false;
    };
    let is_ordered = bound(low).zip(bound(high)).is_some_and(|(l, h)| l <= h);
    let fits = [program.ty(x), Type::FLOAT].contains(&program.ty(low));
    is_ordered && fits && program.ty(low) == program.ty(high) && bound(x).is_none()
}

/// Whether the operands are two values of one type and a weight that is not constant: a constant
/// would be a scale. Terms of a longer sum are left as they are.
fn is_mixture(cx: &Context, id: ExprId, operands: &[ExprId]) -> bool {
    let program = cx.program;
    let parent = cx.facts.structure().parent(id);
    let parent = parent.map(|p| program.tree.expr(p).kind);
    let &[a, b, weight] = operands else {
        return false;
    };
    let ty = program.ty(a);
    let weighs = program.ty(weight) == ty || program.ty(weight).is_scalar();
    let is_summand = matches!(parent, Some(ExprKind::Binary(Add | Sub, ..)));
    !is_summand && program.ty(b) == ty && weighs && program.values(weight).is_empty()
}
