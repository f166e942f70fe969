//! Analysis of one shader from files to findings, each at the position where the compiler reports
//! it.

use super::builtins::Stage;
use super::checker::{MAX_ERRORS, ParsedShader, check};
use super::chunk::{Completeness, Open, keep_certain};
use super::corrections::{Corrected, Recheck};
use super::explain::explain;
use super::root_cause::calls::gather;
use super::unit::{Checked, Unit};
use shaderlint_diagnostic::{Diagnostic, Facet, Severity, error};
use shaderlint_syntax::{ParseOptions, Preprocessed, Search, parse, preprocess};
use shaderlint_text::{Sources, Span};
use std::sync::Arc;

/// Checks one shader; every error is at the position where the compiler reports it.
pub(super) fn analyze_single_pass(unit: &Unit, search: &mut Search) -> Checked {
    let is_fragment = unit.stage == Stage::Fragment;
    let Preprocessed {
        mut tokens,
        names,
        version,
        mut diagnostics,
        gave_up,
    } = preprocess(unit.sources, unit.files, is_fragment);
    if gave_up {
        tokens.tokens.drain(..tokens.tokens.len().saturating_sub(1));
    }
    let language = ParseOptions {
        version,
        is_fragment,
    };
    let parse = parse(unit.sources, &mut tokens, &names, language, search);
    let translated = parse.translated;
    let has_errors = !diagnostics.is_empty()
        || !parse.diagnostics.is_empty()
        || !translated.diagnostics.is_empty();
    let parsed = ParsedShader {
        sources: Arc::clone(unit.sources),
        tokens,
        names,
        tree: parse.tree,
        version,
        has_errors,
        enough: MAX_ERRORS,
    };
    let corrected = Corrected {
        options: language,
        choices: parse.choices,
        original: parse.original,
        lost: translated.lost,
    };
    let looked = match gave_up {
        true => {
            let (program, problems) = check(parsed, unit.stage, unit.dialect, [None; 4], search);
            Recheck::new(program, Vec::new(), problems)
        }
        false => corrected.choose(parsed, parse.diagnostics, unit, search),
    };
    let program = looked.program;
    // If preprocessing stopped early, only the preprocessor's findings are certain.
    if !gave_up {
        // A lexer error inside a foreign construct is not a second mistake.
        let is_reported = |d: &Diagnostic| {
            let mut forms = translated.diagnostics.iter().map(|form| form.span);
            d.is(error::INVALID_NUMBER) && forms.any(|form| form != d.span && form.contains(d.span))
        };
        diagnostics.retain(|d| !is_reported(d));
        diagnostics.extend(looked.syntax);
        diagnostics.extend(explain(&program, &looked.problems));
        diagnostics.extend(translated.diagnostics);
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
