//! Loops that run at most one iteration.

use shaderlint_lint::prelude::*;

rule! { single_turn_loop, Tidy, Warning, Recommended, Stmt(check) }

fn check(cx: &mut Context, id: StmtId) {
    let program = cx.program;
    let tree = &program.tree;
    // `while (true) { ... break; }` emulates a jump.
    let (condition, body) = match tree.stmt(id).kind {
        StmtKind::For {
            condition: Some(condition),
            body,
            ..
        }
        | StmtKind::While { condition, body } => match tree.stmt(condition).kind {
            StmtKind::Expr(condition) => (condition, body),
            _ => return,
        },
        _ => return,
    };
    let head = tree.stmt(id).extent.first;
    let is_direct = program.token(head).is_some_and(|t| t.is_direct());
    if !is_direct || !cx.facts.reach().ends(body) || program.scalar(condition).is_some() {
        return;
    }
    let Some(last) = leaving(cx, body) else {
        return;
    };
    let jump = match tree.stmt(last).kind {
        StmtKind::Break => "`break`",
        StmtKind::Return(_) => "`return`",
        _ => "`discard`",
    };
    let place = program.span(tree.stmt(last).extent);
    cx.report(Extent::token(head), "loop runs at most one iteration")
        .label(place, format!("{jump} ends the first iteration"));
}

/// The last statement that leaves the loop; `None` if a `continue` may start another iteration.
fn leaving(cx: &Context, body: StmtId) -> Option<StmtId> {
    let tree = &cx.program.tree;
    let mut todo = vec![body];
    let mut last = None;
    while let Some(id) = todo.pop() {
        let stmt = tree.stmt(id);
        match stmt.kind {
            StmtKind::Continue => return None,
            StmtKind::Break | StmtKind::Return(_) | StmtKind::Discard => last = last.max(Some(id)),
            // Jumps of an inner loop end the inner loop only.
            StmtKind::For { .. } | StmtKind::While { .. } | StmtKind::Do { .. } => {}
            StmtKind::Switch { .. } => return None,
            _ => each_inner(tree, stmt, |inner| todo.push(inner)),
        }
    }
    last
}
