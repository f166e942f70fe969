//! Functions that nothing calls.

use crate::diagnostic::{Fix, Severity};
use crate::lint::{Check, Context, Group, Rule, remove_statement};
use crate::semantic::FunctionRef;
use crate::syntax::Name;
use crate::syntax::ast::{DeclKind, Extent, FunctionDecl};
use rustc_hash::FxHashSet;

pub static RULE: Rule = Rule {
    name: "unused-function",
    group: Group::Tidy,
    severity: Severity::Info,
    default: true,
    options: &[],
    page: include_str!("unused_function.md"),
    check: Check::Program(check),
};

/// What players call.
const ENTRIES: [&str; 5] = ["main", "mainImage", "mainCubemap", "mainSound", "mainVR"];

fn check(cx: &mut Context) {
    let Some(own) = cx.facts.own_file() else {
        return;
    };
    let program = cx.program;
    let mut prototypes: Option<FxHashSet<Name>> = None;
    for (i, function) in program.functions.iter().enumerate() {
        let definition = function.definition.and_then(|d| program.tree.function(d));
        let Some(definition) = definition else {
            continue;
        };
        let name = program.names.text(function.name);
        let token = program.token(definition.ident.token);
        let is_own = token.is_some_and(|t| t.is_direct() && own.contains(t.span));
        let is_exempt = || name.starts_with('_') || ENTRIES.contains(&name);
        let called = || cx.facts.calls().calls_of(FunctionRef(i as u32)).next();
        if !is_own || is_exempt() || called().is_some() || cx.facts.unseen().has(name) {
            continue;
        }
        let prototypes = prototypes.get_or_insert_with(|| prototypes_of(cx));
        let fix = removal(cx, definition, prototypes);
        cx.report(
            Extent::token(definition.ident.token),
            format!("nothing calls `{name}`"),
        )
        .fix(fix);
    }
}

/// The names of which there are prototypes.
fn prototypes_of(cx: &Context) -> FxHashSet<Name> {
    let tree = &cx.program.tree;
    let prototype = |kind: &DeclKind| match kind {
        DeclKind::Prototype(f) => tree.function(*f).map(|f| f.ident.name),
        _ => None,
    };
    tree.decls
        .iter()
        .filter_map(|d| prototype(&d.kind))
        .collect()
}

fn removal(cx: &Context, definition: &FunctionDecl, prototypes: &FxHashSet<Name>) -> Option<Fix> {
    let program = cx.program;
    let name = definition.ident.name;
    // Its prototype, or that of an overload, stands elsewhere.
    if prototypes.contains(&name) {
        return None;
    }
    let edit = remove_statement(program, definition.extent)?;
    let title = format!("take `{}` out", program.names.text(name));
    Some(Fix::suggestion(title, vec![edit]))
}
