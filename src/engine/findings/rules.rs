//! Runs the rules over a shader.

use super::stage::{ShaderCheck, ask_first};
use super::upgrade;
use crate::inputs::Supply;
use shaderlint_diagnostic::{Diagnostic, error};
use shaderlint_lint::{Facts, Obstacles, ShaderContext, SkippedRules, lint_within};
use shaderlint_rules::RULES;
use shaderlint_semantic::Completeness;
use std::collections::BTreeSet;

/// Maximum number of rule findings in one shader; more are reported after these are fixed.
const MAX_FINDINGS: usize = 500;

/// Adds the findings of the rules before those of other stages.
pub fn run(shader: &mut ShaderCheck) {
    let (part, options, host) = (shader.part, shader.options, shader.host());
    let checked = &shader.checked;
    let completeness = checked.completeness;
    let open = &checked.open;
    let is_example = part.readings.is_shown() && !part.readings.has_version();
    if open.is_torn || is_example || completeness == Completeness::Excerpt {
        shader.skipped = SkippedRules::Everywhere;
        return;
    }
    let upgraded = upgrade::report(part, checked, &options.settings);
    let mut found: Vec<Diagnostic> = upgraded.into_iter().collect();
    let program = &checked.program;
    let errors = checked.diagnostics.iter().chain(&open.unknown);
    // Desktop GLSL has initialisers that are not constant.
    let is_desktop = part.host.is_some_and(|host| host.runs_desktop());
    let is_obstacle = |d: &&Diagnostic| !(is_desktop && d.is(error::NOT_CONSTANT));
    let errors: Vec<Diagnostic> = errors.filter(is_obstacle).cloned().collect();
    let supply = Supply::of(program, host, shader.hosts);
    let around = ShaderContext {
        embedder: part.embedder,
        mipmapped: part.mipmapped,
        supplier: (completeness == Completeness::Complete).then_some(&supply),
        is_fragment: completeness != Completeness::Complete,
    };
    let mut facts = Facts::of(program, &shader.known);
    facts.around = around;
    let obstacles = Obstacles {
        errors: &errors,
        unclear: &open.unclear,
    };
    let skipped = lint_within(facts, obstacles, RULES, &options.settings, &mut found);
    if skipped != SkippedRules::Everywhere {
        shader.allows.apply(program, RULES, &mut found);
    }
    if let SkippedRules::Functions { broken, .. } = &skipped {
        shader.allows.excuse(broken);
    }
    // A declaration that was misspelled where it is used is not reported as unused.
    let fixes = errors.iter().filter_map(|d| d.fix.as_ref());
    let meant: BTreeSet<&str> = fixes
        .flat_map(|f| &f.edits)
        .map(|e| e.text.as_str())
        .collect();
    let sources = &program.sources;
    found.retain(|d| sources.is_user(d.span.start) && !meant.contains(sources.text(d.span)));
    if completeness != Completeness::Complete {
        // The code that a host adds is unknown, so no fix is applied without being asked for.
        ask_first(&mut found);
    }
    found.sort_by_key(|d| (d.span.start, d.span.end));
    shader.left_out = found.len().saturating_sub(MAX_FINDINGS);
    found.truncate(MAX_FINDINGS);
    found.append(&mut shader.checked.diagnostics);
    shader.checked.diagnostics = found;
    shader.skipped = skipped;
}
