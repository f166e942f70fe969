//! GitLab's code quality report.

use super::{path, placed_message, region};
use crate::diagnostic::{Diagnostic, Severity};
use crate::text::Sources;
use serde_json::json;
use std::io::{self, Write};

/// Writes one finding.
pub fn write(
    out: &mut impl Write,
    sources: &Sources,
    d: &Diagnostic,
    fingerprint: &str,
) -> io::Result<()> {
    let severity = match d.severity {
        Severity::Error => "critical",
        Severity::Warning => "minor",
        Severity::Info => "info",
    };
    let begin = region(sources, d.span).map_or(1, |(start, _)| start.line);
    let value = json!({
        "description": placed_message(sources, d),
        "check_name": d.rule,
        "fingerprint": fingerprint,
        "severity": severity,
        "location": {"path": path(sources, d.span), "lines": {"begin": begin}}
    });
    serde_json::to_writer(out, &value)?;
    Ok(())
}
