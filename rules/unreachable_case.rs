//! `case` labels outside the range of the selector.

use shaderlint_lint::given::is_computed_here;
use shaderlint_lint::prelude::*;

rule! { unreachable_case, Numeric, Warning, Recommended, Stmt(check) }

fn check(cx: &mut Context, id: StmtId) {
    let program = cx.program;
    let tree = &program.tree;
    let StmtKind::Switch { selector, body } = tree.stmt(id).kind else {
        return;
    };
    if program.expr(selector).is_const || !is_computed_here(program, cx.facts, selector) {
        return;
    }
    let Some(range) = cx.facts.range(selector).next() else {
        return;
    };
    if range.is_any() || range.single().is_some() {
        return;
    }
    let place = program.expr_span(selector);
    let known = format!("selector range: {}", range.of_integer());
    for &stmt in tree.block(body) {
        let StmtKind::Case(label) = tree.stmt(stmt).kind else {
            continue;
        };
        let value = match program.scalar(label) {
            Some(Value::Int(v)) => v as f64,
            Some(Value::Uint(v)) => v as f64,
            _ => continue,
        };
        if !range.contains(value) {
            let message = format!("`case {}` is never reached", program.expr_text(label));
            cx.report(tree.stmt(stmt).extent, message)
                .label(place, known.clone());
        }
    }
}
