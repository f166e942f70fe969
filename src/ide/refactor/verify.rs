//! Checks the text after a refactoring.

use super::place::RefactorPlace;
use super::proposal::{NewFile, ProposedRefactoring, Refactoring, RequiredProof};
use crate::document::{Document, Overlay};
use crate::preview::preview_project;
use shaderlint_diagnostic::{Origin, Severity};
use shaderlint_engine::{Analysis, equal};
use shaderlint_exec::Equality;
use shaderlint_flow::{ShaderVersion, is_equivalent};
use shaderlint_lint::Facts;
use shaderlint_project::UniformControl;
use shaderlint_semantic::tunable::tunables;
use shaderlint_text::{Edit, apply_edits};
use std::path::PathBuf;

/// Number of instructions that may run to compare images.
const FUEL: u64 = 100_000_000;

/// The refactoring of a proposal, if the shaders stay the same.
pub(super) fn verified(
    place: &RefactorPlace,
    proposal: ProposedRefactoring,
) -> Option<Refactoring> {
    let created = proposal.creates.as_slice();
    let ChangedDocument { edits, after } = changed(place, &proposal.edits, created)?;
    let has_slider = |name: &String| {
        let mut all = after.report.analyses.iter();
        all.any(|a| {
            tunables(&a.program)
                .iter()
                .any(|t| a.program.sources.text(t.name) == name)
        })
    };
    let is_kept = is_kept(place, &after, &proposal.evidence);
    if !is_kept || !proposal.slider.as_ref().is_none_or(has_slider) {
        return None;
    }
    let name = proposal.name.and_then(|name| position(&edits, &name));
    Some(Refactoring {
        title: proposal.title,
        kind: proposal.kind,
        edits,
        name,
        creates: proposal.creates,
    })
}

/// A document after edits.
pub(super) struct ChangedDocument {
    /// The edits of the document, in order.
    pub edits: Vec<Edit>,
    pub after: Document,
}

/// Applies edits of addresses.
pub(super) fn changed(
    place: &RefactorPlace,
    edits: &[Edit],
    created: &[NewFile],
) -> Option<ChangedDocument> {
    let document = place.document;
    let edits = edits.iter();
    let edits = edits.map(|edit| document.report.edit_of_input(edit));
    let mut edits: Vec<Edit> = edits.collect::<Option<_>>()?;
    edits.sort_by_key(|edit| edit.span);
    let text = apply_edits(&document.text, 0, &edits).ok()?;
    let files = Overlay {
        files: place.files,
        texts: created
            .iter()
            .map(|file| (PathBuf::from(&file.path), file.text.as_str().into()))
            .collect(),
    };
    let after = document.read_as(text, &files);
    Some(ChangedDocument { edits, after })
}

/// Where edits write a name that is new, in the changed text: at its last use, which is the code
/// that was selected or replaces it.
fn position(edits: &[Edit], name: &str) -> Option<u32> {
    let mut grown = 0;
    let mut found = None;
    for edit in edits {
        if let Some(at) = edit.text.rfind(name) {
            found = Some(i64::from(edit.span.start) + grown + at as i64);
        }
        grown += edit.text.len() as i64 - i64::from(edit.span.len());
    }
    found.and_then(|at| u32::try_from(at).ok())
}

/// The number of errors, apart from those of rules, which do not check the changed text.
fn error_count(document: &Document) -> usize {
    let all = document.report.diagnostics.iter();
    let errors = all.filter(|d| d.severity == Severity::Error && d.origin != Origin::Rule);
    errors.count()
}

/// Whether the shaders of a document stay the same.
fn is_kept(place: &RefactorPlace, after: &Document, evidence: &RequiredProof) -> bool {
    let before = place.document;
    if let RequiredProof::SameWithValue(edits, control) = evidence {
        let with_value = changed(place, edits, &[]);
        let is_same =
            |other: ChangedDocument| is_kept(place, &other.after, &RequiredProof::EqualIr);
        return error_count(after) <= error_count(before)
            && has_control(after, control)
            && with_value.is_some_and(is_same);
    }
    let (ours, theirs) = (&before.report.analyses, &after.report.analyses);
    if ours.len() != theirs.len() || error_count(after) > error_count(before) {
        return false;
    }
    let mut pairs = ours.iter().zip(theirs);
    pairs.all(|(a, b)| {
        if a.has_errors || b.has_errors {
            return a.has_errors == b.has_errors;
        }
        a.program.stage == b.program.stage
            && match evidence {
                RequiredProof::EqualImages => matches!(
                    equal(&a.program, &b.program, &mut FUEL.clone()),
                    Ok(Equality::Proved | Equality::SampledEqual { .. })
                ),
                _ => is_proved(a, b),
            }
    })
}

/// Whether the host of a shader compiles it and sets a uniform as this control says.
fn has_control(document: &Document, control: &UniformControl) -> bool {
    let Ok(mut project) = preview_project(document, 0) else {
        return false;
    };
    let composed = project.resolve(&document.path);
    composed.is_ok_and(|c| !c.has_errors()) && project.controls.contains(control)
}

fn is_proved(before: &Analysis, after: &Analysis) -> bool {
    let (ours, theirs) = (before.facts(), after.facts());
    is_equivalent(version(before, &ours), version(after, &theirs))
}

fn version<'a>(analysis: &'a Analysis, facts: &'a Facts<'a>) -> ShaderVersion<'a> {
    ShaderVersion {
        program: &analysis.program,
        module: facts.module(),
        effects: facts.effects(),
        entry: None,
    }
}
