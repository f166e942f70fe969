//! A statement that is indented as if an `if` or loop controlled it, but follows it.

use shaderlint_lint::indent::{indent, line_indent};
use shaderlint_lint::prelude::*;

rule! { misleading_indentation, Tidy, Warning, Recommended, Stmt(check) }

fn check(cx: &mut Context, id: StmtId) {
    let tree = &cx.program.tree;
    let (StmtKind::Block(body) | StmtKind::Switch { body, .. }) = tree.stmt(id).kind else {
        return;
    };
    for pair in tree.block(body).windows(2) {
        if let &[stmt, next] = pair
            && let Some((what, last)) = last_body(tree, stmt)
            && is_misleading(cx, stmt, last, next) == Some(true)
        {
            let program = cx.program;
            let place = Extent::token(tree.stmt(stmt).extent.first);
            let next = tree.stmt(next).extent;
            let message = format!("statement is indented as if it belonged to the `{what}` above");
            let head = program.span(place);
            let end = program.span(Extent::token(tree.stmt(last).extent.last));
            cx.report(next, message)
                .label(head, "controls only one statement")
                .label(end, "its body ends here");
        }
    }
}

/// The last body of a statement, if it has no braces, and the keyword before it.
fn last_body(tree: &Tree, stmt: StmtId) -> Option<(&'static str, StmtId)> {
    let (what, body) = match tree.stmt(stmt).kind {
        StmtKind::If {
            otherwise: Some(otherwise),
            ..
        } => match tree.stmt(otherwise).kind {
            StmtKind::If { .. } => return last_body(tree, otherwise),
            _ => ("else", otherwise),
        },
        StmtKind::If { then, .. } => ("if", then),
        StmtKind::For { body, .. } => ("for", body),
        StmtKind::While { body, .. } => ("while", body),
        _ => return None,
    };
    // An empty body is a different mistake.
    let is_plain = !matches!(tree.stmt(body).kind, StmtKind::Block(_) | StmtKind::Empty);
    is_plain.then_some((what, body))
}

/// Whether `next` starts its line at the indentation of the body before it, and that is deeper than
/// the head.
fn is_misleading(cx: &Context, head: StmtId, body: StmtId, next: StmtId) -> Option<bool> {
    let program = cx.program;
    let first = |stmt: StmtId| program.tree.stmt(stmt).extent.first;
    let is_direct = |stmt| program.token(first(stmt)).is_some_and(|t| t.is_direct());
    let (body_at, next_at) = (indent(program, first(body))?, indent(program, first(next))?);
    let head_at = line_indent(program, first(head))?;
    // A stray `;` does nothing.
    let is_code = program.tree.stmt(next).kind != StmtKind::Empty;
    Some(
        is_code
            && is_direct(head)
            && is_direct(body)
            && is_direct(next)
            && body_at.blanks == next_at.blanks
            && body_at.is_deeper_than(&head_at),
    )
}
