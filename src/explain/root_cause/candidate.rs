//! Candidate repairs.

use shaderlint_diagnostic::{Applicability, Diagnostic, Fix};
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

impl RepairCandidate {
    /// A candidate that is reported as the error with another fix.
    pub fn of_error(d: &Diagnostic, fix: Fix) -> RepairCandidate {
        RepairCandidate {
            must_reduce: true,
            ..RepairCandidate::new(d.clone(), fix)
        }
    }

    /// A finding whose fix is tried, and may leave as many errors as there were.
    pub fn new(diagnostic: Diagnostic, fix: Fix) -> RepairCandidate {
        RepairCandidate {
            edits: fix.edits.clone(),
            diagnostic: diagnostic.fix(fix),
            of: None,
            must_reduce: false,
        }
    }

    /// The candidate with a fix that is the only way to read the code.
    pub fn safe(mut self) -> RepairCandidate {
        let fix = self.diagnostic.fix.as_mut();
        fix.into_iter()
            .for_each(|fix| fix.applicability = Applicability::Safe);
        self
    }
}

/// Whether two findings are about the same mistake.
pub(super) fn same(a: &Diagnostic, b: &Diagnostic) -> bool {
    a.kind == b.kind && a.span.start == b.span.start
}
