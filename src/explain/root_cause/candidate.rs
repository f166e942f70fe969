//! Candidate repairs.

use shaderlint_diagnostic::Diagnostic;
use shaderlint_text::{Edit, Span};

/// A repair to be tried.
pub(super) struct RepairCandidate {
    pub edits: Vec<Edit>,
    /// Reported if this repair is chosen.
    pub diagnostic: Diagnostic,
    /// Name span of the macro whose calls fail.
    pub of: Option<Span>,
    /// Whether it is a repair only if there are fewer errors with it: none may appear in exchange.
    pub must_reduce: bool,
}

/// Whether two findings are about the same mistake.
pub(super) fn same(a: &Diagnostic, b: &Diagnostic) -> bool {
    a.kind == b.kind && a.span.start == b.span.start
}
