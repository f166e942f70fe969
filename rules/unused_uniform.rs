//! Uniforms that are declared but never read.

use shaderlint_lint::prelude::*;
use shaderlint_lint::remove_declaration;

rule! { unused_uniform, Tidy, Info, Recommended, Declaration(check) }

fn check(cx: &mut Context, declared: &DeclaredVariable) {
    let program = cx.program;
    let variable = program.variable(declared.variable);
    let Some(variable) = variable.filter(|v| v.storage == Storage::Uniform && !v.read) else {
        return;
    };
    let own = cx.facts.own_file();
    let is_own = own.is_some_and(|own| own.contains(program.span(declared.extent)));
    let name = program.names.text(variable.name);
    let token = declared.declarator().map(|d| Extent::token(d.ident.token));
    let Some(token) = token.filter(|t| is_own && program.is_direct(*t)) else {
        return;
    };
    // A host sets its uniforms for every shader.
    if name.starts_with('_')
        || cx.facts.is_set_by_host(variable.name)
        || cx.facts.inactive_words().has(name)
    {
        return;
    }
    let edit = remove_declaration(program, declared);
    let fix = edit.map(|e| Fix::suggestion(format!("remove `{name}`"), vec![e]));
    cx.report(token, format!("uniform `{name}` is never read"))
        .note("the compiler removes it, so `getUniformLocation` returns null")
        .fix(fix);
}
