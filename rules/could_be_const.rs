//! Variables with a constant value that are never modified.

use shaderlint_lint::prelude::*;

rule! { could_be_const, Tidy, Info, Strict, Declaration(check) }

fn check(cx: &mut Context, declared: &DeclaredVariable) {
    let program = cx.program;
    let Some(variable) = program.variable(declared.variable) else {
        return;
    };
    let declarator = declared.declarator();
    let (Some(token), Some(init)) = (variable.token, declarator.and_then(|d| d.init)) else {
        return;
    };
    let is_plain = matches!(variable.storage, Storage::Local | Storage::Global)
        && declared.qualifiers.len == 0
        && declared.declarators.len() == 1;
    let is_never_written = !variable.is_const && !cx.facts.writes().changes(declared.variable);
    if !is_plain || !is_never_written || !program.expr(init).is_const {
        return;
    }
    if !program.is_direct(declared.extent) || !cx.facts.writes().is_read(declared.variable) {
        return;
    }
    let name = program.names.text(variable.name);
    let start = program.span(declared.extent).start;
    let edit = Edit::insert(start, "const ");
    cx.report(
        Extent::token(token),
        format!("`{name}` is never modified and can be `const`"),
    )
    .fix(Fix::suggestion("add `const`", vec![edit]));
}
