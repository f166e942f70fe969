//! Numbers so close to another one, or so small, that rounding removes the difference.

use shaderlint_lint::prelude::*;

rule! {
    rounded_away, Numeric, Warning, Recommended,
    Expr(&[Shape::FloatLiteral], check_literal), Binary(check_sum)
}

/// Maximum length of a literal that is checked: a longer one was printed by a program, so that its
/// last digits mean nothing.
const WRITTEN: usize = 14;

/// Maximum length of a literal that cannot hold digits lost to rounding.
const SHORT: usize = 4;

/// `0.99999999` and `1e-46`.
fn check_literal(cx: &mut Context, id: ExprId) {
    let ExprKind::Float(value) = cx.program.tree.expr(id).kind else {
        return;
    };
    // Cheap test first: nearly all literals have a fraction and are not tiny, or are short.
    if value.fract() != 0.0 && !value.is_subnormal() {
        return;
    }
    let text = cx.program.expr_text(id);
    if text.len() <= SHORT {
        return;
    }
    let Ok(meant) = text.trim_end_matches(['f', 'F']).parse::<f64>() else {
        return;
    };
    if meant != 0.0 && (value == 0.0 || value.is_subnormal()) {
        let message = format!("`{text}` is too small for a `float` and becomes zero");
        cx.report_expr(id, message)
            .note("GPUs flush values below 1.2e-38 to zero")
            .help("use a larger number such as `1e-30`");
    } else if value.fract() == 0.0
        && meant.fract() != 0.0
        && value.abs() <= 65_536.0
        && text.len() <= WRITTEN
    {
        let message = format!("`{text}` is rounded to `{value:?}`");
        cx.report_expr(id, message)
            .note("a `float` has about seven significant digits");
    }
}

/// `1.0 - 1e-8`
fn check_sum(cx: &mut Context, e: &BinaryExpr) {
    let program = cx.program;
    let is_sum = matches!(e.op, BinaryOp::Add | BinaryOp::Sub);
    if !is_sum || program.ty(e.id).scalar_kind() != Some(Scalar::Float) {
        return;
    }
    let small = |side| {
        let value = program.scalar(side)?.as_float();
        // The difference of two settings is small by chance.
        if holds_sum(program, side) {
            return None;
        }
        (value != 0.0 && value.abs() < 1e-3).then_some(f64::from(value.abs()))
    };
    let sides = [(e.left, e.right), (e.right, e.left)];
    let lost = sides.into_iter().find_map(|(large, part)| {
        let part_size = small(part)?;
        let mut ranges = cx.facts.range(large).peekable();
        ranges.peek()?;
        // Half a unit in the last place may round up; a quarter is always lost.
        let is_lost = ranges.all(|r| {
            let least = r.lo.value.max(-r.hi.value);
            least.is_finite() && least > 0.0 && part_size < least * f64::from(f32::EPSILON) / 4.0
        });
        is_lost.then_some((large, part))
    });
    let Some((large, part)) = lost else { return };
    let (large, part) = (program.expr_text(large), program.expr_text(part));
    let message = format!("`{part}` is too small to change `{large}`");
    cx.report_expr(e.id, message)
        .note("a `float` has about seven significant digits")
        .help("use a larger number: next to 1.0, the smallest difference is about 1e-7");
}

/// Whether an expression adds or subtracts.
fn holds_sum(program: &Program, expr: ExprId) -> bool {
    let tree = &program.tree;
    let expr = tree.unparen(expr);
    match tree.expr(expr).kind {
        ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, ..) => true,
        ExprKind::Binary(_, a, b) => holds_sum(program, a) || holds_sum(program, b),
        ExprKind::Unary(_, of) => holds_sum(program, of),
        _ => false,
    }
}
