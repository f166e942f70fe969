//! One line per finding: `path:line:column: severity[rule]: message; help`.

use super::others::{full_message, with_advice};
use super::place::location_name;
use shaderlint_diagnostic::Diagnostic;
use shaderlint_text::Sources;
use std::io::{self, Write};

/// Writes one finding.
pub fn write(out: &mut impl Write, sources: &Sources, diagnostic: &Diagnostic) -> io::Result<()> {
    let span = diagnostic.span;
    let position = sources
        .file_at(span.start)
        .map(|f| f.shown_position(span.start));
    let (line, column) = position.map_or((1, 1), |p| (p.line, p.column));
    writeln!(
        out,
        "{}:{line}:{column}: {}[{}]: {}",
        location_name(sources, span),
        diagnostic.severity.name(),
        diagnostic.rule,
        with_advice(full_message(sources, diagnostic), diagnostic)
    )
}
