//! Comparisons where the ranges of both sides decide the result.

use shaderlint_flow::ranges::Rounding;
use shaderlint_lint::given::{depends_on_callers, is_exact, is_of_uniforms};
use shaderlint_lint::prelude::*;

rule! { known_comparison, Numeric, Warning, Recommended, Binary(check) }

fn check(cx: &mut Context, e: &BinaryExpr) {
    use BinaryOp::{Greater, GreaterEqual, Less, LessEqual};
    let program = cx.program;
    let is_order = matches!(e.op, Less | Greater | LessEqual | GreaterEqual);
    let kind = program.ty(e.left).scalar_kind();
    // `constant-condition` reports that a `uint` is never negative.
    if !is_order || kind == Some(Scalar::Uint) || program.expr(e.id).is_const {
        return;
    }
    if !cx.is_direct(e.id) {
        return;
    }
    let (left, right) = (
        cx.facts.range(e.left).next(),
        cx.facts.range(e.right).next(),
    );
    let (Some(left), Some(right)) = (left, right) else {
        return;
    };
    // A comparison of two constants is a switch.
    if left.single().is_some() && right.single().is_some() {
        return;
    }
    let [a, b] =
        [(left, e.left), (right, e.right)].map(|(range, expr)| ComparedSide { range, expr });
    let answer = match e.op {
        Less => is_less(cx, a, b),
        Greater => is_less(cx, b, a),
        LessEqual => is_less(cx, b, a).map(|a| !a),
        _ => is_less(cx, a, b).map(|a| !a),
    };
    let Some(answer) = answer else {
        return;
    };
    let (spelled, range, place) = match right.single() {
        Some(_) => (program.expr_text(e.left), left, e.left),
        None => (program.expr_text(e.right), right, e.right),
    };
    // A condition that always holds is often the last of several cases, written out.
    let tree = &program.tree;
    let is_written_here = !matches!(
        tree.expr(tree.unparen(place)).kind,
        ExprKind::Name(_) | ExprKind::Member(..) | ExprKind::Index(..)
    );
    let decided = decided(cx, e.id, answer);
    let is_open = decided.is_none_or(|truth| truth && !is_written_here);
    if is_open || is_spoken_of_twice(cx, e.id, place) || !is_computed_here(cx, e) {
        return;
    }
    let known = match kind {
        Some(Scalar::Float) => range.to_string(),
        _ => range.of_integer(),
    };
    let text = format!("`{spelled}` is {known} here");
    let place = program.expr_span(place);
    cx.report_expr(e.id, format!("this comparison is always {answer}"))
        .label(place, text);
}

/// One side of a comparison.
#[derive(Clone, Copy)]
struct ComparedSide {
    range: Interval,
    expr: ExprId,
}

/// Whether `a` is always or never less than `b`; `None` if neither is certain.
fn is_less(cx: &Context, a: ComparedSide, b: ComparedSide) -> Option<bool> {
    // A rounded value may exceed its bounds slightly.
    let slack = |side: ComparedSide, is_low: bool| {
        let r = side.range;
        let is_sharp = r.rounding == Rounding::Never
            || r.single().is_some()
            || is_exact(cx.facts, cx.program, side.expr, is_low);
        match is_sharp {
            true => 0.0,
            false => 1e-4 * r.lo.value.abs().min(r.hi.value.abs()).max(1e-3),
        }
    };
    let (low, high) = (
        slack(a, false).max(slack(b, true)),
        slack(a, true).max(slack(b, false)),
    );
    if a.range.hi.value < b.range.lo.value - low {
        return Some(true);
    }
    (a.range.lo.value >= b.range.hi.value + high).then_some(false)
}

/// Whether a condition uses a variable in more than one comparison: one may decide the other, which
/// is a `contradiction`.
fn is_spoken_of_twice(cx: &Context, comparison: ExprId, place: ExprId) -> bool {
    let tree = &cx.program.tree;
    let structure = cx.facts.structure();
    let is_logical = |p: &ExprId| {
        let kind = tree.expr(*p).kind;
        matches!(kind, ExprKind::Binary(op, ..) if op.is_logical())
            || matches!(kind, ExprKind::Paren(_) | ExprKind::Unary(UnaryOp::Not, _))
    };
    let around = std::iter::successors(structure.parent(comparison), |p| structure.parent(*p));
    let Some(extent) = around.take_while(is_logical).last() else {
        return false;
    };
    let mut at = tree.unparen(place);
    while let ExprKind::Member(inner, _) | ExprKind::Index(inner, _) = tree.expr(at).kind {
        at = tree.unparen(inner);
    }
    let (extent, own) = (tree.expr(extent).extent, tree.expr(comparison).extent);
    cx.program.variable_of(at).is_some_and(|v| {
        let mut all = cx
            .facts
            .mentions()
            .all(v)
            .iter()
            .map(|e| tree.expr(*e).extent);
        all.any(|e| extent.contains(e) && !own.contains(e))
    })
}

/// Whether the compared values are computed in the same function: testing a uniform, or values from
/// callers and other functions, is a reasonable guard.
fn is_computed_here(cx: &Context, e: &BinaryExpr) -> bool {
    let program = cx.program;
    let is_plain = |side: ExprId| {
        let variable = program.variable_of(side).and_then(|v| program.variable(v));
        variable.is_some_and(|v| v.storage != Storage::Local)
    };
    let sides = [e.left, e.right];
    !sides
        .iter()
        .any(|s| is_plain(*s) || is_of_uniforms(program, *s))
        && !sides.iter().any(|s| depends_on_callers(cx.facts, *s))
}

/// The result of the whole condition that contains a comparison, if the comparison decides it: one
/// of several conditions joined by `&&` may well always hold.
fn decided(cx: &Context, expr: ExprId, answer: bool) -> Option<bool> {
    let tree = &cx.program.tree;
    let structure = cx.facts.structure();
    let mut at = expr;
    let mut answer = answer;
    while let Some(parent) = structure.parent(at) {
        match tree.expr(parent).kind {
            ExprKind::Paren(_) => {}
            ExprKind::Unary(UnaryOp::Not, _) => answer = !answer,
            ExprKind::Binary(BinaryOp::And, ..) if !answer => {}
            ExprKind::Binary(BinaryOp::Or, ..) if answer => {}
            ExprKind::Ternary(condition, ..) => return (condition == at).then_some(answer),
            _ => return None,
        }
        at = parent;
    }
    let stmt = structure.stmt_of(at).map(|s| tree.stmt(s).kind);
    let is_condition = matches!(stmt, Some(StmtKind::If { condition, .. }) if condition == at);
    is_condition.then_some(answer)
}
