//! JUnit XML: one suite per file, one failed case per error or warning. An info is a case that
//! passes with output; a file without findings is one case that passes.

use super::human::render;
use super::others::placed_message;
use super::place::xml;
use shaderlint_diagnostic::{Diagnostic, Severity};
use shaderlint_text::Sources;
use std::io::{self, Write};

/// Writes everything before the first file.
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
    let name = xml(name);
    writeln!(
        out,
        "  <testsuite name=\"{name}\" tests=\"{}\" failures=\"{}\" errors=\"0\">",
        found.len().max(1),
        found.iter().filter(|d| is_failure(d)).count()
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
            "    <testcase name=\"{} at {line}:{column}\" classname=\"{name}\">",
            d.rule
        )?;
        let text = render(sources, d);
        let text = xml(text.trim_end());
        if is_failure(d) {
            let (kind, message) = (d.severity.name(), xml(&placed_message(sources, d)));
            writeln!(
                out,
                "      <failure type=\"{kind}\" message=\"{message}\">{text}</failure>"
            )?;
        } else {
            writeln!(out, "      <system-out>{text}</system-out>")?;
        }
        out.write_all(b"    </testcase>\n")?;
    }
    out.write_all(b"  </testsuite>\n")
}

fn is_failure(d: &Diagnostic) -> bool {
    d.severity != Severity::Info
}

/// Writes everything after the last file.
pub fn end(out: &mut impl Write) -> io::Result<()> {
    out.write_all(b"</testsuites>\n")
}
