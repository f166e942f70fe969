//! What was checked in an input, and what was not.

use shaderlint_engine::{Completeness, Report};
use shaderlint_lint::SkippedRules;
use shaderlint_report::Scope;

/// What was checked, as the summary counts it.
pub fn scope_of(report: &Report) -> Scope {
    let mut scope = Scope {
        shaders: report.shaders.len(),
        left_out: report.left_out,
        counted_infos: report.counted_infos,
        ..Scope::default()
    };
    for shader in &report.shaders {
        scope.open_names.extend(shader.holes.iter().cloned());
        match &shader.skipped {
            SkippedRules::Functions { names, .. } => {
                let functions = match shader.completeness {
                    Completeness::Complete => &mut scope.skipped_functions,
                    _ => &mut scope.open_functions,
                };
                functions.extend(names.iter().cloned());
            }
            SkippedRules::Everywhere if shader.has_errors => scope.skipped_shaders += 1,
            SkippedRules::Everywhere => scope.excerpts += 1,
            SkippedRules::Nowhere => {}
        }
    }
    scope
}
