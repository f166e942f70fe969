//! `getUniformLocation(program, "name")` for a uniform that no shader of the file declares.

use shaderlint_diagnostic::Severity;
use shaderlint_lint::{Check, Group, Rule, RulePreset};

/// Reports names that the linking code of the engine did not find in the shaders.
pub static RULE: Rule = Rule {
    name: "unknown-uniform",
    group: Group::Webgl2,
    severity: Severity::Warning,
    preset: RulePreset::Recommended,
    options: &[],
    page: include_str!("unknown_uniform.md"),
    checks: &[Check::Page],
};
