//! Analysis of one shader from files to findings, including error attribution to macro definitions
//! and directives.

use super::checked::Checked;
use super::root_cause::attribute;
use super::single_pass::analyze_single_pass;
use shaderlint_diagnostic::{Diagnostic, Severity, error};
use shaderlint_semantic::problem::MAX_ERRORS;
use shaderlint_semantic::{Completeness, Stage, Unit};
use shaderlint_syntax::Search;
use shaderlint_text::{FileId, Role, Sources, Span};
use std::sync::Arc;

/// Checks a complete fragment shader without a host. `None` if it is too large.
pub fn analyze_alone(code: String, role: Role) -> Option<Checked> {
    let mut sources = Sources::new();
    let file = sources.add("", None, role, code)?;
    Some(analyze_files(sources, &[file]))
}

/// The same, for tests of higher layers.
pub fn analyze_fragment(code: &str) -> Checked {
    let mut sources = Sources::new();
    let file = sources.add("test", None, Role::User, code);
    analyze_files(sources, file.as_slice())
}

fn analyze_files(sources: Sources, files: &[FileId]) -> Checked {
    let sources = Arc::new(sources);
    analyze(&Unit::complete(&sources, files, Stage::Fragment))
}

/// Checks a shader fragment in every way in which a host may complete it, most likely first; only
/// errors that occur in all of them are kept.
pub fn analyze_chunk(readings: &[Unit], search: &mut Search) -> Option<Checked> {
    let (first, others) = readings.split_first()?;
    let mut analysis = analyze_within(first, search);
    for other in others {
        if !analysis.has_errors() {
            break;
        }
        if !search.pays(analysis.program.size()) {
            // The results of the other readings are unknown.
            analysis.open.is_any = true;
            analysis.open.is_torn = true;
            analysis.open.unknown.clear();
            analysis
                .diagnostics
                .retain(|d| d.severity != Severity::Error);
            break;
        }
        let Checked {
            diagnostics: found,
            open,
            ..
        } = analyze_within(other, search);
        let is_reported = |d: &Diagnostic| found.iter().any(|o| o.span.touches(d.span));
        let (diagnostics, unclear): (Vec<_>, Vec<_>) = std::mem::take(&mut analysis.diagnostics)
            .into_iter()
            .partition(|d| d.severity != Severity::Error || is_reported(d));
        analysis.diagnostics = diagnostics;
        let unclear = unclear.iter().map(|d| d.span);
        analysis.open.unclear.extend(unclear);
        keep_common(&mut analysis.open.unknown, &open.unknown);
    }
    Some(analysis)
}

/// Keeps the names that are unknown in every reading of a shader fragment; a name of one stage or
/// version is known in that reading.
pub fn confirm_unknown(readings: &[Unit], unknown: &mut Vec<Diagnostic>) {
    for reading in readings {
        if unknown.is_empty() {
            return;
        }
        keep_common(unknown, &analyze(reading).open.unknown);
    }
}

fn keep_common(unknown: &mut Vec<Diagnostic>, others: &[Diagnostic]) {
    unknown.retain(|d| others.iter().any(|o| o.span == d.span));
}

/// Checks one shader and attributes its errors.
pub fn analyze(unit: &Unit) -> Checked {
    analyze_within(unit, &mut Search::for_text())
}

/// As [`analyze`], with a search budget shared between several readings of a text.
pub fn analyze_within(unit: &Unit, search: &mut Search) -> Checked {
    let Checked {
        program,
        diagnostics,
        open,
        completeness,
    } = analyze_single_pass(unit, search);
    let mut diagnostics = attribute(unit, &program, diagnostics, search);
    // The entry function may be inside an `#if` without `#endif`.
    if diagnostics
        .iter()
        .any(|d| d.is(error::UNBALANCED_CONDITIONAL))
    {
        diagnostics.retain(|d| !d.is(error::MISSING_MAIN));
    }
    if unit.completeness != Completeness::Complete {
        keep_own(unit.sources, &mut diagnostics);
    }
    limit(&mut diagnostics);
    Checked {
        program,
        diagnostics,
        open,
        completeness,
    }
}

/// Keeps findings in the user's text and removes references to the host's text.
fn keep_own(sources: &Sources, diagnostics: &mut Vec<Diagnostic>) {
    let is_user = |span: Span| {
        let file = sources.file_at(span.start);
        file.is_some_and(|f| f.role == Role::User && f.span().contains(span))
    };
    diagnostics.retain(|d| is_user(d.span));
    for diagnostic in diagnostics {
        diagnostic.labels.retain(|l| is_user(l.span));
    }
}

fn limit(diagnostics: &mut Vec<Diagnostic>) {
    if diagnostics.len() >= MAX_ERRORS {
        diagnostics.truncate(MAX_ERRORS);
        if let Some(last) = diagnostics.last_mut() {
            last.notes.push(format!(
                "only the first {MAX_ERRORS} errors are reported; there may be more"
            ));
        }
    }
}
