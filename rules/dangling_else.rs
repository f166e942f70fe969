//! An `else` that is aligned with one `if` but belongs to another.

use shaderlint_lint::indent::{indent, line_indent};
use shaderlint_lint::prelude::*;

rule! { dangling_else, Tidy, Warning, Recommended, Stmt(check) }

fn check(cx: &mut Context, id: StmtId) {
    let program = cx.program;
    let tree = &program.tree;
    let StmtKind::If {
        then,
        otherwise: None,
        ..
    } = tree.stmt(id).kind
    else {
        return;
    };
    // Descend through bodies without braces to the `if` that the `else` belongs to.
    let mut inner = then;
    let otherwise = loop {
        match tree.stmt(inner).kind {
            StmtKind::If {
                otherwise: Some(otherwise),
                ..
            } => break otherwise,
            StmtKind::For { body, .. } | StmtKind::While { body, .. } => inner = body,
            StmtKind::If { then, .. } => inner = then,
            _ => return,
        }
    };
    let word = tree.stmt(otherwise).extent.first.saturating_sub(1);
    let is_else = program
        .token(word)
        .is_some_and(|t| t.kind == TokenKind::Else);
    let first = |stmt: StmtId| tree.stmt(stmt).extent.first;
    let places = indent(program, word).zip(line_indent(program, first(id)));
    let (Some((at, outer)), Some(own)) = (places, indent(program, first(inner))) else {
        return;
    };
    let is_under_outer = at.blanks == outer.blanks && own.is_deeper_than(&outer);
    if !is_else || !is_under_outer || !program.is_direct(Extent::token(word)) {
        return;
    }
    let [near, far] = [inner, id].map(|s| program.span(Extent::token(first(s))));
    cx.report(
        Extent::token(word),
        "this `else` belongs to the inner `if`, not the one it is aligned with",
    )
    .label(near, "`else` belongs to this `if`")
    .label(far, "aligned with this `if`")
    .help("add braces around the inner `if`");
}
