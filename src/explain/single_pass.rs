//! Analysis of one shader from files to findings, each at the position where the compiler reports
//! it.

use super::checked::Checked;
use super::chunk::{Open, keep_certain};
use super::messages::explain;
use super::root_cause::calls::gather;
use shaderlint_diagnostic::{Diagnostic, Facet, Severity, error};
use shaderlint_semantic::problem::MAX_ERRORS;
use shaderlint_semantic::{Completeness, Unit, check_shader};
use shaderlint_syntax::Search;
use shaderlint_text::{Sources, Span};

/// Checks one shader; every error is at the position where the compiler reports it.
pub(super) fn analyze_single_pass(unit: &Unit, search: &mut Search) -> Checked {
    let shader = check_shader(unit, search);
    let program = shader.program;
    let mut diagnostics = shader.preprocessing;
    // If preprocessing stopped early, only the preprocessor's findings are certain.
    if !shader.gave_up {
        // A lexer error inside a foreign construct is not a second mistake.
        let is_reported = |d: &Diagnostic| {
            let mut forms = shader.translated.iter().map(|form| form.span);
            d.is(error::INVALID_NUMBER) && forms.any(|form| form != d.span && form.contains(d.span))
        };
        diagnostics.retain(|d| !is_reported(d));
        diagnostics.extend(shader.syntax);
        diagnostics.extend(explain(&program, &shader.problems));
        diagnostics.extend(shader.translated);
    }
    if let Some(cut) = program.tokens.cut {
        report_cut(unit.sources, cut, &mut diagnostics);
    }
    let open = match unit.completeness {
        Completeness::Complete => Open::default(),
        completeness => keep_certain(&program, completeness, &mut diagnostics),
    };
    let mut diagnostics = gather(&program, diagnostics);
    diagnostics.sort_by_key(|d| (d.span.start, d.span.end));
    diagnostics.truncate(MAX_ERRORS);
    Checked {
        program,
        diagnostics,
        open,
        completeness: unit.completeness,
    }
}

/// A NUL ends the shader. If something is then missing, the NUL is the error; otherwise the rest of
/// the text is just ignored.
fn report_cut(sources: &Sources, cut: Span, diagnostics: &mut Vec<Diagnostic>) {
    let count = diagnostics.len();
    diagnostics.retain(|d| d.span.end < cut.start && !d.has(Facet::EndsEarly));
    let severity = if diagnostics.len() < count {
        Severity::Error
    } else {
        Severity::Warning
    };
    let rest = sources.file_at(cut.start).and_then(|file| {
        let from = (cut.end - file.base) as usize;
        file.text.get(from..)
    });
    if severity == Severity::Error || rest.is_some_and(|r| !r.trim_matches(['\0', '\n']).is_empty())
    {
        let message = "NUL character ends the shader";
        let kind = error::INVALID_CHARACTER;
        diagnostics.push(
            Diagnostic::of(kind, severity, cut, message)
                .note("the browser ignores everything after it"),
        );
    }
}
