//! Variables whose value nothing makes use of.

use crate::diagnostic::{Fix, Severity};
use crate::lint::{Check, Context, Group, Rule, remove_declarator, remove_statement};
use crate::semantic::{Storage, VariableId};
use crate::syntax::ast::*;
use crate::text::Edit;

pub static RULE: Rule = Rule {
    name: "unused-variable",
    group: Group::Tidy,
    severity: Severity::Info,
    default: true,
    options: &[],
    page: include_str!("unused_variable.md"),
    check: Check::Program(check),
};

/// One of the names of a declaration.
struct Declared {
    variable: VariableId,
    declarators: List,
    ty: TypeId,
    index: usize,
    /// All of the declaration.
    extent: Extent,
    /// The statement that it is; `None` at global scope.
    stmt: Option<StmtId>,
}

fn check(cx: &mut Context) {
    let program = cx.program;
    for (i, stmt) in program.tree.stmts.iter().enumerate() {
        if let StmtKind::Decl(decl) = stmt.kind {
            check_declaration(cx, decl, Some(StmtId(i as u32)));
        }
    }
    let Some(own) = cx.facts.own_file() else {
        return;
    };
    for item in &program.tree.items {
        let Item::Decl(decl) = *item else { continue };
        let extent = program.tree.decl(decl).map(|d| d.extent);
        if extent.is_some_and(|e| own.contains(program.span(e))) {
            check_declaration(cx, decl, None);
        }
    }
}

fn check_declaration(cx: &mut Context, decl: DeclId, stmt: Option<StmtId>) {
    let program = cx.program;
    let Some(decl) = program.tree.decl(decl) else {
        return;
    };
    let DeclKind::Variables {
        ty, declarators, ..
    } = decl.kind
    else {
        return;
    };
    for index in 0..declarators.len as usize {
        let at = declarators.start as usize + index;
        let Some(variable) = program.declared.get(at).copied().flatten() else {
            continue;
        };
        if is_unused(cx, variable) {
            let declared = Declared {
                variable,
                declarators,
                ty,
                index,
                extent: decl.extent,
                stmt,
            };
            report(cx, &declared);
        }
    }
}

fn is_unused(cx: &Context, id: VariableId) -> bool {
    let program = cx.program;
    let Some(variable) = program.variable(id) else {
        return false;
    };
    let name = program.names.text(variable.name);
    let is_direct = || {
        let token = variable.token.and_then(|t| program.token(t));
        token.is_some_and(|t| t.is_direct())
    };
    matches!(variable.storage, Storage::Local | Storage::Global)
        && !name.starts_with('_')
        && !cx.facts.writes().is_read(id)
        && is_direct()
        && !cx.facts.unseen().has(name)
}

fn report(cx: &mut Context, declared: &Declared) {
    let program = cx.program;
    let Some(variable) = program.variable(declared.variable) else {
        return;
    };
    let Some(token) = variable.token else { return };
    let name = program.names.text(variable.name);
    let writes = cx.facts.writes().idle(declared.variable);
    let fix = removal(cx, declared, writes)
        .map(|edits| Fix::suggestion(format!("take `{name}` out"), edits));
    let message = match writes.first() {
        None => format!("`{name}` is never used"),
        Some(_) => format!("`{name}` is written to, but never read"),
    };
    let written = writes.first().map(|&w| program.expr_span(w));
    let mut finding = cx.report(Extent::token(token), message);
    if let Some(written) = written {
        finding = finding.label(written, "this value goes nowhere");
    }
    finding.fix(fix);
}

/// The edits that take a variable and all that is written to it away, where nothing else goes with
/// them.
fn removal(cx: &Context, declared: &Declared, writes: &[ExprId]) -> Option<Vec<Edit>> {
    let program = cx.program;
    let tree = &program.tree;
    let effects = cx.facts.effects();
    let all = tree.declarators(declared.declarators);
    let init = all.get(declared.index)?.init;
    // A struct that is declared on the spot would go too.
    let declares_type = matches!(tree.ty(declared.ty).base, TypeBase::Struct(_));
    if init.is_some_and(|e| effects.has(e)) || declares_type {
        return None;
    }
    let mut edits = vec![if all.len() > 1 {
        remove_declarator(program, all, declared.index)?
    } else {
        if declared.stmt.is_some_and(|s| !stands_alone(cx, s)) {
            return None;
        }
        remove_statement(program, declared.extent)?
    }];
    for &write in writes {
        let (target, value) = match tree.expr(write).kind {
            ExprKind::Assign(_, target, value) => (target, Some(value)),
            ExprKind::Unary(_, target) | ExprKind::Postfix(_, target) => (target, None),
            _ => return None,
        };
        let stmt = cx.facts.structure().stmt_of(write)?;
        let is_all = tree.stmt(stmt).kind == StmtKind::Expr(write);
        let has_more = effects.has(target) || value.is_some_and(|v| effects.has(v));
        if !is_all || has_more || !stands_alone(cx, stmt) {
            return None;
        }
        edits.push(remove_statement(program, tree.stmt(stmt).extent)?);
    }
    Some(edits)
}

/// Whether a statement stands in a block, so that the block is whole without it.
fn stands_alone(cx: &Context, stmt: StmtId) -> bool {
    let outer = cx.facts.structure().outer(stmt);
    outer.is_some_and(|o| matches!(cx.program.tree.stmt(o).kind, StmtKind::Block(_)))
}
