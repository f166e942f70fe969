//! Checks one shader of an input: resolves its host if something is missing, and runs the rules.

use super::inactive;
use super::required;
use super::unknown::{self, Unresolved};
use super::{upgrade, version};
use crate::check_context::Keep;
use crate::hosts::host::Hosts;
use crate::hosts::hosted;
use crate::inputs::Supply;
use crate::options::{DialectChoice, Options};
use crate::shader::analysis::Analysis;
use crate::shader::reading::{Readings, lacking};
use crate::shader::shader_input::{Shader, ShaderInput};
use shaderlint_detect::embed::LeadingBlanks;
use shaderlint_diagnostic::{
    Applicability, Certainty, Diagnostic, Facet, Severity, Subject, error,
};
use shaderlint_explain::Checked;
use shaderlint_host::Preset;
use shaderlint_lint::{
    Allows, CachedFacts, CheckedSpans, Facts, Obstacles, ShaderContext, SkippedRules,
    keep_comments, lint_within,
};
use shaderlint_rules::RULES;
use shaderlint_semantic::Completeness;
use shaderlint_syntax::{Version, WordClass, classify};
use shaderlint_text::{FileId, Role, Sources};
use std::collections::BTreeSet;
use std::sync::Arc;

/// The findings about the shaders of a file.
#[derive(Default)]
pub struct ShaderFindings {
    pub diagnostics: Vec<Diagnostic>,
    /// The suppression comments.
    pub allows: Allows,
    /// Names that hosts have to declare.
    pub unresolved: Unresolved,
}

/// Checks a shader. For a shader with errors, also returns what was checked.
pub fn check_shader(
    sources: &mut Arc<Sources>,
    part: &mut ShaderInput,
    hosts: &Hosts,
    options: &Options,
    keep: Keep,
    found: &mut ShaderFindings,
) -> Option<(Shader, Option<CheckedSpans>)> {
    let mut checked = understand(sources, part, hosts, options)?;
    let known = Arc::default();
    let before = found.diagnostics.len();
    unknown::decide_severity(sources, part, &mut checked, hosts, &mut found.unresolved);
    required::apply(sources, part, &mut checked);
    if let Some(host) = part.host {
        required::add_limits(host, &mut checked);
    }
    let missing = version::missing(sources, part, &checked, hosts);
    checked.diagnostics.extend(missing);
    version::lower_reserved_words(sources, part, &mut checked);
    if !part.readings.is_shown() {
        inactive::report(sources, part, &mut checked);
    }
    let reported = report_shader(
        sources,
        part,
        (&mut checked, &known),
        options,
        &mut found.allows,
        &mut found.diagnostics,
    )?;
    // A host that does not accept desktop GLSL rejects it, as WebGL does.
    if let Some(host) = part.host.filter(|h| !h.composes || h.runs_desktop()) {
        let mut own = found.diagnostics.split_off(before);
        hosted::leave_repaired(sources, (part, host), &mut own);
        found.diagnostics.append(&mut own);
    }
    if keep == Keep::Programs {
        let files = part.reading().map_or(&[][..], |reading| &reading.files);
        let analysis = Analysis::new(
            checked,
            reported.0.has_errors,
            host_of(part, options),
            files,
            known,
        );
        part.analysis = Some(analysis);
    }
    Some(reported)
}

/// The host that runs a shader: detected, or set by the user.
fn host_of(part: &ShaderInput, options: &Options) -> Option<&'static Preset> {
    part.host.or(options.host.preset)
}

/// Checks a shader. If something is missing, its host is resolved first.
fn understand(
    sources: &mut Arc<Sources>,
    part: &mut ShaderInput,
    hosts: &Hosts,
    options: &Options,
) -> Option<Checked> {
    let is_open = options.dialect == DialectChoice::Auto
        && options.host.preset.is_none()
        && !part.readings.is_shadertoy();
    let checked = part.readings.check(sources, part.infer_channels)?;
    let lacking = lacking(&checked);
    if (lacking.is_some() || hosted::given_composer(options).is_some())
        && part.host.is_none()
        && let Some(composed) = hosted::compose(sources, part, hosts, options)
    {
        return Some(composed);
    }
    let lacking = lacking.filter(|_| is_open);
    let (presets, is_sure) = lacking.map_or((Vec::new(), true), |lacking| {
        hosts.of(&lacking, &part.readings)
    });
    if presets.is_empty() {
        return Some(checked);
    }
    drop(checked);
    part.readings
        .host(Arc::make_mut(sources), &presets, options)?;
    let script = hosts.script();
    part.readings.are_hosts_complete = presets.iter().all(|p| p.is_complete_in(script));
    part.readings.is_guessed = !is_sure;
    part.readings.check(sources, part.infer_channels)
}

