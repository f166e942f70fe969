//! Repairs that are tried.

use shaderlint_diagnostic::Diagnostic;
use shaderlint_text::{Edit, Span};

/// A repair that a line suggests.
pub(super) struct Candidate {
    pub edits: Vec<Edit>,
    /// What is said if it is the right one.
    pub diagnostic: Diagnostic,
    /// The macro whose calls stumble, by the name in its definition.
    pub of: Option<Span>,
}
