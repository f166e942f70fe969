//! What is to be said of passes that could not be made as asked for.

use crate::diagnostic::{Diagnostic, Origin, Severity};
use crate::port::NotSafe;
#[cfg(feature = "naga")]
use crate::port::naga::Refused;
use crate::text::Span;

/// What is to be said of a pass.
pub(super) struct Remark {
    /// What the user calls the pass.
    pub(super) pass: String,
    /// How bad it is; nothing is written if it is an error.
    pub(super) severity: Severity,
    /// What is wrong.
    pub(super) message: String,
    /// Where; empty where it is the whole pass.
    pub(super) span: Span,
    rule: &'static str,
}

impl Remark {
    /// A pass that was to be rewritten, and is not.
    pub(super) fn kept(pass: String, reason: &NotSafe) -> Remark {
        Remark {
            pass,
            severity: Severity::Warning,
            message: format!("this stays behind the player's header: {}", reason.message),
            span: reason.span,
            rule: "kept-main",
        }
    }

    /// A pass that has no form in the language that was asked for.
    #[cfg(feature = "naga")]
    pub(super) fn refused(pass: String, reason: &Refused) -> Remark {
        Remark {
            pass,
            severity: Severity::Error,
            message: reason.message.clone(),
            span: reason.span,
            rule: "not-portable",
        }
    }

    /// The remark as a finding.
    pub(super) fn diagnostic(&self) -> Diagnostic {
        let message = self.message.clone();
        Diagnostic::new(
            self.rule,
            Origin::Compiler,
            self.severity,
            self.span,
            message,
        )
    }
}
