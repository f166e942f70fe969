//! JUnit XML: one suite per file, one failed case per error or warning. An info is a case that
//! passes with output; a file without findings is one case that passes.

use super::human::render;
use super::others::placed_message;
use super::xml::XmlElement;
use shaderlint_diagnostic::{Diagnostic, Severity};
use shaderlint_text::Sources;

/// Everything before the first suite.
pub fn begin(name: &str) -> String {
    format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{name}\">\n")
}

/// The suite of a file; the last two arguments count its cases that failed and were skipped.
pub fn suite(name: &str, cases: Vec<XmlElement>, failed: usize, skipped: usize) -> String {
    let suite = XmlElement::new("testsuite").with("name", name);
    let suite = suite.with("tests", cases.len()).with("failures", failed);
    let suite = suite.with("errors", 0).with("skipped", skipped);
    format!("{:2}", suite.children(cases))
}

/// A case that passed.
pub fn case(class: &str, name: &str) -> XmlElement {
    let case = XmlElement::new("testcase").with("classname", class);
    case.with("name", name)
}

/// Why a case failed.
pub fn failure(kind: &str, message: &str, text: &str) -> XmlElement {
    let failure = XmlElement::new("failure").with("type", kind);
    failure.with("message", message).text(text)
}

/// Everything after the last suite.
pub const END: &str = "</testsuites>\n";

/// The findings of one file.
pub(super) fn file(name: &str, sources: &Sources, found: &[Diagnostic]) -> String {
    let failures = found.iter().filter(|d| d.severity != Severity::Info);
    let cases = match found {
        [] => vec![case("shaderlint", name)],
        found => found.iter().map(|d| finding(name, sources, d)).collect(),
    };
    suite(name, cases, failures.count(), 0)
}

fn finding(name: &str, sources: &Sources, d: &Diagnostic) -> XmlElement {
    let file = sources.file_at(d.span.start);
    let position = file.map(|f| f.shown_position(d.span.start));
    let (line, column) = position.map_or((1, 1), |p| (p.line, p.column));
    let text = render(sources, d);
    let content = match d.severity {
        Severity::Info => XmlElement::new("system-out").text(text.trim_end()),
        severity => {
            let message = placed_message(sources, d);
            failure(severity.name(), &message, text.trim_end())
        }
    };
    case(name, &format!("{} at {line}:{column}", d.rule)).children([content])
}
