//! Uniforms that the shader declares and never reads.

use crate::diagnostic::{Fix, Severity};
use crate::lint::{Check, Context, Group, Rule, remove_declarator, remove_statement};
use crate::semantic::Storage;
use crate::syntax::ast::{DeclKind, Extent, Item};

pub static RULE: Rule = Rule {
    name: "unused-uniform",
    group: Group::Tidy,
    severity: Severity::Info,
    default: true,
    options: &[],
    page: include_str!("unused_uniform.md"),
    check: Check::Program(check),
};

fn check(cx: &mut Context) {
    let Some(own) = cx.facts.own_file() else {
        return;
    };
    let program = cx.program;
    for item in &program.tree.items {
        let Item::Decl(decl) = *item else { continue };
        let Some(decl) = program.tree.decl(decl) else {
            continue;
        };
        let DeclKind::Variables { declarators, .. } = decl.kind else {
            continue;
        };
        if !own.contains(program.span(decl.extent)) {
            continue;
        }
        let all = program.tree.declarators(declarators);
        for (index, declarator) in all.iter().enumerate() {
            let at = declarators.start as usize + index;
            let Some(id) = program.declared.get(at).copied().flatten() else {
                continue;
            };
            let Some(variable) = program.variable(id) else {
                continue;
            };
            let name = program.names.text(variable.name);
            let token = declarator.ident.token;
            let is_direct = program.token(token).is_some_and(|t| t.is_direct());
            if variable.storage != Storage::Uniform || variable.read || !is_direct {
                continue;
            }
            if name.starts_with('_') || cx.facts.unseen().has(name) {
                continue;
            }
            let edit = match all.len() {
                1 => remove_statement(program, decl.extent),
                _ => remove_declarator(program, all, index),
            };
            let fix = edit.map(|e| Fix::suggestion(format!("take `{name}` out"), vec![e]));
            cx.report(
                Extent::token(token),
                format!("the uniform `{name}` is never read"),
            )
            .note("the compiler drops it: a page that sets it gets no location for it")
            .fix(fix);
        }
    }
}
