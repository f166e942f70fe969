//! Checkstyle XML. Columns count characters.

use super::others::{placed_message, with_advice};
use super::place::{region, xml};
use shaderlint_diagnostic::Diagnostic;
use shaderlint_text::Sources;
use std::io::{self, Write};

/// Writes everything before the first file.
pub fn begin(out: &mut impl Write) -> io::Result<()> {
    out.write_all(b"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<checkstyle version=\"4.3\">\n")
}

/// Writes the findings of one file.
pub fn file(
    out: &mut impl Write,
    name: &str,
    sources: &Sources,
    found: &[Diagnostic],
) -> io::Result<()> {
    writeln!(out, "  <file name=\"{}\">", xml(name))?;
    for d in found {
        let (line, column) = region(sources, d.span).map_or((1, 1), |(s, _)| (s.line, s.column));
        writeln!(
            out,
            "    <error line=\"{line}\" column=\"{column}\" severity=\"{}\" message=\"{}\" source=\"shaderlint.{}\"/>",
            d.severity.name(),
            xml(&with_advice(placed_message(sources, d), d)),
            d.rule
        )?;
    }
    out.write_all(b"  </file>\n")
}

/// Writes everything after the last file.
pub fn end(out: &mut impl Write) -> io::Result<()> {
    out.write_all(b"</checkstyle>\n")
}
