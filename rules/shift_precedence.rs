//! Sums next to a shift without parentheses: `1 << n - 1`.

use shaderlint_lint::prelude::*;

rule! { shift_precedence, Tidy, Warning, Recommended, Binary(check) }

fn check(cx: &mut Context, e: &BinaryExpr) {
    let program = cx.program;
    let tree = &program.tree;
    if !matches!(e.op, BinaryOp::ShiftLeft | BinaryOp::ShiftRight) || !cx.is_direct(e.id) {
        return;
    }
    let sum = |side: ExprId| match tree.expr(side).kind {
        ExprKind::Binary(op @ (BinaryOp::Add | BinaryOp::Sub), left, _) => Some((op, left)),
        _ => None,
    };
    for side in [e.left, e.right] {
        let Some((op, left)) = sum(side) else {
            continue;
        };
        // `1 << n-1`: the spacing shows that the sum is intended.
        let inner = gap(cx, left);
        let outer = gap(cx, e.left);
        if inner.is_none() || outer.is_none() || inner < outer {
            continue;
        }
        let span = program.expr_span(side);
        let edits = vec![Edit::insert(span.start, "("), Edit::insert(span.end, ")")];
        let symbol = op.symbol();
        let shift = e.op.symbol();
        cx.report_expr(
            side,
            format!("`{symbol}` has higher precedence than `{shift}`"),
        )
        .mark("evaluated first")
        .help("add parentheses around the shift if it should be evaluated first")
        .fix(Fix::safe("add parentheses around the sum", edits));
    }
}

/// Number of blanks between an operand and the operator after it.
fn gap(cx: &Context, operand: ExprId) -> Option<u32> {
    let program = cx.program;
    let last = program.tree.expr(operand).extent.last;
    let operator = program.token(last + 1)?;
    let between = Span::new(program.token(last)?.span.end, operator.span.start);
    Some(between.len())
}
