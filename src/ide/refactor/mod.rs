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
#[cfg(test)]
mod tests;
mod upgrade;
mod verify;

use super::document::Document;
use place::RefactorPlace;
use shaderlint_engine::Files;
use shaderlint_text::{Edit, Span};

/// A verified refactoring.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Refactoring {
    /// Title as an imperative sentence.
    pub title: String,
    /// Kind of refactoring.
    pub kind: RefactorKind,
    /// Edits of the document.
    pub edits: Vec<Edit>,
    /// Where the new name is in the changed text, for a rename that follows.
    pub name: Option<u32>,
    /// A file that is created.
    pub creates: Option<NewFile>,
}

/// A file that a refactoring creates.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct NewFile {
    /// Absolute path.
    pub path: String,
    /// Contents.
    pub text: String,
}

/// Kinds of refactorings, as editors group them.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum RefactorKind {
    /// Gives an expression a name in its function.
    ExtractVariable,
    /// Gives a constant expression a global name.
    ExtractConstant,
    /// Moves code to a new function.
    ExtractFunction,
    /// Replaces a name with what it stands for.
    Inline,
    /// Writes the same in another way.
    Rewrite,
    /// Moves code to another file.
    Move,
}

impl RefactorKind {
    /// All kinds.
    pub const ALL: [RefactorKind; 6] = [
        RefactorKind::ExtractVariable,
        RefactorKind::ExtractConstant,
        RefactorKind::ExtractFunction,
        RefactorKind::Inline,
        RefactorKind::Rewrite,
        RefactorKind::Move,
    ];
}

/// How a refactoring is verified.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Evidence {
    /// The IR is equal.
    Proof,
    /// The sampled images are equal.
    Images,
}

/// A refactoring that is not verified yet. Edits are of addresses.
struct Proposal {
    title: String,
    kind: RefactorKind,
    edits: Vec<Edit>,
    /// The new name.
    name: Option<String>,
    creates: Option<NewFile>,
    evidence: Evidence,
    /// The name of a constant that must get a slider.
    slider: Option<String>,
}

impl Proposal {
    fn new(kind: RefactorKind, title: impl Into<String>, edits: Vec<Edit>) -> Proposal {
        Proposal {
            title: title.into(),
            kind,
            edits,
            name: None,
            creates: None,
            evidence: Evidence::Proof,
            slider: None,
        }
    }

    fn named(self, name: impl Into<String>) -> Proposal {
        Proposal {
            name: Some(name.into()),
            ..self
        }
    }
}

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
    type Propose = fn(&RefactorPlace) -> Vec<Proposal>;
    let all: [(RefactorKind, Propose); 9] = [
        (RefactorKind::ExtractVariable, extract_variable::propose),
        (RefactorKind::ExtractConstant, constant::propose),
        (RefactorKind::ExtractFunction, extract_function::propose),
        (RefactorKind::Inline, inline_variable::propose),
        (RefactorKind::Inline, inline_function::propose),
        (RefactorKind::Rewrite, constant::propose_slider),
        (RefactorKind::Rewrite, define::propose),
        (RefactorKind::Rewrite, upgrade::propose),
        (RefactorKind::Move, move_function::propose),
    ];
    let requested = all.into_iter().filter(|(kind, _)| is_requested(*kind));
    let proposals = requested.flat_map(|(_, propose)| propose(&place));
    proposals
        .filter_map(|proposal| verify::verified(&place, proposal))
        .collect()
}
