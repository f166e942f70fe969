//! JUnit XML: one suite per file, as CI systems read it.

use super::outcome::{Status, Tally, TestRow};
use std::fmt::Write;

/// The report. Times are left out: results do not depend on the machine.
pub fn junit(tally: &Tally) -> String {
    let mut files: Vec<&str> = Vec::new();
    for row in &tally.tests {
        if !files.contains(&row.file.as_str()) {
            files.push(&row.file);
        }
    }
    let mut text = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let counts = counts(&tally.tests.iter().collect::<Vec<_>>());
    let _ = writeln!(text, "<testsuites name=\"shaderlint test\" {counts}>");
    for file in files {
        let rows = tally.tests.iter().filter(|row| row.file == file);
        suite(&mut text, file, &rows.collect::<Vec<_>>());
    }
    text.push_str("</testsuites>\n");
    text
}

fn counts(rows: &[&TestRow]) -> String {
    let of = |status: Status| rows.iter().filter(|row| row.status == status).count();
    let (failed, skipped) = (of(Status::Failed), of(Status::ExpectedFailure));
    let tests = rows.len();
    format!("tests=\"{tests}\" failures=\"{failed}\" errors=\"0\" skipped=\"{skipped}\"")
}

fn suite(text: &mut String, file: &str, rows: &[&TestRow]) {
    let (name, counts) = (escaped(file), counts(rows));
    let _ = writeln!(text, "  <testsuite name=\"{name}\" {counts}>");
    for row in rows {
        case(text, row);
    }
    text.push_str("  </testsuite>\n");
}

fn case(text: &mut String, row: &TestRow) {
    let name = match row.name.as_str() {
        "" => "file",
        name => name,
    };
    let (name, file) = (escaped(name), escaped(&row.file));
    let line = row.at.as_deref().and_then(|at| at.rsplit(':').nth(1));
    let line = line.map_or(String::new(), |line| format!(" line=\"{line}\""));
    let _ = write!(
        text,
        "    <testcase classname=\"{file}\" name=\"{name}\" file=\"{file}\"{line}"
    );
    let mut inner = String::new();
    properties(&mut inner, row);
    let message = escaped(row.message.as_deref().unwrap_or(""));
    match row.status {
        Status::Passed | Status::Recorded => {}
        Status::Failed => {
            let details = escaped(&row.text());
            let _ = writeln!(
                inner,
                "      <failure message=\"{message}\" type=\"failure\">{details}</failure>"
            );
        }
        Status::ExpectedFailure => {
            let reason = escaped(row.expected_failure.as_deref().unwrap_or(""));
            let _ = writeln!(
                inner,
                "      <skipped message=\"expected failure: {reason}\"/>"
            );
        }
    }
    match inner.is_empty() {
        true => text.push_str("/>\n"),
        false => {
            let _ = write!(text, ">\n{inner}    </testcase>\n");
        }
    }
}

fn properties(text: &mut String, row: &TestRow) {
    let parameters = row.parameters.iter();
    let mut all: Vec<(String, String)> = parameters
        .map(|p| (format!("parameter {}", p.name), p.value.clone()))
        .collect();
    let operations = row
        .operations
        .map(|n| ("operations".to_string(), n.to_string()));
    let baseline = row
        .baseline
        .map(|n| ("baseline".to_string(), n.to_string()));
    let written = row
        .written
        .clone()
        .map(|path| ("written".to_string(), path));
    all.extend(operations.into_iter().chain(baseline).chain(written));
    if all.is_empty() {
        return;
    }
    text.push_str("      <properties>\n");
    for (name, value) in all {
        let (name, value) = (escaped(&name), escaped(&value));
        let _ = writeln!(
            text,
            "        <property name=\"{name}\" value=\"{value}\"/>"
        );
    }
    text.push_str("      </properties>\n");
}

/// A text as content or attribute of XML. Characters that XML cannot contain are replaced.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\n' | '\t' => escaped.push(c),
            c if c < ' ' => escaped.push('\u{fffd}'),
            c => escaped.push(c),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_escaped() {
        assert_eq!(
            escaped("a < b && \"c\"\u{1}"),
            "a &lt; b &amp;&amp; &quot;c&quot;\u{fffd}"
        );
    }
}
