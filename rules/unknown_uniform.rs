//! `getUniformLocation(program, "name")` where no shader of the page has that uniform.

use shaderlint_diagnostic::Severity;
use shaderlint_lint::{Check, Group, Rule};

/// The rule.
pub static RULE: Rule = Rule {
    name: "unknown-uniform",
    group: Group::Webgl2,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("unknown_uniform.md"),
    checks: &[Check::Page],
};
