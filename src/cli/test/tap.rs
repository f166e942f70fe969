//! TAP, the Test Anything Protocol, version 14.

use super::outcome::{Status, Tally, TestRow};
use std::fmt::Write;

/// The report: one test point per test, with a block of YAML for what failed.
pub fn tap(tally: &Tally) -> String {
    let mut text = format!("TAP version 14\n1..{}\n", tally.tests.len());
    for (number, row) in (1..).zip(&tally.tests) {
        point(&mut text, number, row);
    }
    for note in &tally.notes {
        let _ = writeln!(text, "# note: {}", one_line(note));
    }
    text
}

fn point(text: &mut String, number: usize, row: &TestRow) {
    let result = match row.status {
        Status::Passed | Status::Recorded => "ok",
        Status::Failed | Status::ExpectedFailure => "not ok",
    };
    let title = one_line(&row.title())
        .replace('\\', "\\\\")
        .replace('#', "\\#");
    let _ = write!(text, "{result} {number} - {title}");
    if row.status == Status::ExpectedFailure {
        let reason = row.expected_failure.as_deref().unwrap_or("");
        let _ = write!(text, " # TODO {}", one_line(reason));
    }
    text.push('\n');
    let mut block: Vec<(&str, String)> = Vec::new();
    block.extend(row.message.as_ref().map(|m| ("message", quoted(m))));
    if row.status == Status::Failed {
        block.push(("severity", "fail".to_string()));
    }
    block.extend(row.at.as_ref().map(|at| ("at", quoted(at))));
    block.extend(row.operations.map(|n| ("operations", n.to_string())));
    block.extend(row.baseline.map(|n| ("baseline", n.to_string())));
    block.extend(row.written.as_ref().map(|path| ("written", quoted(path))));
    let details = row.details();
    if block.is_empty() || row.status == Status::Passed && row.operations.is_none() {
        return;
    }
    text.push_str("  ---\n");
    for (key, value) in block {
        let _ = writeln!(text, "  {key}: {value}");
    }
    if !details.is_empty() {
        text.push_str("  details: |2\n");
        for line in details.lines() {
            let _ = writeln!(text, "    {line}");
        }
    }
    text.push_str("  ...\n");
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A string of YAML.
fn quoted(text: &str) -> String {
    serde_json::to_string(text).unwrap_or_default()
}
