//! Subtractions of unsigned integers that underflow.

use shaderlint_lint::prelude::*;

rule! { unsigned_underflow, Numeric, Warning, Recommended, Binary(check) }

fn check(cx: &mut Context, e: &BinaryExpr) {
    let program = cx.program;
    let is_unsigned = program.ty(e.id).scalar_kind() == Some(Scalar::Uint);
    if e.op != BinaryOp::Sub || !is_unsigned || program.expr(e.id).is_const || wraps(cx, e.id) {
        return;
    }
    let sides = cx.facts.range(e.left).zip(cx.facts.range(e.right));
    let below = sides.map(|(a, b)| a - b).find(|r| r.reaches_below(0.0));
    let Some(range) = below else { return };
    let is = range.may_or_is(|r| r.is_below(0.0));
    let known = range.of_integer();
    cx.report_expr(e.id, format!("unsigned difference {is} negative: {known}"))
        .note("`uint` arithmetic wraps around: `0u - 1u` is `4294967295u`")
        .help("compute it as `int`, or compare the operands first");
}

/// Whether wrapping may be intended: the value is used as bits, as in hashes, or in more arithmetic.
fn wraps(cx: &Context, mut expr: ExprId) -> bool {
    let structure = cx.facts.structure();
    while let Some(parent) = structure.parent(expr) {
        match cx.program.tree.expr(parent).kind {
            ExprKind::Paren(_) => expr = parent,
            ExprKind::Binary(op, ..) | ExprKind::Assign(Some(op), ..) => {
                use BinaryOp::{Add, BitAnd, BitOr, BitXor, Mul, ShiftLeft, ShiftRight, Sub};
                return matches!(
                    op,
                    Add | Sub | Mul | BitAnd | BitOr | BitXor | ShiftLeft | ShiftRight
                );
            }
            _ => return false,
        }
    }
    false
}
