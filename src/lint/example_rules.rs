//! Two rules without checks, for the tests of this layer; the real rules are in `rules/`.

use crate::rule::{Group, Rule, RulePreset};
use shaderlint_diagnostic::Severity;

/// One rule that is on by default, and one that is off.
pub static RULES: &[&Rule] = &[
    &rule("float-equality", Group::Numeric, RulePreset::Recommended),
    &rule("unused-parameter", Group::Tidy, RulePreset::Strict),
];

const fn rule(name: &'static str, group: Group, preset: RulePreset) -> Rule {
    Rule {
        name,
        group,
        severity: Severity::Warning,
        preset,
        options: &[],
        page: "",
        checks: &[],
    }
}
