//! Divisions of integers that lose what was meant.

use shaderlint_diagnostic::{Fix, Severity};
use shaderlint_lint::{BinaryExpr, Check, Context, Group, Rule};
use shaderlint_semantic::{Scalar, Value};
use shaderlint_syntax::ast::{BinaryOp, ExprId, ExprKind};
use shaderlint_text::Edit;

pub static RULE: Rule = Rule {
    name: "integer-division",
    group: Group::Numeric,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("integer_division.md"),
    checks: &[Check::Binary(check)],
};

fn check(cx: &mut Context, e: &BinaryExpr) {
    let program = cx.program;
    let kind = program.ty(e.id).scalar_kind();
    if e.op != BinaryOp::Div
        || !kind.is_some_and(Scalar::is_integer)
        || !program.ty(e.id).is_scalar()
    {
        return;
    }
    // Both are scalars: what they make is one.
    let (left, right) = (
        cx.facts.range(e.left).next(),
        cx.facts.range(e.right).next(),
    );
    let (Some(a), Some(b)) = (left, right) else {
        return;
    };
    let literals = is_literal(cx, e.left) && is_literal(cx, e.right);
    let (message, is_float) = match (a.single(), b.single()) {
        (Some(x), Some(y)) if y != 0.0 && x % y != 0.0 => {
            let whole = (x / y).trunc();
            let is_float = becomes_float(cx, e.id);
            // Half of a size that has a name is counted in whole cells.
            let is_meant = !literals && whole != 0.0;
            if is_meant || !(is_float || whole == 0.0 && literals) {
                return;
            }
            (format!("`{x} / {y}` of integers is {whole}"), is_float)
        }
        // `i / n` with `i` from 0 to `n - 1`.
        (None, _) if a.lo.value >= 0.0 && a.is_finite() && b.lo.value > a.hi.value => {
            if !becomes_float(cx, e.id) {
                return;
            }
            let (a, b) = (a.of_integer(), b.of_integer());
            (
                format!("this division of integers is always 0: {a} by {b}"),
                true,
            )
        }
        _ => return,
    };
    let fix = (is_float && literals && cx.is_direct(e.id)).then(|| {
        let at = |e| program.expr_span(e).end;
        let edits = vec![
            Edit::insert(at(e.left), ".0"),
            Edit::insert(at(e.right), ".0"),
        ];
        Fix::suggestion("divide floats", edits)
    });
    cx.report_expr(e.id, message)
        .note("the division of integers drops what is behind the point")
        .help("convert to `float` before the division, not after it")
        .fix(fix);
}

fn is_literal(cx: &Context, e: ExprId) -> bool {
    matches!(cx.program.scalar(e), Some(Value::Int(_)))
        && matches!(cx.program.tree.expr(e).kind, ExprKind::Int(_))
}

/// Whether the quotient is the argument of a constructor of floats.
fn becomes_float(cx: &Context, id: ExprId) -> bool {
    let tree = &cx.program.tree;
    let mut inner = id;
    while let Some(parent) = cx.facts.structure().parent(inner) {
        match tree.expr(parent).kind {
            ExprKind::Paren(_) => inner = parent,
            ExprKind::Construct(..) => {
                return cx.program.ty(parent).scalar_kind() == Some(Scalar::Float);
            }
            _ => return false,
        }
    }
    false
}