/// Runs the rules over a checked shader and collects the findings.
fn report_shader(
    sources: &Sources,
    part: &ShaderInput,
    (checked, found): (&mut Checked, &Arc<CachedFacts>),
    options: &Options,
    allows: &mut Allows,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<(Shader, Option<CheckedSpans>)> {
    let completeness = checked.completeness;
    let known = diagnostics.len();
    if part.readings.is_shown() && completeness != Completeness::Complete {
        keep_of_excerpt(&mut checked.diagnostics);
    }
    if part.readings.is_handed_over() && part.embedder.leading_blanks == LeadingBlanks::Unknown {
        let misplaced = checked.diagnostics.iter_mut();
        for d in misplaced.filter(|d| d.subject == Subject::BlankFront) {
            d.severity = Severity::Warning;
            d.notes
                .push("valid if the text is trimmed before it is compiled".to_string());
        }
    }
    let is_error = |d: &&Diagnostic| d.severity == Severity::Error;
    let errors = checked.diagnostics.iter().filter(is_error).count();
    allows.expect(&checked.program, RULES, &mut checked.diagnostics);
    let (skipped, left_out) = run_rules(part, (checked, found), options, allows, diagnostics);
    keep_under_hosts(sources, &part.readings, &mut checked.diagnostics);
    if completeness != Completeness::Complete {
        // The program around a shader fragment depends on its names.
        let names = checked.diagnostics.iter_mut();
        let renamed = names.filter(|d| d.is(error::RESERVED_WORD));
        renamed.for_each(|d| ask_first(std::slice::from_mut(d)));
    }
    diagnostics.append(&mut checked.diagnostics);
    let own = diagnostics.get_mut(known..).unwrap_or(&mut []);
    if completeness != Completeness::Complete {
        let hosts: Arc<[String]> = part.readings.hosts.as_slice().into();
        own.iter_mut().for_each(|d| d.part = Some(hosts.clone()));
    }
    if own.iter().any(|d| d.fix.is_some()) {
        let mut comments = checked.program.tokens.comments.clone();
        comments.sort();
        for diagnostic in own {
            keep_comments(sources, &comments, diagnostic);
        }
    }
    let program = &checked.program;
    let checked_spans = (errors > 0).then(|| CheckedSpans::of(program));
    let own = |id: &&FileId| sources.code(**id).is_some_and(|c| c.role == Role::User);
    let shader = Shader {
        missing: part.missing.clone(),
        file: part.reading()?.files.iter().rev().find(own).copied(),
        stage: program.stage,
        dialect: program.dialect,
        version: program.version,
        completeness,
        skipped,
        has_errors: errors > 0,
        left_out,
        size: program.size(),
        holes: std::mem::take(&mut checked.open.names),
        hosts: part.readings.hosts.clone(),
        host: part.host,
    };
    Some((shader, checked_spans))
}

/// Keeps the errors of an excerpt that hold out of context, such as type errors. An excerpt may be
/// cut anywhere, list prototypes, or repeat earlier declarations.
fn keep_of_excerpt(diagnostics: &mut Vec<Diagnostic>) {
    diagnostics.retain(|d| {
        d.severity != Severity::Error
            || d.certainty() == Certainty::Meaning && !d.has(Facet::Declares)
    });
    let errors = diagnostics
        .iter_mut()
        .filter(|d| d.severity == Severity::Error);
    errors.for_each(|d| d.severity = Severity::Warning);
}

/// Runs the rules over a shader. Returns where they did not run, and the number of findings dropped
/// because there are too many.
fn run_rules(
    part: &ShaderInput,
    (checked, known): (&Checked, &Arc<CachedFacts>),
    options: &Options,
    allows: &mut Allows,
    diagnostics: &mut Vec<Diagnostic>,
) -> (SkippedRules, usize) {
    let completeness = checked.completeness;
    let open = &checked.open;
    let is_example = part.readings.is_shown() && !part.readings.has_version();
    if open.is_torn || is_example || completeness == Completeness::Excerpt {
        return (SkippedRules::Everywhere, 0);
    }
    let upgraded = upgrade::report(part, checked, &options.settings);
    let mut found: Vec<Diagnostic> = upgraded.into_iter().collect();
    let program = &checked.program;
    let errors = checked.diagnostics.iter().chain(&open.unknown);
    // Desktop GLSL has initialisers that are not constant.
    let is_desktop = part.host.is_some_and(|host| host.runs_desktop());
    let is_obstacle = |d: &&Diagnostic| !(is_desktop && d.is(error::NOT_CONSTANT));
    let errors: Vec<Diagnostic> = errors.filter(is_obstacle).cloned().collect();
    let supply = Supply::of(program, host_of(part, options));
    let around = ShaderContext {
        embedder: part.embedder,
        mipmapped: part.mipmapped,
        supplier: (completeness == Completeness::Complete).then_some(&supply),
        is_fragment: completeness != Completeness::Complete,
    };
    let mut facts = Facts::of(program, known);
    facts.around = around;
    let obstacles = Obstacles {
        errors: &errors,
        unclear: &open.unclear,
    };
    let skipped = lint_within(facts, obstacles, RULES, &options.settings, &mut found);
    if skipped != SkippedRules::Everywhere {
        allows.apply(program, RULES, &mut found);
    }
    if let SkippedRules::Functions { broken, .. } = &skipped {
        allows.excuse(broken);
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
    let left_out = found.len().saturating_sub(MAX_FINDINGS);
    found.truncate(MAX_FINDINGS);
    diagnostics.append(&mut found);
    (skipped, left_out)
}

/// Drops findings that depend on names of hosts that were only guessed.
fn keep_under_hosts(sources: &Sources, readings: &Readings, diagnostics: &mut Vec<Diagnostic>) {
    if readings.renames {
        diagnostics.retain(|d| !d.is(error::RESERVED_WORD));
    }
    if readings.is_guessed && !readings.needs_300() {
        // If a host is known only from packages, the text may be compiled as GLSL ES 1.00 by other
        // means.
        diagnostics.retain(|d| {
            let word = classify(sources.text(d.span), Version::Es100);
            let is_free = d.is(error::RESERVED_WORD) && word == WordClass::Plain;
            !d.is(error::BUILTIN_REDEFINITION) && !is_free
        });
    }
}

/// Maximum number of rule findings in one shader; more are reported after these are fixed.
const MAX_FINDINGS: usize = 500;

/// Makes all fixes unsafe, so that a person decides.
pub fn ask_first(diagnostics: &mut [Diagnostic]) {
    for fix in diagnostics.iter_mut().filter_map(|d| d.fix.as_mut()) {
        fix.applicability = Applicability::Unsafe;
    }
}
