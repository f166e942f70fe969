//! Refactorings: edits that keep what a shader computes.
//!
//! There are few special cases. A refactoring proposes edits; the changed text is checked again, and
//! the IR of the shaders before and after must be equal after inlining and value numbering. What
//! cannot be proved is not offered.

mod constant;
mod define;
mod extract_function;
mod extract_variable;
mod inline_function;
mod inline_variable;
mod move_function;
mod name;
mod place;
mod proposal;
#[cfg(test)]
mod shown_tests;
mod shown_value;
mod uniform;
mod upgrade;
mod verify;

use super::document::Document;
use place::RefactorPlace;
use proposal::ProposedRefactoring;
pub use proposal::{NewFile, RefactorKind, Refactoring};
use shaderlint_project::Files;
use shaderlint_text::Span;
pub use shown_value::{ShownValue, WITHIN, shown_value};

/// The refactorings of the code at a selection, of the requested kinds. Each is verified.
pub fn refactorings(
    document: &Document,
    files: &dyn Files,
    selection: Span,
    is_requested: impl Fn(RefactorKind) -> bool,
) -> Vec<Refactoring> {
    let Some(place) = RefactorPlace::of(document, files, selection) else {
        return Vec::new();
    };
    enum Propose {
        One(fn(&RefactorPlace) -> Option<ProposedRefactoring>),
        Several(fn(&RefactorPlace) -> Vec<ProposedRefactoring>),
    }
    use Propose::*;
    let all = [
        (
            RefactorKind::ExtractVariable,
            Several(extract_variable::propose),
        ),
        (RefactorKind::ExtractConstant, Several(constant::propose)),
        (
            RefactorKind::ExtractFunction,
            One(extract_function::propose),
        ),
        (RefactorKind::Inline, One(inline_variable::propose)),
        (RefactorKind::Inline, One(inline_function::propose)),
        (RefactorKind::Rewrite, One(constant::propose_slider)),
        (RefactorKind::Rewrite, One(uniform::propose)),
        (RefactorKind::Rewrite, One(define::propose)),
        (RefactorKind::Rewrite, One(upgrade::propose)),
        (RefactorKind::Move, One(move_function::propose)),
    ];
    let requested = all.into_iter().filter(|(kind, _)| is_requested(*kind));
    let proposals = requested.flat_map(|(_, propose)| match propose {
        One(propose) => propose(&place).into_iter().collect(),
        Several(propose) => propose(&place),
    });
    proposals
        .filter_map(|proposal| verify::verified(&place, proposal))
        .collect()
}
