//! Identical branches, and conditions that are tested twice.

use rustc_hash::FxHashMap;
use shaderlint_lint::code_hash;
use shaderlint_lint::prelude::*;

rule! {
    duplicate_branch, Tidy, Warning, Recommended,
    Stmt(check_if), Expr(&[Shape::Ternary], check_ternary)
}

fn check_if(cx: &mut Context, id: StmtId) {
    let program = cx.program;
    let tree = &program.tree;
    let StmtKind::If {
        then,
        otherwise: Some(otherwise),
        ..
    } = tree.stmt(id).kind
    else {
        return;
    };
    let bodies = [then, otherwise].map(|s| tree.stmt(s).extent);
    let is_empty = bodies.iter().any(|b| b.last - b.first < 2);
    // Two rows of a table may be equal.
    let is_row = || is_else(cx, id) && gives_constant(cx, then) && gives_constant(cx, otherwise);
    if !is_empty && !is_row() && same_code(program, bodies[0], bodies[1]) {
        let first = program.span(bodies[0]);
        cx.report(bodies[1], "both branches of this `if` are identical")
            .label(first, "identical branch");
    }
    let is_chain = matches!(tree.stmt(otherwise).kind, StmtKind::If { .. });
    if is_chain && !is_else(cx, id) {
        check_chain(cx, id);
    }
}

fn check_ternary(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    let tree = &program.tree;
    let ExprKind::Ternary(_, a, b) = tree.expr(id).kind else {
        return;
    };
    let [first, second] = [a, b].map(|e| tree.expr(e).extent);
    if cx.is_direct(id) && same_code(program, first, second) {
        cx.report(second, "both results of this `?:` are identical")
            .label(program.span(first), "identical result");
    }
}

/// Whether a body only returns or assigns one constant.
fn gives_constant(cx: &Context, body: StmtId) -> bool {
    let (program, tree) = (cx.program, &cx.program.tree);
    let is_constant = |e| !program.values(e).is_empty();
    match tree.stmt(body).kind {
        StmtKind::Block(list) => match tree.block(list) {
            &[only] => gives_constant(cx, only),
            _ => false,
        },
        StmtKind::Return(Some(value)) => is_constant(value),
        StmtKind::Expr(e) => match tree.expr(e).kind {
            ExprKind::Assign(None, _, value) => is_constant(value),
            _ => false,
        },
        _ => false,
    }
}

/// Whether a statement is the body of an `else`.
fn is_else(cx: &Context, id: StmtId) -> bool {
    let outer = cx.facts.structure().outer(id);
    outer.is_some_and(|o| {
        matches!(cx.program.tree.stmt(o).kind, StmtKind::If { otherwise, .. } if otherwise == Some(id))
    })
}

/// `if (a) ... else if (a) ...`: the second condition is never true.
fn check_chain(cx: &mut Context, start: StmtId) {
    let program = cx.program;
    let tree = &program.tree;
    let mut asked: FxHashMap<u64, Extent> = FxHashMap::default();
    let mut next = Some(start);
    while let Some(StmtKind::If {
        condition,
        otherwise,
        ..
    }) = next.map(|s| tree.stmt(s).kind)
    {
        next = otherwise;
        let extent = tree.expr(condition).extent;
        let hash = code_hash(program, extent);
        match asked.get(&hash) {
            // A condition with side effects may give another result the second time.
            Some(&before)
                if same_code(program, before, extent) && !cx.facts.effects().has(condition) =>
            {
                let before = program.span(before);
                cx.report(
                    extent,
                    "this condition was already tested, so it is always false here",
                )
                .label(before, "first tested here");
            }
            Some(_) => {}
            None => {
                asked.insert(hash, extent);
            }
        }
    }
}
