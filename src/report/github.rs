//! Workflow commands of GitHub Actions, which become annotations. Columns count UTF-16 units, as
//! the editor of GitHub does.

use super::others::placed_message;
use super::place::{path, region};
use shaderlint_diagnostic::{Diagnostic, Severity};
use shaderlint_text::Sources;
use std::io::{self, Write};

/// Writes one finding.
pub fn write(
    out: &mut impl Write,
    sources: &Sources,
    d: &Diagnostic,
    root: &str,
) -> io::Result<()> {
    let command = match d.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Info => "notice",
    };
    write!(
        out,
        "::{command} file={}",
        property(path(sources, d.span, root))
    )?;
    if let Some((start, end)) = region(sources, d.span) {
        write!(out, ",line={},endLine={}", start.line, end.line)?;
        // GitHub would interpret the columns of several lines as columns of the last line.
        if start.line == end.line {
            write!(out, ",col={},endColumn={}", start.utf16, end.utf16)?;
        }
    }
    let message = std::iter::once(placed_message(sources, d))
        .chain(d.notes.iter().chain(&d.help).cloned())
        .chain(d.fix.iter().map(|fix| fix.title.clone()))
        .collect::<Vec<_>>()
        .join("\n");
    writeln!(out, ",title={}::{}", property(d.rule), data(&message))
}

/// Escapes the message after `::`.
fn data(text: &str) -> String {
    text.replace('%', "%25")
        .replace('\r', "%0D")
        .replace('\n', "%0A")
}

/// Escapes the value of a property.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}
