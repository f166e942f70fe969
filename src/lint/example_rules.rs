//! Two rules that find nothing, for the tests of this layer: real ones are above it.

use crate::rule::{Group, Rule};
use shaderlint_diagnostic::Severity;

/// One rule that runs by default, and one that does not.
pub static RULES: &[&Rule] = &[
    &rule("float-equality", Group::Numeric, true),
    &rule("unused-parameter", Group::Tidy, false),
];

const fn rule(name: &'static str, group: Group, default: bool) -> Rule {
    Rule {
        name,
        group,
        severity: Severity::Warning,
        default,
        options: &[],
        page: "",
        checks: &[],
    }
}
