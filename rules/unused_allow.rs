//! `// shaderlint: allow(...)` comments without a finding to suppress.

use shaderlint_diagnostic::Severity;
use shaderlint_lint::{Check, Group, Rule, RulePreset};

/// Reports the comments that `suppress` of the lint layer found to be unused.
pub static RULE: Rule = Rule {
    name: "unused-allow",
    group: Group::Tidy,
    severity: Severity::Warning,
    preset: RulePreset::Recommended,
    options: &[],
    page: include_str!("unused_allow.md"),
    checks: &[Check::Allows],
};
