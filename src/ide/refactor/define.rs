//! Writes a macro as a constant, and a constant as a macro.

use super::place::{RefactorPlace, as_macro};
use super::proposal::{ProposedRefactoring, RefactorKind};
use crate::symbol::{Symbol, typed};
use shaderlint_semantic::Type;
use shaderlint_syntax::Name;
use shaderlint_syntax::ast::*;
use shaderlint_text::{Edit, Span};

pub(super) fn propose(place: &RefactorPlace) -> Option<ProposedRefactoring> {
    match place.name()?.symbol {
        Symbol::Macro(name) => to_constant(place, name),
        Symbol::Variable(_) => to_macro(place),
        _ => None,
    }
}

fn to_constant(place: &RefactorPlace, name: Name) -> Option<ProposedRefactoring> {
    let program = place.program;
    let mut all = program.tokens.macros.iter().filter(|m| m.name == name);
    let definition = all.next().filter(|m| m.params.is_none() && !m.predefined)?;
    let (Some(last), None) = (definition.body.last(), all.next()) else {
        return None;
    };
    let first = definition.body.first()?;
    let body = Span::new(first.token.span.start, last.token.span.end);
    let (text, value) = (program.names.text(name), place.text(body)?);
    let ty = type_of(place, name)?;
    let code = program.sources.code_at(definition.name_span.start)?;
    let before = code
        .text
        .get(..(definition.name_span.start - code.base) as usize)?;
    let start = code.base + before.rfind('#')? as u32;
    if value.contains(['\n', '\r', '\\']) {
        return None;
    }
    let declared = format!("const {} = {value};", typed(program, ty, text));
    let edits = vec![Edit::replace(Span::new(start, body.end), declared)];
    let title = format!("Convert macro `{text}` to a constant");
    Some(ProposedRefactoring::new(
        RefactorKind::Rewrite,
        title,
        edits,
    ))
}

/// The type of the constant expression that a macro stands for.
fn type_of(place: &RefactorPlace, name: Name) -> Option<Type> {
    let program = place.program;
    let tokens = &program.tokens;
    let is_its = |e: &&shaderlint_syntax::Expansion| {
        let definition = tokens.macros.get(e.definition.0 as usize);
        definition.is_some_and(|d| d.name == name)
    };
    let calls: Vec<Span> = tokens
        .expansions
        .iter()
        .filter(is_its)
        .map(|e| e.call)
        .collect();
    let is_whole = |e: &Expr| calls.contains(&program.span(e.extent)) && place.is_exact(e.extent);
    let id = program.tree.exprs.iter().rposition(is_whole)?;
    let info = program.expr(ExprId(id as u32));
    info.is_const.then_some(info.ty)
}

fn to_macro(place: &RefactorPlace) -> Option<ProposedRefactoring> {
    let id = place.variable()?;
    let program = place.program;
    let variable = program.variable(id)?;
    if !variable.is_const || variable.function.is_some() {
        return None;
    }
    let (decl, init) = place.only_declarator(id)?;
    let span = program.span(decl.extent);
    let text = place.text_of(program.tree.expr(init).extent)?;
    let starts_line = place.indent(span.start)?.is_some();
    let code = program.sources.code_at(span.start)?;
    let after = code.text.get((span.end - code.base) as usize..)?;
    let line = after.split(['\n', '\r']).next()?.trim();
    let ends_line = line.is_empty() || line.starts_with("//");
    if !starts_line || !ends_line || text.contains(['\n', '\r']) {
        return None;
    }
    let name = program.names.text(variable.name);
    let value = as_macro(program, init, text);
    let edits = vec![Edit::replace(span, format!("#define {name} {value}"))];
    let title = format!("Convert constant `{name}` to a macro");
    Some(ProposedRefactoring::new(
        RefactorKind::Rewrite,
        title,
        edits,
    ))
}
