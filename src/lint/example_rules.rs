//! Two rules without checks, for the tests of this layer; the real rules are in `rules/`.

use crate::rule::{Group, Rule};
use shaderlint_diagnostic::Severity;

/// One rule that is on by default, and one that is off.
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
