//! GLSL ES 1.00 in a project that converts its shaders to GLSL ES 3.00.

use shaderlint_diagnostic::Severity;
use shaderlint_lint::{Check, Group, Rule, RulePreset};

/// Reports complete shaders with their conversion, which needs the other stage: the engine finds them.
pub static RULE: Rule = Rule {
    name: "old-version",
    group: Group::Webgl2,
    severity: Severity::Warning,
    preset: RulePreset::Recommended,
    options: &[],
    page: include_str!("old_version.md"),
    checks: &[Check::Page],
};
