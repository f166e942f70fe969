//! `// shaderlint: allow(...)` that allows nothing.

use crate::diagnostic::Severity;
use crate::lint::{Check, Group, Rule};

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
