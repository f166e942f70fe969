//! Converts findings to diagnostics of the protocol.

use super::buffers::TextBuffer;
use super::snapshot::Snapshot;
use gen_lsp_types::{
    Code, CodeDescription, Diagnostic as LspDiagnostic, DiagnosticRelatedInformation,
    DiagnosticSeverity, DiagnosticTag, Location, Range,
};
use shaderlint_diagnostic::{Diagnostic, Severity};
use shaderlint_ide::Document;
use shaderlint_lint::Check;
use shaderlint_rules::rule;
use shaderlint_text::Span;
use std::hash::{DefaultHasher, Hash, Hasher};

/// Rules about unnecessary code, which editors fade out.
const UNNECESSARY: [&str; 8] = [
    "dead-code",
    "dead-store",
    "identity-operation",
    "unused-function",
    "unused-macro",
    "unused-parameter",
    "unused-uniform",
    "unused-variable",
];
/// Rules about deprecated features, which editors strike through.
const DEPRECATED: [&str; 1] = ["legacy-extension"];

/// All findings of a document: with those of sample runs if they have finished, otherwise with
/// those of an earlier state where the surrounding text is unchanged.
pub fn diagnostics(snapshot: &Snapshot, buffer: &TextBuffer) -> Vec<LspDiagnostic> {
    if snapshot.leaves_out(buffer) {
        return Vec::new();
    }
    let document = snapshot.best(buffer);
    let mut converted = convert(snapshot, &document, Some(buffer));
    if buffer.ran.get().is_none() {
        converted.extend(carried(snapshot, buffer));
        converted.sort_by_key(|d| (d.range.start, d.range.end));
    }
    converted
}

/// The findings of an analysed document.
pub fn convert(
    snapshot: &Snapshot,
    document: &Document,
    buffer: Option<&TextBuffer>,
) -> Vec<LspDiagnostic> {
    let settings = &document.options.settings;
    let all = document.report.diagnostics.iter();
    let all = all.filter(|d| settings.reports(d.rule));
    let converted = all.filter_map(|d| one(snapshot, document, buffer, d));
    converted.collect()
}

/// Converts one finding; `None` if it belongs to another file.
pub fn one(
    snapshot: &Snapshot,
    document: &Document,
    buffer: Option<&TextBuffer>,
    diagnostic: &Diagnostic,
) -> Option<LspDiagnostic> {
    let range = |span: Span| match buffer {
        Some(buffer) => Some(buffer.lines(snapshot.columns()).range(span)),
        None => snapshot.with_lines(&document.path, |lines| lines.range(span)),
    };
    let mut related = related(snapshot, document, diagnostic);
    let mut message = message(diagnostic);
    let span = match document.report.in_input(diagnostic.span) {
        Some(span) => Span::new(span.start, span.end.max(span.start)),
        None => {
            let place = document.place(diagnostic.span)?;
            let location = snapshot.location(&place)?;
            let name = place
                .path
                .rsplit('/')
                .next()
                .unwrap_or(&place.path)
                .to_string();
            let line = location.range.start.line + 1;
            related.insert(0, info(location, diagnostic.message.clone()));
            message = format!("in `{name}`, line {line}: {message}");
            directive_of(document, &name)?
        }
    };
    let related = Some(related).filter(|r| !r.is_empty() && snapshot.client.related);
    Some(LspDiagnostic {
        range: range(span)?,
        severity: Some(match diagnostic.severity {
            Severity::Error => DiagnosticSeverity::Error,
            Severity::Warning => DiagnosticSeverity::Warning,
            Severity::Info => DiagnosticSeverity::Hint,
        }),
        code: Some(Code::String(diagnostic.rule.to_string())),
        code_description: snapshot
            .workspace()
            .page(diagnostic.rule)
            .map(|href| CodeDescription { href }),
        source: Some("shaderlint".to_string()),
        message: message.into(),
        tags: tags(diagnostic.rule),
        related_information: related,
        data: None,
    })
}

fn tags(rule: &str) -> Option<Vec<DiagnosticTag>> {
    if UNNECESSARY.contains(&rule) {
        return Some(vec![DiagnosticTag::Unnecessary]);
    }
    DEPRECATED
        .contains(&rule)
        .then(|| vec![DiagnosticTag::Deprecated])
}

