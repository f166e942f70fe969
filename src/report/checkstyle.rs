//! Checkstyle XML. Columns count characters.

use super::others::{placed_message, with_advice};
use super::place::region;
use super::xml::XmlElement;
use shaderlint_diagnostic::Diagnostic;
use shaderlint_text::Sources;

/// Everything before the first file.
pub const BEGIN: &str =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<checkstyle version=\"4.3\">\n";

/// Everything after the last file.
pub const END: &str = "</checkstyle>\n";

/// The findings of one file.
pub fn file(name: &str, sources: &Sources, found: &[Diagnostic]) -> String {
    let errors = found.iter().map(|d| {
        let (line, column) = region(sources, d.span).map_or((1, 1), |(s, _)| (s.line, s.column));
        let message = with_advice(placed_message(sources, d), d);
        let error = XmlElement::new("error")
            .with("line", line)
            .with("column", column);
        let error = error.with("severity", d.severity.name());
        let error = error.with("message", message);
        error.with("source", format!("shaderlint.{}", d.rule))
    });
    format!(
        "{:2}",
        XmlElement::new("file").with("name", name).children(errors)
    )
}
