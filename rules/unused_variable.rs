//! Variables that are never read.

use shaderlint_lint::prelude::*;
use shaderlint_lint::remove_declaration;

rule! { unused_variable, Tidy, Info, Recommended, Declaration(check) }

fn check(cx: &mut Context, declared: &DeclaredVariable) {
    let program = cx.program;
    if !is_unused(cx, declared) {
        return;
    }
    let Some(variable) = program.variable(declared.variable) else {
        return;
    };
    let Some(token) = variable.token else { return };
    let name = program.names.text(variable.name);
    let writes: Vec<ExprId> = cx.facts.writes().idle(declared.variable).to_vec();
    let fix = removal(cx, declared, &writes)
        .map(|edits| Fix::suggestion(format!("remove `{name}`"), edits));
    let message = match writes.first() {
        None => format!("variable `{name}` is never used"),
        Some(_) => format!("variable `{name}` is assigned but never read"),
    };
    let mut finding = cx.report(Extent::token(token), message);
    if let Some(&written) = writes.first() {
        finding = finding.label(program.expr_span(written), "this value is never read");
    }
    finding.fix(fix);
}

fn is_unused(cx: &Context, declared: &DeclaredVariable) -> bool {
    let program = cx.program;
    let Some(variable) = program.variable(declared.variable) else {
        return false;
    };
    let name = program.names.text(variable.name);
    // A global in an earlier file, such as Common, may be used by another pass.
    let is_own = || {
        let own = cx.facts.own_file();
        own.is_some_and(|own| own.contains(program.span(declared.extent)))
    };
    matches!(variable.storage, Storage::Local | Storage::Global)
        && !name.starts_with('_')
        && !cx.facts.writes().is_read(declared.variable)
        && variable
            .token
            .is_some_and(|t| program.is_direct(Extent::token(t)))
        && !cx.facts.inactive_words().has(name)
        && (declared.stmt.is_some() || is_own())
}

/// The edits that remove a variable and its assignments; `None` if that would remove other code.
fn removal(cx: &Context, declared: &DeclaredVariable, writes: &[ExprId]) -> Option<Vec<Edit>> {
    let program = cx.program;
    let tree = &program.tree;
    let effects = cx.facts.effects();
    let init = declared.declarator()?.init;
    // The declaration would take a struct with it.
    let declares_type = matches!(tree.ty(declared.ty).base, TypeBase::Struct(_));
    if init.is_some_and(|e| effects.has(e)) || declares_type {
        return None;
    }
    let is_alone = declared.declarators.len() == 1;
    if is_alone && declared.stmt.is_some_and(|s| !is_in_block(cx, s)) {
        return None;
    }
    let mut edits = vec![remove_declaration(program, declared)?];
    for &write in writes {
        let (target, value) = match tree.expr(write).kind {
            ExprKind::Assign(_, target, value) => (target, Some(value)),
            ExprKind::Unary(_, target) | ExprKind::Postfix(_, target) => (target, None),
            _ => return None,
        };
        let stmt = cx.facts.structure().stmt_of(write)?;
        let is_all = tree.stmt(stmt).kind == StmtKind::Expr(write);
        let has_more = effects.has(target) || value.is_some_and(|v| effects.has(v));
        if !is_all || has_more || !is_in_block(cx, stmt) {
            return None;
        }
        edits.push(remove_statement(program, tree.stmt(stmt).extent)?);
    }
    Some(edits)
}

/// Whether a statement is directly in a block, so that it can be removed.
fn is_in_block(cx: &Context, stmt: StmtId) -> bool {
    let outer = cx.facts.structure().outer(stmt);
    outer.is_some_and(|o| matches!(cx.program.tree.stmt(o).kind, StmtKind::Block(_)))
}
