//! Findings about configurations, published for their own files.

use super::snapshot::Snapshot;
use gen_lsp_types::{Diagnostic, DiagnosticSeverity, PublishDiagnosticsParams, Range};
use shaderlint_engine::config::ConfigProblem;
use shaderlint_text::Span;

/// The findings of a configuration; none if it is valid.
pub fn config_findings(
    snapshot: &Snapshot,
    path: &str,
    finding: Option<&ConfigProblem>,
) -> PublishDiagnosticsParams {
    let diagnostic = finding.map(|finding| Diagnostic {
        range: range(snapshot, path, finding),
        severity: Some(DiagnosticSeverity::Error),
        source: Some("shaderlint".to_string()),
        message: finding.message.clone().into(),
        ..Diagnostic::default()
    });
    PublishDiagnosticsParams {
        uri: snapshot.uri(path),
        version: None,
        diagnostics: diagnostic.into_iter().collect(),
    }
}

/// From the place of a finding to the end of its line.
fn range(snapshot: &Snapshot, path: &str, finding: &ConfigProblem) -> Range {
    let (line, column) = finding.at.unwrap_or((1, 1));
    let range = snapshot.with_lines(path, |lines| {
        let (start, end) = lines.index.bounds(
            lines.index.start(line).unwrap_or(0),
            lines.text.len() as u32,
        );
        let text = lines.text.get(start as usize..end as usize).unwrap_or("");
        let text = text.trim_end();
        let before = text.chars().take(column.saturating_sub(1) as usize);
        let before: usize = before.map(char::len_utf8).sum();
        lines.range(Span::new(start + before as u32, start + text.len() as u32))
    });
    range.unwrap_or_default()
}
