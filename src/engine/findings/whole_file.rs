//! Findings about a file as a whole, and what is reported of all findings.

use super::stage::{FileCheck, ask_first};
use crate::options::Desktop;
use crate::text::embedded;
use shaderlint_detect::embed::DocumentLanguage;
use shaderlint_detect::kind::{FileKind, ShaderLanguage};
use shaderlint_diagnostic::{Diagnostic, Severity, error};
use shaderlint_text::{Encoding, Span};

/// How tests in JavaScript expect an exception: Jest, Vitest, Jasmine and Playwright, Chai, Node.js and QUnit.
const EXPECTATIONS: &[&str] = &[".toThrow", ".to.throw", ".throws("];

/// How test cases in JavaScript start: Jest, Vitest, Jasmine, Mocha and Playwright.
const CASES: &[&str] = &["describe(", "it(", "test("];

/// Adds what was found when the file was read.
pub fn add_problems(file: &mut FileCheck) {
    file.report.diagnostics.append(&mut file.problems);
}

/// Reports invalid UTF-8, unless another finding is at the same position. Comments may contain
/// invalid bytes.
pub fn report_damage(file: &mut FileCheck) {
    let report = &mut file.report;
    let text = report.file.and_then(|id| report.sources.file(id));
    let (Encoding::Damaged(offset), Some(text)) = (file.encoding, text) else {
        return;
    };
    let start = text.base + offset;
    if report.diagnostics.iter().any(|d| d.span.start == start) {
        return;
    }
    let span = Span::new(start, start + '\u{fffd}'.len_utf8() as u32);
    let kind = error::INVALID_ENCODING;
    report.diagnostics.push(
        Diagnostic::of(kind, Severity::Warning, span, "invalid UTF-8")
            .note("browsers replace invalid bytes with U+FFFD"),
    );
}

/// Drops the findings in files whose findings are reported elsewhere or not at all.
pub fn drop_hushed(file: &mut FileCheck) {
    let report = &mut file.report;
    let sources = &report.sources;
    report
        .diagnostics
        .retain(|d| file.hushed.admits(sources, d));
}

/// Sorts the findings, and keeps one of those that several shaders share.
pub fn sort(file: &mut FileCheck) {
    let found = &mut file.report.diagnostics;
    found.sort_by_key(|d| (d.span.start, d.span.end));
    found.dedup_by(|a, b| (a.span, a.rule, &a.message) == (b.span, b.rule, &b.message));
}

/// Drops the infos that are only counted, and counts them.
pub fn count_infos(file: &mut FileCheck) {
    let settings = &file.context.options.settings;
    let report = &mut file.report;
    report.diagnostics.retain(|d| {
        let is_shown = settings.shows(d.rule, d.severity);
        report.counted_infos += usize::from(!is_shown && settings.reports(d.rule));
        is_shown
    });
}

/// Fixes of desktop GLSL that is checked as GLSL ES 3.00 are not applied without being asked for.
pub fn ask_before_porting(file: &mut FileCheck) {
    let is_desktop = file.kind == FileKind::Foreign(ShaderLanguage::Desktop);
    if is_desktop && file.context.options.desktop == Desktop::Port {
        ask_first(&mut file.report.diagnostics);
    }
}

/// Lowers errors in scripts with test cases: their texts are what the tested program reads, as it is.
pub fn lower_in_tests(file: &mut FileCheck) {
    let own = file.report.file.and_then(|id| file.report.sources.file(id));
    let has_cases = |text: &str| CASES.iter().any(|word| text.contains(word));
    let is_test = |text: &str| text.contains("expect(") && has_cases(text);
    let is_script = file.kind == FileKind::Holds(DocumentLanguage::Script);
    if !is_script || !own.is_some_and(|own| is_test(&own.text)) {
        return;
    }
    let all = file.report.diagnostics.iter_mut();
    for d in all.filter(|d| d.severity == Severity::Error) {
        d.severity = Severity::Warning;
        d.notes
            .push("right if the test needs the text as it is".to_string());
    }
}

/// A script that expects an exception tests what happens with a faulty shader, which must stay as it is: the
/// fixes become help. Errors of a shader in the statement that expects it are meant.
pub fn keep_expected_faults(file: &mut FileCheck) {
    let own = file.report.file.and_then(|id| file.report.sources.file(id));
    let expects = |text: &str| EXPECTATIONS.iter().any(|word| text.contains(word));
    let is_script = file.kind == FileKind::Holds(DocumentLanguage::Script);
    let Some(own) = own.filter(|own| is_script && expects(&own.text)) else {
        return;
    };
    let is_meant = |d: &Diagnostic| {
        let at = d.span.start.saturating_sub(own.base) as usize;
        let mut all = file.report.embedded.iter();
        let shader = all.find(|e| (e.start..e.end()).contains(&at));
        let rest = shader.and_then(|e| own.text.get(e.end()..)).unwrap_or("");
        expects(rest.split([';', '\n']).next().unwrap_or(""))
    };
    for d in &mut file.report.diagnostics {
        if let Some(fix) = d.fix.take() {
            d.help.push(fix.title);
            d.notes
                .push("not fixed: the script expects an exception".into());
        }
        if is_meant(d) {
            d.severity = Severity::Info;
        }
    }
}

/// Notes which fixes of embedded shaders cannot be written.
pub fn note_fixes(file: &mut FileCheck) {
    let mut found = std::mem::take(&mut file.report.diagnostics);
    if !file.report.embedded.is_empty() {
        let unwritable = found.iter_mut().filter(|d| d.fix.is_some());
        unwritable
            .filter(|d| !file.report.can_apply(d))
            .for_each(embedded::note_fix);
    }
    file.report.diagnostics = found;
}
