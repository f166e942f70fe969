//! Declares a uniform for a number, where the host sets it to a value in the text.

use super::constant::{NumberRange, number};
use super::place::RefactorPlace;
use super::proposal::{ProposedRefactoring, RefactorKind, RequiredProof};
use crate::preview::preview_project;
use shaderlint_project::{ControlKind, UniformControl, declared_control};
use shaderlint_semantic::Value;
use shaderlint_text::number::shortest_decimal;
use shaderlint_text::{Edit, Span};

pub(super) fn propose(place: &RefactorPlace) -> Option<ProposedRefactoring> {
    let document = place.document;
    if document.report.analyses.len() != 1 || document.report.holds_shaders() {
        return None;
    }
    let host = preview_project(document, 0).ok()?.host?;
    let NumberRange {
        expr,
        value,
        low,
        high,
    } = number(place)?;
    let (kind, ty, value) = match value {
        Value::Float(value) => (ControlKind::Float, "float", shortest_decimal(value)),
        Value::Int(value) => (ControlKind::Int, "int", f64::from(value)),
        _ => return None,
    };
    let name = place.free_name("value");
    let control = UniformControl::even(&name, kind, 1, (low, value, high));
    let (_, item) = place.item_at(place.selection.start)?;
    let item = place.before_item(place.program.span(item).start)?;
    let at = document.report.in_input(Span::at(item))?.start as usize;
    let (at, text) = declared_control(host, &document.text, at, &control)?;
    let at = document.report.address(u32::try_from(at).ok()?)?;
    let text = text.replace('\n', place.line_break());
    let used = Edit::replace(place.program.expr_span(expr), &name);
    let constant = format!("const {ty} {name} = {}; ", place.value_text(expr)?);
    let title = "Extract to uniform with slider";
    let edits = vec![Edit::insert(at, text), used.clone()];
    let as_constant = vec![Edit::insert(item, constant), used];
    Some(ProposedRefactoring {
        evidence: RequiredProof::SameWithValue(as_constant, control),
        ..ProposedRefactoring::new(RefactorKind::Rewrite, title, edits).named(name)
    })
}
