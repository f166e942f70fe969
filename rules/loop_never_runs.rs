//! Loops whose condition is false from the start.

use shaderlint_lint::prelude::*;

rule! { loop_never_runs, Tidy, Warning, Recommended, Stmt(check) }

fn check(cx: &mut Context, id: StmtId) {
    let program = cx.program;
    let tree = &program.tree;
    let StmtKind::For {
        init,
        condition: Some(condition),
        ..
    } = tree.stmt(id).kind
    else {
        return;
    };
    let StmtKind::Expr(condition) = tree.stmt(condition).kind else {
        return;
    };
    let ExprKind::Binary(op, left, right) = tree.expr(condition).kind else {
        return;
    };
    let is_direct = program.is_direct(tree.stmt(init).extent) && cx.is_direct(condition);
    let Some((counter, start)) = started(program, init).filter(|_| is_direct) else {
        return;
    };
    let is_counter = program.variable_of(left) == Some(counter);
    let Some(limit) = literal(program, right).filter(|_| is_counter) else {
        return;
    };
    let runs = match op {
        BinaryOp::Less => start < limit,
        BinaryOp::LessEqual => start <= limit,
        BinaryOp::Greater => start > limit,
        BinaryOp::GreaterEqual => start >= limit,
        BinaryOp::Equal => start == limit,
        _ => start != limit,
    };
    // A loop from 0 to 0 was switched off on purpose.
    if runs || start == limit || !op.compares() {
        return;
    }
    let place = program.span(tree.stmt(init).extent);
    cx.report_expr(
        condition,
        "loop never runs: its condition is false from the start",
    )
    .label(place, "initial value");
}

/// The counter that the `for` header declares or assigns, and its initial value.
fn started(program: &Program, init: StmtId) -> Option<(shaderlint_semantic::VariableId, f64)> {
    let tree = &program.tree;
    match tree.stmt(init).kind {
        StmtKind::Decl(decl) => {
            let DeclKind::Variables { declarators, .. } = tree.decl(decl)?.kind else {
                return None;
            };
            let &[only] = tree.declarators(declarators) else {
                return None;
            };
            let counter = *program.declared.get(declarators.start as usize)?;
            Some((counter?, literal(program, only.init?)?))
        }
        StmtKind::Expr(e) => match tree.expr(e).kind {
            ExprKind::Assign(None, target, value) => {
                Some((program.variable_of(target)?, literal(program, value)?))
            }
            _ => None,
        },
        _ => None,
    }
}

/// The value of a literal; a named constant may be a switch and does not count.
fn literal(program: &Program, expr: ExprId) -> Option<f64> {
    let tree = &program.tree;
    let at = tree.unparen(expr);
    match tree.expr(at).kind {
        ExprKind::Int(_) | ExprKind::Uint(_) | ExprKind::Float(_) => {}
        ExprKind::Unary(UnaryOp::Minus, inner) => return Some(-literal(program, inner)?),
        _ => return None,
    }
    program.scalar(at).map(Value::as_number)
}
