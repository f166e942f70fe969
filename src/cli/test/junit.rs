//! JUnit XML: one suite per file, as CI systems read it. Times are left out: results do not depend
//! on the machine.

use super::outcome::{Status, Tally, TestRow};
use crate::report::junit::{self, END, begin, failure, suite};
use crate::report::xml::XmlElement;

/// The report.
pub fn junit(tally: &Tally) -> String {
    let suites = tally.tests.chunk_by(|a, b| a.file == b.file).map(|rows| {
        let file = rows.first().map_or("", |row| &row.file);
        let of = |status| rows.iter().filter(|row| row.status == status).count();
        let (failed, skipped) = (of(Status::Failed), of(Status::ExpectedFailure));
        suite(file, rows.iter().map(case).collect(), failed, skipped)
    });
    let suites: String = suites.collect();
    format!("{}{suites}{END}", begin("shaderlint test"))
}

fn case(row: &TestRow) -> XmlElement {
    let name = if row.name.is_empty() {
        "file"
    } else {
        &row.name
    };
    let mut case = junit::case(&row.file, name).with("file", &row.file);
    if let Some(line) = row.at.as_deref().and_then(|at| at.rsplit(':').nth(1)) {
        case = case.with("line", line);
    }
    let property = |name: &str, value: &str| {
        let property = XmlElement::new("property").with("name", name);
        property.with("value", value)
    };
    let parameters = row.parameters.iter();
    let parameters = parameters.map(|p| property(&format!("parameter {}", p.name), &p.value));
    let operations = row
        .operations
        .map(|n| property("operations", &n.to_string()));
    let written = row.written.as_ref().map(|path| property("written", path));
    let properties: Vec<XmlElement> = parameters.chain(operations).chain(written).collect();
    if !properties.is_empty() {
        case = case.children([XmlElement::new("properties").children(properties)]);
    }
    match row.status {
        Status::Passed | Status::Recorded => case,
        Status::Failed => {
            let message = row.message.as_deref().unwrap_or("");
            case.children([failure("failure", message, &row.text())])
        }
        Status::ExpectedFailure => {
            let reason = row.expected_failure.as_deref().unwrap_or("");
            let why = format!("expected failure: {reason}");
            case.children([XmlElement::new("skipped").with("message", why)])
        }
    }
}
