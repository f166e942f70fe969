//! `a == b` on floats.

use crate::diagnostic::Severity;
use crate::lint::{Binary, Check, Context, Group, Rule};
use crate::semantic::Scalar;
use crate::syntax::ast::{BinaryOp, ExprId, ExprKind};

pub static RULE: Rule = Rule {
    name: "float-equality",
    group: Group::Numeric,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("float_equality.md"),
    check: Check::Binary(check),
};

/// Built-in functions whose results are whole numbers, so that comparing two of them is exact.
const WHOLE: [&str; 6] = ["floor", "ceil", "round", "roundEven", "trunc", "sign"];

fn check(cx: &mut Context, e: &Binary) {
    if !matches!(e.op, BinaryOp::Equal | BinaryOp::NotEqual) {
        return;
    }
    let program = cx.program;
    let is_float = program.ty(e.left).scalar_kind() == Some(Scalar::Float);
    if !is_float || program.expr(e.id).is_const {
        return;
    }
    if is_whole(cx, e.left) && is_whole(cx, e.right) {
        return;
    }
    let (left, right) = (program.expr_text(e.left), program.expr_text(e.right));
    let (symbol, relation) = if e.op == BinaryOp::Equal {
        ("==", "<")
    } else {
        ("!=", ">=")
    };
    let distance = if program.ty(e.left).is_vector() {
        "distance"
    } else {
        "abs"
    };
    let instead = match distance {
        "abs" => format!("abs({left} - {right}) {relation} 1e-4"),
        _ => format!("distance({left}, {right}) {relation} 1e-4"),
    };
    cx.report_expr(
        e.id,
        format!("`{symbol}` on floats is almost never what is meant"),
    )
    .note("rounding makes two results differ that should be equal")
    .help(format!("compare with a tolerance: `{instead}`"));
}

/// Whether an expression yields whole numbers, or is a literal, which was put there to be found
/// again.
fn is_whole(cx: &Context, id: ExprId) -> bool {
    let program = cx.program;
    let id = program.tree.unparen(id);
    match program.tree.expr(id).kind {
        ExprKind::Call(..) => program
            .builtin_called(id)
            .is_some_and(|name| WHOLE.contains(&name)),
        ExprKind::Unary(_, inner) => is_whole(cx, inner),
        _ => {
            program.expr(id).is_const
                && program
                    .values(id)
                    .iter()
                    .all(|v| v.as_float().fract() == 0.0)
        }
    }
}
