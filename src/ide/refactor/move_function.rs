//! Moves a function to a file of its own, which the shader includes.

use super::inline_variable::with_line;
use super::place::RefactorPlace;
use super::proposal::{NewFile, ProposedRefactoring, RefactorKind};
use crate::index::NameUse;
use crate::symbol::Symbol;
use shaderlint_semantic::starts_a_shader;
use shaderlint_text::{Edit, Span};
use std::path::Path;

pub(super) fn propose(place: &RefactorPlace) -> Option<ProposedRefactoring> {
    let name = place.name().filter(|n| n.access == NameUse::Defined)?;
    let Symbol::Function(id) = name.symbol else {
        return None;
    };
    let function = place.definition(id)?;
    let called = place.program.names.text(place.program.function(id)?.name);
    // Exports and other languages have no includes.
    let report = &place.document.report;
    if starts_a_shader(called) || report.holds_shaders() || report.file.is_none() {
        return None;
    }
    let file = format!("{called}.glsl");
    let path = Path::new(&place.document.path).with_file_name(&file);
    if place.files.entry(&path).is_some() {
        return None;
    }
    let span = place.program.span(function.extent);
    let start = place.before_item(span.start)?;
    let moved = with_line(place, Span::new(start, span.end))?;
    let line = place.line_break();
    let text = format!("{}{line}", place.text(Span::new(start, span.end))?);
    let edit = Edit::replace(moved, format!("#include \"{file}\"{line}"));
    let proposal = ProposedRefactoring::new(
        RefactorKind::Move,
        format!("Move `{called}` to `{file}`"),
        vec![edit],
    );
    Some(ProposedRefactoring {
        creates: Some(NewFile {
            path: path.to_str()?.to_string(),
            text,
        }),
        ..proposal
    })
}
