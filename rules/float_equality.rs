//! `a == b` on floats when one side is rounded.

use shaderlint_flow::ranges::Rounding;
use shaderlint_lint::prelude::*;

rule! { float_equality, Numeric, Warning, Recommended, Binary(check) }

fn check(cx: &mut Context, e: &BinaryExpr) {
    if !matches!(e.op, BinaryOp::Equal | BinaryOp::NotEqual) {
        return;
    }
    let program = cx.program;
    let ty = program.ty(e.left);
    let is_float = ty.scalar_kind() == Some(Scalar::Float) && !ty.is_matrix();
    if !is_float || program.expr(e.id).is_const || cx.facts.is_same(e.left, e.right) {
        return;
    }
    let Some(rounded) = (0..ty.components() as u8).find_map(|c| rounded_side(cx, e, c)) else {
        return;
    };
    let (left, right) = (program.expr_text(e.left), program.expr_text(e.right));
    let (rounded, other) = match rounded {
        EqualitySide::Left => (&left, &right),
        EqualitySide::Right => (&right, &left),
    };
    let relation = match e.op {
        BinaryOp::Equal => "<",
        _ => ">=",
    };
    let instead = match ty.is_vector() {
        true => format!("distance({left}, {right}) {relation} 1e-4"),
        false => format!("abs({left} - {right}) {relation} 1e-4"),
    };
    let message = format!("`{rounded}` is rounded and may not exactly equal `{other}`");
    cx.report_expr(e.id, message)
        .note("GPUs round differently, so values that should be equal can differ")
        .help(format!("compare with a tolerance: `{instead}`"));
}

/// One of the sides of a comparison.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum EqualitySide {
    Left,
    Right,
}

/// The side that is certainly rounded, if that may change the result of the comparison.
fn rounded_side(cx: &Context, e: &BinaryExpr, component: u8) -> Option<EqualitySide> {
    let left = cx.facts.range(e.left).nth(component as usize)?;
    let right = cx.facts.range(e.right).nth(component as usize)?;
    // Nothing was computed.
    if is_read_of_uniform(cx, e.left) || is_read_of_uniform(cx, e.right) {
        return None;
    }
    let side = match (left.rounding, right.rounding) {
        (Rounding::Always, _) => EqualitySide::Left,
        (_, Rounding::Always) => EqualitySide::Right,
        _ => return None,
    };
    // A comparison with zero guards a division or square root, and the limits of a value are exact,
    // as is the first value of a uniform.
    let is_first = |v: f64, other: &Interval, side: ExprId| {
        other.lo.value == v && other.lo.is_reached() && is_uniform(cx, side)
    };
    let is_edge = |value: Option<f64>, (other, side): (&Interval, ExprId)| {
        value.is_some_and(|v| v == 0.0 || other.holds(v) || is_first(v, other, side))
    };
    let is_meant = is_edge(left.single(), (&right, e.right))
        || is_edge(right.single(), (&left, e.left))
        || may_be_copies(cx, e, component);
    (!is_meant).then_some(side)
}

fn is_read_of_uniform(cx: &Context, side: ExprId) -> bool {
    let program = cx.program;
    let mut object = program.tree.unparen(side);
    while let ExprKind::Index(inner, _) | ExprKind::Member(inner, _) =
        program.tree.expr(object).kind
    {
        object = program.tree.unparen(inner);
    }
    let variable = program.variable_of(object);
    let variable = variable.and_then(|id| program.variable(id));
    variable.is_some_and(|v| v.storage == Storage::Uniform)
}

/// Whether all pixels of a frame compute the same value.
fn is_uniform(cx: &Context, side: ExprId) -> bool {
    let op = cx.facts.module().op_of(side);
    op.is_some_and(|op| !cx.facts.uniformity().varies(Varying::Value(op)))
}

fn may_be_copies(cx: &Context, e: &BinaryExpr, component: u8) -> bool {
    let module = cx.facts.module();
    let sides = module.op_of(e.left).zip(module.op_of(e.right));
    sides.is_some_and(|(left, right)| {
        cx.facts
            .ranges()
            .may_be_copies(left, right, component as u32)
    })
}
