//! `if (x); { ... }`: a semicolon that is the entire body.

use shaderlint_lint::indent::{indent, line_indent};
use shaderlint_lint::prelude::*;

rule! { empty_body, Tidy, Warning, Recommended, Stmt(check) }

fn check(cx: &mut Context, id: StmtId) {
    let tree = &cx.program.tree;
    let StmtKind::Block(body) = tree.stmt(id).kind else {
        return;
    };
    let body = tree.block(body);
    for (at, &stmt) in body.iter().enumerate() {
        let (what, empty) = match headed(tree, stmt) {
            Some(found) => found,
            None => continue,
        };
        let is_direct = cx.program.is_direct(tree.stmt(empty).extent);
        let next = body.get(at + 1).copied();
        let next = next.filter(|n| is_meant(cx, stmt, empty, *n));
        // The body of a loop may be empty if its head does the work; that of an `if` may not.
        if is_direct && (next.is_some() || what == "if") {
            report(cx, what, empty, next);
        }
    }
}

/// The keyword before an empty body at the end of a statement, and that body.
fn headed(tree: &Tree, stmt: StmtId) -> Option<(&'static str, StmtId)> {
    let is_empty = |s: &StmtId| tree.stmt(*s).kind == StmtKind::Empty;
    let (what, body) = match tree.stmt(stmt).kind {
        StmtKind::If {
            then,
            otherwise: None,
            ..
        } => ("if", then),
        StmtKind::If {
            otherwise: Some(otherwise),
            ..
        } => match tree.stmt(otherwise).kind {
            StmtKind::If { .. } => return headed(tree, otherwise),
            _ => ("else", otherwise),
        },
        StmtKind::For { body, .. } => ("for", body),
        StmtKind::While { body, .. } => ("while", body),
        _ => return None,
    };
    Some((what, body)).filter(|(_, body)| is_empty(body))
}

/// Whether the statement after an empty body looks like the body: a block, or a statement that is
/// indented more than the head.
fn is_meant(cx: &Context, head: StmtId, empty: StmtId, next: StmtId) -> bool {
    let program = cx.program;
    let tree = &program.tree;
    let is_block = matches!(tree.stmt(next).kind, StmtKind::Block(_));
    let first = |stmt: StmtId| tree.stmt(stmt).extent.first;
    let is_further_in = || {
        let (head, next) = (
            line_indent(program, first(head))?,
            indent(program, first(next))?,
        );
        let empty = line_indent(program, first(empty))?;
        Some(next.line == empty.line + 1 && next.is_deeper_than(&head))
    };
    is_block || is_further_in() == Some(true)
}

fn report(cx: &mut Context, what: &str, empty: StmtId, next: Option<StmtId>) {
    let program = cx.program;
    let tree = &program.tree;
    let span = program.span(tree.stmt(empty).extent);
    let next = next.map(|n| program.span(Extent::token(tree.stmt(n).extent.first)));
    let fix = next.map(|_| Fix::suggestion("remove the `;`", vec![Edit::delete(span)]));
    let message = format!("this `;` is the entire body of the `{what}`");
    cx.report_span(span, message)
        .label(next, format!("not part of the `{what}`"))
        .fix(fix);
}
