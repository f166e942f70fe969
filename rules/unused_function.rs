//! Functions that are never called.

use shaderlint_lint::prelude::*;
use shaderlint_semantic::starts_a_shader;

rule! { unused_function, Tidy, Info, Strict, Function(check) }

fn check(cx: &mut Context, id: FunctionRef) {
    let program = cx.program;
    let function = program.function(id);
    let definition = function.and_then(|f| program.tree.function(f.definition?));
    let Some(definition) = definition else {
        return;
    };
    let name = program.names.text(definition.ident.name);
    let at = Extent::token(definition.ident.token);
    let own = cx.facts.own_file();
    let is_own = own.is_some_and(|own| own.contains(program.span(at))) && program.is_direct(at);
    let is_test = function.is_some_and(|f| f.is_test(&program.names));
    let is_exempt = name.starts_with('_') || starts_a_shader(name) || is_test;
    let is_called = || cx.facts.calls().calls_of(id).next().is_some();
    if !is_own || is_exempt || is_called() || cx.facts.inactive_words().has(name) {
        return;
    }
    let fix = removal(cx, definition);
    cx.report(at, format!("function `{name}` is never called"))
        .fix(fix);
}

fn removal(cx: &Context, definition: &FunctionDecl) -> Option<Fix> {
    let program = cx.program;
    let name = definition.ident.name;
    // The prototype would remain; it may also be that of an overload.
    let has_prototype = program.tree.decls.iter().any(|d| match d.kind {
        DeclKind::Prototype(f) => program
            .tree
            .function(f)
            .is_some_and(|f| f.ident.name == name),
        _ => false,
    });
    if has_prototype {
        return None;
    }
    let edit = remove_statement(program, definition.extent)?;
    let title = format!("remove `{}`", program.names.text(name));
    Some(Fix::suggestion(title, vec![edit]))
}
