//! `x = x`, and `y = x; x = y`.

use shaderlint_lint::prelude::*;

rule! {
    self_assignment, Tidy, Warning, Recommended,
    Expr(&[Shape::Assign], check_assignment), Stmt(check_copies)
}

fn check_copies(cx: &mut Context, id: StmtId) {
    let tree = &cx.program.tree;
    if let StmtKind::Block(body) = tree.stmt(id).kind {
        for pair in tree.block(body).windows(2) {
            if let [first, second] = *pair {
                check_copy(cx, first, second);
            }
        }
    }
}

fn check_assignment(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    let tree = &program.tree;
    let ExprKind::Assign(None, target, value) = tree.expr(id).kind else {
        return;
    };
    let extent = tree.expr(id).extent;
    let [left, right] = [target, tree.unparen(value)].map(|e| tree.expr(e).extent);
    if !same_code(program, left, right)
        || !program.is_direct(extent)
        || cx.facts.effects().has(target)
        || is_case(cx, id)
    {
        return;
    }
    let text = program.sources.text(program.span(left));
    let fix = removal(cx, id);
    cx.report(extent, format!("`{text}` is assigned to itself"))
        .fix(fix);
}

/// Whether an assignment is the only statement of a branch that has an `else`: it states that
/// nothing changes in this case.
fn is_case(cx: &Context, id: ExprId) -> bool {
    let tree = &cx.program.tree;
    let structure = cx.facts.structure();
    let Some(stmt) = structure.stmt_of(id) else {
        return false;
    };
    let mut at = stmt;
    while let Some(outer) = structure.outer(at) {
        match tree.stmt(outer).kind {
            StmtKind::Block(list) if tree.block(list).len() == 1 => at = outer,
            StmtKind::If { otherwise, .. } => return otherwise.is_some(),
            _ => return false,
        }
    }
    false
}

/// Checks for two statements where the second copies a value back to where it came from.
fn check_copy(cx: &mut Context, first: StmtId, second: StmtId) {
    let program = cx.program;
    let Some((copy, from)) = copied(cx, first) else {
        return;
    };
    let Some((to, back)) = copied(cx, second) else {
        return;
    };
    let extent = program.tree.stmt(second).extent;
    if (to, back) != (from, copy) || !program.is_direct(extent) {
        return;
    }
    let name = |id| {
        program
            .variable(id)
            .map_or("", |v| program.names.text(v.name))
    };
    let (to, copy) = (name(to), name(copy));
    let before = program.span(program.tree.stmt(first).extent);
    cx.report(extent, format!("`{to}` is assigned its own value"))
        .label(before, format!("`{copy}` is copied from `{to}`"));
}

/// The variables of `to = from;` or `float to = from;`.
fn copied(cx: &Context, stmt: StmtId) -> Option<(VariableId, VariableId)> {
    let program = cx.program;
    let tree = &program.tree;
    match tree.stmt(stmt).kind {
        StmtKind::Expr(root) => match tree.expr(root).kind {
            ExprKind::Assign(None, to, from) => {
                Some((program.variable_of(to)?, program.variable_of(from)?))
            }
            _ => None,
        },
        StmtKind::Decl(decl) => match tree.decl(decl)?.kind {
            DeclKind::Variables { declarators, .. } => {
                let &[only] = tree.declarators(declarators) else {
                    return None;
                };
                let to = *program.declared.get(declarators.start as usize)?;
                Some((to?, program.variable_of(only.init?)?))
            }
            _ => None,
        },
        _ => None,
    }
}

fn removal(cx: &Context, id: ExprId) -> Option<Fix> {
    let structure = cx.facts.structure();
    let stmt = structure.stmt_of(id)?;
    let is_all = cx.program.tree.stmt(stmt).kind == StmtKind::Expr(id);
    without_statement(cx.program, structure, stmt).filter(|_| is_all)
}