/// The message with its notes and helps.
fn message(diagnostic: &Diagnostic) -> String {
    let mut text = diagnostic.message.clone();
    if !diagnostic.label.is_empty() && !text.contains(&diagnostic.label) {
        text.push_str(&format!(": {}", diagnostic.label));
    }
    for note in &diagnostic.notes {
        text.push_str(&format!("\nnote: {note}"));
    }
    for help in &diagnostic.help {
        text.push_str(&format!("\nhelp: {help}"));
    }
    text
}

fn info(location: Location, message: String) -> DiagnosticRelatedInformation {
    DiagnosticRelatedInformation { location, message }
}

/// The related locations of a finding.
fn related(
    snapshot: &Snapshot,
    document: &Document,
    diagnostic: &Diagnostic,
) -> Vec<DiagnosticRelatedInformation> {
    let labels = diagnostic.labels.iter();
    let labels = labels.map(|label| (label.span, label.message.clone()));
    let macros = diagnostic.macros.iter();
    let macros = macros.map(|m| (m.definition, format!("macro `{}` defined here", m.name)));
    let all = labels.chain(macros).filter_map(|(span, message)| {
        let location = snapshot.location(&document.place(span)?)?;
        Some(info(location, message))
    });
    all.collect()
}

/// The directive that includes a file of this name; the start of the text if there is none.
fn directive_of(document: &Document, name: &str) -> Option<Span> {
    let text = &document.text;
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let shown = line.trim();
        if shown.starts_with('#') && shown.contains("include") && shown.contains(name) {
            let start = at + (line.len() - line.trim_start().len()) as u32;
            return Some(Span::new(start, start + shown.len() as u32));
        }
        at += line.len() as u32;
    }
    Some(Span::at(0))
}

/// Findings of sample runs of an earlier state, where the surrounding text is unchanged. Otherwise
/// they would flicker while typing.
fn carried(snapshot: &Snapshot, buffer: &TextBuffer) -> Vec<LspDiagnostic> {
    let Some((text, ran)) = &buffer.earlier else {
        return Vec::new();
    };
    let Some(ran) = ran.get() else {
        return Vec::new();
    };
    let is_of_run = |name: &str| {
        rule(name).is_some_and(|r| r.checks.iter().any(|c| matches!(c, Check::Run(_))))
    };
    let (before, after) = same_ends(text, &buffer.text);
    let document = &ran.document;
    let settings = &document.options.settings;
    let all = document.report.diagnostics.iter();
    let all = all.filter(|d| is_of_run(d.rule) && settings.reports(d.rule));
    let moved = all.filter_map(|d| {
        let span = document.report.in_input(d.span)?;
        let shift = buffer.text.len() as i64 - text.len() as i64;
        let span = match span {
            span if span.end <= before => span,
            span if span.start >= text.len() as u32 - after => Span::new(
                u32::try_from(i64::from(span.start) + shift).ok()?,
                u32::try_from(i64::from(span.end) + shift).ok()?,
            ),
            _ => return None,
        };
        let converted = one(snapshot, document, None, d)?;
        let range: Range = buffer.lines(snapshot.columns()).range(span);
        Some(LspDiagnostic {
            range,
            // Related locations would refer to the earlier text.
            related_information: None,
            ..converted
        })
    });
    moved.collect()
}

/// The lengths in bytes of the common prefix and suffix of two texts.
fn same_ends(a: &str, b: &str) -> (u32, u32) {
    let before = a.bytes().zip(b.bytes()).take_while(|(a, b)| a == b).count();
    let most = a.len().min(b.len()) - before;
    let after = a.bytes().rev().zip(b.bytes().rev()).take(most);
    let after = after.take_while(|(a, b)| a == b).count();
    (before as u32, after as u32)
}

/// A result id, by which the client detects unchanged diagnostics.
pub fn result_id(converted: &[LspDiagnostic]) -> String {
    let mut hasher = DefaultHasher::new();
    for one in converted {
        serde_json::to_string(one)
            .unwrap_or_default()
            .hash(&mut hasher);
    }
    format!("{:016x}", hasher.finish())
}

#[cfg(test)]
mod tests {
    use super::*;
    use shaderlint_rules::RULES;

    #[test]
    fn tagged_rules_exist() {
        for name in UNNECESSARY.iter().chain(&DEPRECATED) {
            assert!(RULES.iter().any(|r| r.name == *name), "{name}");
        }
    }

    #[test]
    fn common_prefixes_and_suffixes_are_measured() {
        assert_eq!(same_ends("abcd", "abXcd"), (2, 2));
        assert_eq!(same_ends("aa", "aaa"), (2, 0));
        assert_eq!(same_ends("", "x"), (0, 0));
    }
}
