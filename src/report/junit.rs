//! JUnit XML: a suite a file, a failed case a finding. A file without findings is a case that passed.

use super::xml::escape;
use super::{placed_message, render};
use crate::diagnostic::Diagnostic;
use crate::text::Sources;
use std::io::{self, Write};

/// Writes what comes first.
pub fn begin(out: &mut impl Write) -> io::Result<()> {
    out.write_all(b"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"shaderlint\">\n")
}

/// Writes the findings of one file.
pub fn file(
    out: &mut impl Write,
    name: &str,
    sources: &Sources,
    found: &[Diagnostic],
) -> io::Result<()> {
    let name = escape(name);
    writeln!(
        out,
        "  <testsuite name=\"{name}\" tests=\"{}\" failures=\"{}\" errors=\"0\">",
        found.len().max(1),
        found.len()
    )?;
    if found.is_empty() {
        writeln!(
            out,
            "    <testcase name=\"{name}\" classname=\"shaderlint\"/>"
        )?;
    }
    for d in found {
        let position = sources
            .file_at(d.span.start)
            .map(|f| f.position(d.span.start));
        let (line, column) = position.map_or((1, 1), |p| (p.line, p.column));
        writeln!(
            out,
            "    <testcase name=\"{} at {line}:{column}\" classname=\"{name}\">\n      \
             <failure type=\"{}\" message=\"{}\">{}</failure>\n    </testcase>",
            d.rule,
            d.severity.name(),
            escape(&placed_message(sources, d)),
            escape(render(sources, d).trim_end())
        )?;
    }
    out.write_all(b"  </testsuite>\n")
}

/// Writes what comes last.
pub fn end(out: &mut impl Write) -> io::Result<()> {
    out.write_all(b"</testsuites>\n")
}
