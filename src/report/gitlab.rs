//! GitLab code quality report.

use super::fingerprint::digest;
use super::others::{placed_message, with_advice};
use super::place::{path, region};
use serde_json::json;
use shaderlint_diagnostic::{Diagnostic, Severity};
use shaderlint_text::Sources;
use std::io::{self, Write};

/// Writes one finding.
pub fn write(
    out: &mut impl Write,
    sources: &Sources,
    d: &Diagnostic,
    fingerprint: &str,
    root: &str,
) -> io::Result<()> {
    let severity = match d.severity {
        Severity::Error => "critical",
        Severity::Warning => "minor",
        Severity::Info => "info",
    };
    let begin = region(sources, d.span).map_or(1, |(start, _)| start.line);
    let path = path(sources, d.span, root);
    // GitLab merges findings with the same fingerprint, even across files.
    let fingerprint = digest([path, fingerprint]);
    let value = json!({
        "description": with_advice(placed_message(sources, d), d),
        "check_name": d.rule,
        "fingerprint": fingerprint,
        "severity": severity,
        "location": {"path": path, "lines": {"begin": begin}}
    });
    serde_json::to_writer(out, &value)?;
    Ok(())
}
