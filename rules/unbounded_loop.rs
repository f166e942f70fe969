//! Loops that nothing ends for certain.

use crate::diagnostic::Severity;
use crate::lint::{Check, Context, Group, Rule};
use crate::syntax::ast::{ExprKind, Extent, StmtId, StmtKind};

pub static RULE: Rule = Rule {
    name: "unbounded-loop",
    group: Group::Budget,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("unbounded_loop.md"),
    check: Check::Stmt(check),
};

fn check(cx: &mut Context, stmt: StmtId) {
    let tree = &cx.program.tree;
    let node = tree.stmt(stmt);
    if !matches!(
        node.kind,
        StmtKind::For { .. } | StmtKind::While { .. } | StmtKind::Do { .. }
    ) {
        return;
    }
    let is_open = cx.facts.loops().get(stmt).is_some_and(|l| {
        let is_plain = l.turns.is_none() && !l.is_counted;
        is_plain && l.counter.is_none()
    });
    if is_open && !counts_part(cx, stmt) {
        cx.report(
            Extent::token(node.extent.first),
            "nothing ends this loop for certain",
        )
        .note("where its condition never comes true the GPU hangs, and the browser ends the page's graphics")
        .help("count the turns too: `for (int i = 0; i < 256; i++)`, with the condition as a `break`");
    }
}

/// Whether a `for` counts in a part of a variable: `for (p.x = 0; p.x < 3; p.x++)`.
fn counts_part(cx: &Context, stmt: StmtId) -> bool {
    let tree = &cx.program.tree;
    let StmtKind::For {
        condition: Some(_),
        step: Some(step),
        ..
    } = tree.stmt(stmt).kind
    else {
        return false;
    };
    let counted = match tree.expr(tree.unparen(step)).kind {
        ExprKind::Postfix(_, e) | ExprKind::Unary(_, e) | ExprKind::Assign(Some(_), e, _) => e,
        _ => return false,
    };
    matches!(
        tree.expr(tree.unparen(counted)).kind,
        ExprKind::Member(..) | ExprKind::Index(..)
    )
}
