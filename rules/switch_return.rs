//! `return` inside `switch`.

use shaderlint_lint::prelude::*;

rule! { switch_return, Portability, Info, Strict, Stmt(check) }

fn check(cx: &mut Context, stmt: StmtId) {
    let program = cx.program;
    let tree = &program.tree;
    let node = tree.stmt(stmt);
    let StmtKind::Switch { body, .. } = node.kind else {
        return;
    };
    let mut todo = tree.block(body).to_vec();
    let mut first: Option<StmtId> = None;
    while let Some(next) = todo.pop() {
        match tree.stmt(next).kind {
            StmtKind::Return(_) => first = Some(first.map_or(next, |f| f.min(next))),
            // An inner `switch` is checked on its own.
            StmtKind::Switch { .. } => {}
            _ => each_inner(tree, tree.stmt(next), |s| todo.push(s)),
        }
    }
    let Some(first) = first else {
        return;
    };
    let leaves = program.span(tree.stmt(first).extent);
    cx.report(
        Extent::token(node.extent.first),
        "`return` inside `switch`",
    )
    .label(leaves, "returns from the function")
    .note("some HLSL compilers dropped such a `return`, or reported an unset return value")
    .help("assign to a variable, `break`, and return it after the `switch`; or use `if` and `else`");
}
