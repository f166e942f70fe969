//! Loops without an upper bound on their iterations.

use shaderlint_flow::Bound;
use shaderlint_lint::prelude::*;

rule! { unbounded_loop, Budget, Warning, Recommended, Stmt(check) }

fn check(cx: &mut Context, stmt: StmtId) {
    let tree = &cx.program.tree;
    let node = tree.stmt(stmt);
    if !node.kind.is_loop() {
        return;
    }
    let found = cx.facts.loops().get(stmt);
    if found.is_some_and(|l| l.bound == Bound::Open) {
        cx.report(
            Extent::token(node.extent.first),
            "loop has no upper bound on its iterations",
        )
        .note("if the exit condition is never met, the GPU hangs and the page loses its WebGL context")
        .help("limit the iterations with `for (int i = 0; i < 256; i++)`, and `break` on the condition");
    }
}
