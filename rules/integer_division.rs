//! Integer divisions that discard the fractional part unintentionally.

use shaderlint_lint::prelude::*;

rule! { integer_division, Numeric, Warning, Recommended, Binary(check) }

fn check(cx: &mut Context, e: &BinaryExpr) {
    let program = cx.program;
    let kind = program.ty(e.id).scalar_kind();
    if e.op != BinaryOp::Div
        || !kind.is_some_and(Scalar::is_integer)
        || !program.ty(e.id).is_scalar()
    {
        return;
    }
    // The quotient is a scalar, so both operands are.
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
            let integer = (x / y).trunc();
            let is_float = becomes_float(cx, e.id);
            // A named size is divided into whole cells.
            let is_meant = !literals && integer != 0.0;
            if is_meant || !(is_float || integer == 0.0 && literals) {
                return;
            }
            (
                format!("integer division `{x} / {y}` is {integer}"),
                is_float,
            )
        }
        // `i / n` with `i` from 0 to `n - 1`.
        (None, _) if a.lo.value >= 0.0 && a.is_finite() && b.lo.value > a.hi.value => {
            if !becomes_float(cx, e.id) {
                return;
            }
            let (a, b) = (a.of_integer(), b.of_integer());
            (
                format!("this integer division is always 0: {a} divided by {b}"),
                true,
            )
        }
        _ => return,
    };
    let fix = (is_float && literals && cx.is_direct(e.id)).then(|| {
        let write = |e, value: f64| Edit::replace(program.expr_span(e), format!("{value:?}"));
        let (x, y) = (a.single(), b.single());
        let edits = [(e.left, x), (e.right, y)].into_iter();
        let edits = edits
            .filter_map(|(e, value)| Some(write(e, value?)))
            .collect();
        Fix::suggestion("use float literals", edits)
    });
    cx.report_expr(e.id, message)
        .note("integer division discards the fractional part")
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
