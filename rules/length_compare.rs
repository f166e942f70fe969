//! `length(p) < r`: a square root that the comparison does not need.

use shaderlint_lint::prelude::*;

rule! { length_compare, Budget, Info, Performance, Binary(check) }

fn check(cx: &mut Context, e: &BinaryExpr) {
    use BinaryOp::{Greater, GreaterEqual, Less, LessEqual};
    let program = cx.program;
    let tree = &program.tree;
    if !matches!(e.op, Less | LessEqual | Greater | GreaterEqual) || program.expr(e.id).is_const {
        return;
    }
    let sides = [(e.left, e.right), (e.right, e.left)];
    for (measured, bound) in sides {
        let ExprKind::Call(_, args) = tree.expr(tree.unparen(measured)).kind else {
            continue;
        };
        let call = program.builtin_called(tree.unparen(measured));
        let bound = program.scalar(bound).map(|v| v.as_float());
        let Some(bound) = bound.filter(|b| *b >= 0.0 && b.is_finite()) else {
            continue;
        };
        let square = match (call, tree.args(args)) {
            (Some(BuiltinId::Length), &[v]) if program.ty(v).is_vector() => {
                let v = program.expr_text(v);
                format!("dot({v}, {v})")
            }
            (Some(BuiltinId::Distance), &[a, b]) if program.ty(a).is_vector() => {
                let (a, b) = (program.expr_text(a), program.expr_text(b));
                format!("dot({a} - {b}, {a} - {b})")
            }
            _ => continue,
        };
        cx.report_expr(
            e.id,
            "unnecessary square root in a comparison with a constant",
        )
        .help(format!(
            "compare `{square}` with `{:?}` instead",
            bound * bound
        ));
        return;
    }
}
