//! `a == b` on floats.

use crate::diagnostic::Severity;
use crate::lint::{Binary, Check, Context, Group, Rule};
use crate::semantic::flow::range::is_same;
use crate::semantic::{Scalar, Storage};
use crate::syntax::ast::{BinaryOp, ExprId};

pub static RULE: Rule = Rule {
    name: "float-equality",
    group: Group::Numeric,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("float_equality.md"),
    check: Check::Binary(check),
};

fn check(cx: &mut Context, e: &Binary) {
    if !matches!(e.op, BinaryOp::Equal | BinaryOp::NotEqual) {
        return;
    }
    let program = cx.program;
    let is_float = program.ty(e.left).scalar_kind() == Some(Scalar::Float);
    if !is_float || program.expr(e.id).is_const || is_same(program, e.left, e.right) {
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
fn is_exact(cx: &Context, e: &Binary, component: u8) -> bool {
    let ranges = cx.facts.ranges();
    let (left, right) = (
        ranges.component(e.left, component),
        ranges.component(e.right, component),
    );
    // A division or root is to be kept from exactly zero, and what a value is bounded by is held.
    let is_edge = |value: Option<f64>, other: &crate::semantic::flow::range::Range| {
        value.is_some_and(|v| v == 0.0 || other.holds(v))
    };
    (left.exact && right.exact)
        || is_edge(left.single(), &right)
        || is_edge(right.single(), &left)
        || (left.exact && is_given(cx, e.right))
        || (right.exact && is_given(cx, e.left))
        || ranges.may_be_copies(e.left, e.right, component)
}

/// Whether a value comes from the host as it stands.
fn is_given(cx: &Context, expr: ExprId) -> bool {
    let root = crate::semantic::flow::range::root_variable(cx.program, expr);
    let variable = root.and_then(|v| cx.program.variable(v));
    variable.is_some_and(|v| v.storage == Storage::Uniform)
}
