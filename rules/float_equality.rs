//! `a == b` on floats.

use crate::diagnostic::Severity;
use crate::ir::{OpKind, Root};
use crate::lint::{BinaryExpr, Check, Context, Group, Rule};
use crate::semantic::Scalar;
use crate::syntax::ast::{BinaryOp, ExprId};

pub static RULE: Rule = Rule {
    name: "float-equality",
    group: Group::Numeric,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("float_equality.md"),
    checks: &[Check::Binary(check)],
};

fn check(cx: &mut Context, e: &BinaryExpr) {
    if !matches!(e.op, BinaryOp::Equal | BinaryOp::NotEqual) {
        return;
    }
    let program = cx.program;
    let is_float = program.ty(e.left).scalar_kind() == Some(Scalar::Float);
    if !is_float || program.expr(e.id).is_const || cx.facts.is_same(e.left, e.right) {
        return;
    }
    let count = program.ty(e.left).components();
    if program.ty(e.left).is_matrix() || (0..count as u8).all(|c| is_exact(cx, e, c)) {
        return;
    }
    let (left, right) = (program.expr_text(e.left), program.expr_text(e.right));
    let (symbol, relation) = if e.op == BinaryOp::Equal {
        ("==", "<")
    } else {
        ("!=", ">=")
    };
    let instead = if program.ty(e.left).is_vector() {
        format!("distance({left}, {right}) {relation} 1e-4")
    } else {
        format!("abs({left} - {right}) {relation} 1e-4")
    };
    cx.report_expr(
        e.id,
        format!("`{symbol}` on floats is almost never what is meant"),
    )
    .note("rounding makes two results differ that should be equal")
    .help(format!("compare with a tolerance: `{instead}`"));
}

/// Whether no rounding can come between the two.
fn is_exact(cx: &Context, e: &BinaryExpr, component: u8) -> bool {
    let (Some(left), Some(right)) = (
        cx.facts.range(e.left).nth(component as usize),
        cx.facts.range(e.right).nth(component as usize),
    ) else {
        return false;
    };
    // A division or root is to be kept from exactly zero, and what a value is bounded by is held.
    let is_edge = |value: Option<f64>, other: &crate::flow::ranges::Interval| {
        value.is_some_and(|v| v == 0.0 || other.holds(v))
    };
    (left.exact && right.exact)
        || is_edge(left.single(), &right)
        || is_edge(right.single(), &left)
        || (left.exact && is_given(cx, e.right))
        || (right.exact && is_given(cx, e.left))
        || may_be_copies(cx, e, component)
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

/// Whether a value comes from the host as it stands.
fn is_given(cx: &Context, expr: ExprId) -> bool {
    let module = cx.facts.module();
    let variable = module.op_of(expr).and_then(|op| match module.op(op).kind {
        OpKind::Load(place) => module.variable(module.place(place).variable),
        _ => None,
    });
    variable.is_some_and(|v| v.root == Root::Uniform)
}
