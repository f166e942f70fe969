//! Nested loops that use the same counter.

use shaderlint_lint::prelude::*;

rule! { shared_counter, Tidy, Warning, Recommended, Stmt(check) }

fn check(cx: &mut Context, id: StmtId) {
    let program = cx.program;
    let tree = &program.tree;
    let Some((counter, place)) = counted(program, id) else {
        return;
    };
    let outer = cx.facts.structure().outwards(id).skip(1).find(|s| {
        let is_in_body = match tree.stmt(*s).kind {
            StmtKind::For { body, .. } => tree.stmt(body).extent.contains(tree.stmt(id).extent),
            _ => false,
        };
        is_in_body && counted(program, *s).is_some_and(|(other, _)| other == counter)
    });
    let Some((_, around)) = outer.and_then(|s| counted(program, s)) else {
        return;
    };
    let is_direct = program.is_direct(tree.expr(place).extent);
    if !is_direct {
        return;
    }
    let name = program.variable(counter).map(|v| v.name);
    let name = name.map_or("", |n| program.names.text(n));
    let message = format!("nested loops use the same counter `{name}`");
    let around = program.expr_span(around);
    cx.report_expr(place, message)
        .mark("changed by the inner loop")
        .label(around, "the outer loop continues from there")
        .help("use a separate counter for the inner loop");
}

/// The variable that the step of a `for` loop changes, and the step.
fn counted(program: &Program, id: StmtId) -> Option<(VariableId, ExprId)> {
    let tree = &program.tree;
    let StmtKind::For {
        step: Some(step), ..
    } = tree.stmt(id).kind
    else {
        return None;
    };
    let target = match tree.expr(step).kind {
        ExprKind::Assign(_, target, _) | ExprKind::Postfix(_, target) => target,
        ExprKind::Unary(op, target) if op.assigns() => target,
        _ => return None,
    };
    Some((program.variable_of(target)?, step))
}
