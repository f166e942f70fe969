//! Replaces a variable that is written once with its value.

use super::place::RefactorPlace;
use super::proposal::{ProposedRefactoring, RefactorKind};
use shaderlint_text::{Edit, Span};

pub(super) fn propose(place: &RefactorPlace) -> Option<ProposedRefactoring> {
    let id = place.variable()?;
    let program = place.program;
    let variable = program.variable(id)?;
    let is_inlined = variable.function.is_some() || variable.is_const;
    if variable.written || !is_inlined {
        return None;
    }
    let (decl, init) = place.only_declarator(id)?;
    let value = place.value_text(init)?;
    let init = match program.tree.unparen(init) {
        inner if place.text_of(program.tree.expr(inner).extent) == Some(value) => inner,
        _ => init,
    };
    let mentions = place.mentions(id).filter(|all| !all.is_empty())?;
    let declared = program.span(decl.extent);
    let mut edits = vec![Edit::delete(with_line(place, declared)?)];
    for expr in mentions {
        let text = place.in_place_of(expr, init, value);
        edits.push(Edit::replace(program.expr_span(expr), text));
    }
    let title = format!("Inline variable `{}`", program.names.text(variable.name));
    Some(ProposedRefactoring::new(RefactorKind::Inline, title, edits))
}

/// The span of a declaration with the line that it leaves empty.
pub(super) fn with_line(place: &RefactorPlace, span: Span) -> Option<Span> {
    let code = place.program.sources.code_at(span.start)?;
    let before = code.text.get(..(span.start - code.base) as usize)?;
    let after = code.text.get((span.end - code.base) as usize..)?;
    let start = before.rfind(['\n', '\r']).map_or(0, |at| at + 1);
    let end = after.find('\n').map_or(after.len(), |at| at + 1);
    let is_alone = before.get(start..)?.trim().is_empty() && after.get(..end)?.trim().is_empty();
    let blanks = after.len() - after.trim_start_matches([' ', '\t']).len();
    Some(match is_alone {
        true => Span::new(code.base + start as u32, span.end + end as u32),
        false => Span::new(span.start, span.end + blanks as u32),
    })
}
