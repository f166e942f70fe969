//! Edits that remove code cleanly: no blank line where a statement was, no comma left over.

use crate::rule::DeclaredVariable;
use shaderlint_diagnostic::Fix;
use shaderlint_semantic::{Program, Structure};
use shaderlint_syntax::ast::{Declarator, Extent, StmtId, StmtKind};
use shaderlint_text::{Edit, Span};

/// Removes a statement, declaration or function. `None` where it starts or ends in a macro, or where it
/// contains directives, which may belong to others outside.
pub fn remove_statement(program: &Program, extent: Extent) -> Option<Edit> {
    let is_direct = |t| program.token(t).is_some_and(|t| t.is_direct());
    let span = program.span(extent);
    let has_directive = program.sources.text(span).contains('#');
    (is_direct(extent.first) && is_direct(extent.last) && !has_directive)
        .then(|| remove_lines(program, span))
}

/// A safe fix that removes a statement, if it is in a block.
pub fn without_statement(program: &Program, structure: &Structure, stmt: StmtId) -> Option<Fix> {
    let outer = program.tree.stmt(structure.outer(stmt)?).kind;
    let is_in_block = matches!(outer, StmtKind::Block(_));
    let edit = remove_statement(program, program.tree.stmt(stmt).extent)?;
    is_in_block.then(|| Fix::safe("remove this statement", vec![edit]))
}

/// Removes the code of a span, with its lines if nothing else is on them. Comments stay.
pub fn remove_lines(program: &Program, span: Span) -> Edit {
    shaderlint_text::remove_lines(&program.sources, span)
}

/// Removes the declaration of a variable: all of it, or one name among several.
pub fn remove_declaration(program: &Program, declared: &DeclaredVariable) -> Option<Edit> {
    match declared.declarators.len() {
        1 => remove_statement(program, declared.extent),
        _ => remove_declarator(program, declared.declarators, declared.index),
    }
}

/// Removes one of several names of a declaration, with its initializer and a comma. `None` where a token
/// of it comes from a macro, or there is only one name.
fn remove_declarator(program: &Program, all: &[Declarator], index: usize) -> Option<Edit> {
    let this = all.get(index)?;
    let span = |extent: Extent| program.is_direct(extent).then(|| program.span(extent));
    let own = span(this.extent)?;
    let before = index.checked_sub(1).and_then(|i| all.get(i));
    let removed = match (before, all.get(index + 1)) {
        (Some(before), _) => Span::new(span(before.extent)?.end, own.end),
        (None, Some(next)) => Span::new(own.start, span(next.extent)?.start),
        (None, None) => return None,
    };
    // A comment between two names may be about either.
    let text = program.sources.text(removed);
    let has_comment = text.contains("//") || text.contains("/*");
    (!has_comment).then(|| Edit::delete(removed))
}
