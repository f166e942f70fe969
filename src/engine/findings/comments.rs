//! Comments in shaders: what they suppress, and that fixes keep them.

use super::stage::{FileCheck, ShaderCheck};
use shaderlint_diagnostic::Severity;
use shaderlint_lint::keep_comments;
use shaderlint_rules::RULES;

/// Counts the errors, and drops those that a comment expects.
pub fn expect_errors(shader: &mut ShaderCheck) {
    let checked = &mut shader.checked;
    let mut severities = checked.diagnostics.iter().map(|d| d.severity);
    shader.has_errors = severities.any(|s| s == Severity::Error);
    let errors = &mut checked.diagnostics;
    shader.allows.expect(&checked.program, RULES, errors);
}

/// Adapts fixes that would delete a comment.
pub fn keep_in_fixes(shader: &mut ShaderCheck) {
    let own = &mut shader.checked.diagnostics;
    if own.iter().any(|d| d.fix.is_some()) {
        let mut comments = shader.checked.program.tokens.comments.clone();
        comments.sort();
        for diagnostic in own {
            keep_comments(shader.sources, &comments, diagnostic);
        }
    }
}

/// Reports suppression comments that suppress nothing, or are wrong.
pub fn report_unused(file: &mut FileCheck) {
    let settings = &file.context.options.settings;
    let found = &mut file.report.diagnostics;
    std::mem::take(&mut file.allows).report(RULES, settings, found);
}
