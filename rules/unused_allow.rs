//! `// shaderlint: allow(...)` that allows nothing.

use shaderlint_diagnostic::Severity;
use shaderlint_lint::{Check, Group, Rule};

/// The rule.
pub static RULE: Rule = Rule {
    name: "unused-allow",
    group: Group::Tidy,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("unused_allow.md"),
    checks: &[Check::Allows],
};
