//! `if (a = b)`.

use shaderlint_lint::prelude::*;

rule! { assignment_in_condition, Tidy, Warning, Recommended, Stmt(check) }

fn check(cx: &mut Context, id: StmtId) {
    let program = cx.program;
    let tree = &program.tree;
    let condition = match tree.stmt(id).kind {
        StmtKind::If { condition, .. } | StmtKind::Do { condition, .. } => condition,
        StmtKind::While { condition, .. }
        | StmtKind::For {
            condition: Some(condition),
            ..
        } => match tree.stmt(condition).kind {
            StmtKind::Expr(condition) => condition,
            _ => return,
        },
        _ => return,
    };
    // A second pair of parentheses marks an intended assignment.
    let ExprKind::Assign(None, target, value) = tree.expr(condition).kind else {
        return;
    };
    // The value of a comparison or computation is an intended assignment:
    // `if (hit = distance < 0.1)`.
    if !matches!(
        tree.expr(tree.unparen(value)).kind,
        ExprKind::Name(_) | ExprKind::Member(..) | ExprKind::Index(..) | ExprKind::Bool(_)
    ) {
        return;
    }
    let Some(operator) = program.token(tree.expr(target).extent.last + 1) else {
        return;
    };
    let fix = operator.is_direct().then(|| {
        Fix::suggestion(
            "replace `=` with `==`",
            vec![Edit::replace(operator.span, "==")],
        )
    });
    let text = program.expr_text(target);
    cx.report_expr(
        condition,
        format!("this condition assigns to `{text}` instead of comparing it"),
    )
    .help("if the assignment is intended, wrap it in a second pair of parentheses")
    .fix(fix);
}
