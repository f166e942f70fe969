//! `if (hit) MACRO;` where the macro expands to more than one statement.

use shaderlint_lint::expansion::{Expanded, expanded};
use shaderlint_lint::prelude::*;

rule! { macro_statements, Tidy, Warning, Recommended, Program(check) }

fn check(cx: &mut Context) {
    let program = cx.program;
    let has_more = |m: &shaderlint_syntax::Macro| {
        m.uses > 0 && m.body.iter().any(|p| p.token.kind == TokenKind::Semicolon)
    };
    if !program.tokens.macros.iter().any(has_more) {
        return;
    }
    let calls = expanded(program);
    for stmt in &program.tree.stmts {
        let (what, body) = match stmt.kind {
            StmtKind::If {
                otherwise: Some(body),
                ..
            } => ("else", body),
            StmtKind::If { then, .. } => ("if", then),
            StmtKind::For { body, .. } => ("for", body),
            StmtKind::While { body, .. } => ("while", body),
            _ => continue,
        };
        check_body(cx, &calls, stmt.extent.first, what, body);
    }
}

fn check_body(cx: &mut Context, calls: &[Expanded], head: TokenId, what: &str, body: StmtId) {
    let program = cx.program;
    let extent = program.tree.stmt(body).extent;
    let at = calls.partition_point(|c| c.extent.last < extent.last);
    let Some(call) = calls.get(at).filter(|c| c.extent.contains(extent)) else {
        return;
    };
    let goes_on = extent.last < call.extent.last;
    let next = program.token(extent.last + 1).map(|t| t.kind);
    let is_outside = !call.extent.contains(Extent::token(head));
    // Whether more statements of the same expansion follow; a lone `;` is not one.
    let is_more = match next {
        Some(TokenKind::Semicolon) => extent.last + 1 < call.extent.last,
        Some(TokenKind::RightBrace | TokenKind::Else) | None => false,
        Some(_) => true,
    };
    if !is_outside || !goes_on || !is_more {
        return;
    }
    let Some(definition) = program.tokens.macros.get(call.definition) else {
        return;
    };
    let name = program.names.text(definition.name);
    let place = definition.name_span;
    let message = format!("`{what}` applies only to the first statement of macro `{name}`");
    cx.report_span(call.call, message)
        .label(place, "expands to several statements")
        .help("add braces around the macro call");
}
