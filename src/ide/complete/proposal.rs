//! One completion.

use crate::symbol::SymbolKind;

/// The kind of a completion.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum CompletionKind {
    /// A symbol of the shader.
    Symbol(SymbolKind),
    /// A built-in type.
    Type,
    /// Another keyword.
    Keyword,
    /// Components of a vector.
    Components,
    /// A snippet with placeholders.
    Snippet,
    /// A file or folder.
    File,
    /// Name of a rule.
    Rule,
}

/// A completion.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Proposal {
    /// Text in the list.
    pub label: String,
    /// Kind of the completion.
    pub kind: CompletionKind,
    /// Type or signature.
    pub detail: String,
    /// Inserted text if it differs from the label; `${1:name}` are placeholders.
    pub snippet: Option<String>,
    /// Documentation in Markdown.
    pub text: String,
    /// Order in the list, lower first.
    pub rank: u16,
}

impl Proposal {
    pub(crate) fn new(label: impl Into<String>, kind: CompletionKind, rank: u16) -> Proposal {
        Proposal {
            label: label.into(),
            kind,
            detail: String::new(),
            snippet: None,
            text: String::new(),
            rank,
        }
    }

    pub(crate) fn detail(self, detail: impl Into<String>) -> Proposal {
        Proposal {
            detail: detail.into(),
            ..self
        }
    }
}

/// Identifier that replaces the incomplete word.
pub(super) const PLACEHOLDER: &str = "shaderlintHole";
