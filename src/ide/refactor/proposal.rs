//! Refactorings, before and after they are verified.

use shaderlint_project::UniformControl;
use shaderlint_text::Edit;

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
pub(super) enum RequiredProof {
    /// The IR is equal.
    EqualIr,
    /// The IR is equal after other edits, which declare a constant instead of this control.
    SameWithValue(Vec<Edit>, UniformControl),
    /// The sampled images are equal.
    EqualImages,
}

/// A refactoring that is not verified yet. Edits are of addresses.
pub(super) struct ProposedRefactoring {
    pub title: String,
    pub kind: RefactorKind,
    pub edits: Vec<Edit>,
    /// The new name.
    pub name: Option<String>,
    pub creates: Option<NewFile>,
    pub evidence: RequiredProof,
    /// The name of a constant that must get a slider.
    pub slider: Option<String>,
}

impl ProposedRefactoring {
    pub fn new(
        kind: RefactorKind,
        title: impl Into<String>,
        edits: Vec<Edit>,
    ) -> ProposedRefactoring {
        ProposedRefactoring {
            title: title.into(),
            kind,
            edits,
            name: None,
            creates: None,
            evidence: RequiredProof::EqualIr,
            slider: None,
        }
    }

    pub fn named(self, name: impl Into<String>) -> ProposedRefactoring {
        ProposedRefactoring {
            name: Some(name.into()),
            ..self
        }
    }
}
