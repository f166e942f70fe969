//! Results of tests, for people and for programs.

use super::difference::ImageDifference;
use crate::text::number::short;
use serde::Serialize;

/// The result of one test. The JSON format may gain fields, but never loses any.
#[derive(Clone, Default, Debug, Serialize)]
pub struct TestRow {
    /// Name of the file.
    pub file: String,
    /// Name of the function or of the golden image; empty if the file itself is invalid.
    pub name: String,
    /// Whether the test passed.
    pub status: Status,
    /// Position of the test: `file:line:column`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<String>,
    /// The values of its parameters.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub parameters: Vec<ParameterRow>,
    /// Why the test failed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub message: Option<String>,
    /// Why the test is expected to fail.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expected_failure: Option<String>,
    /// The random values for which it fails.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub counterexample: Option<CounterexampleRow>,
    /// Operations of one call on average.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub operations: Option<f64>,
    /// The comparisons of a function that failed, at the first pixel with a wrong result.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub conditions: Vec<ConditionRow>,
    /// Difference to the golden image.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub difference: Option<ImageDifference>,
    /// Path of the image that was written.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub written: Option<String>,
}

/// The status of a test.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// The test passed.
    #[default]
    Passed,
    /// The golden image was written.
    #[serde(rename = "blessed")]
    Recorded,
    /// The test failed.
    Failed,
    /// The test failed, as expected.
    #[serde(rename = "expected-failure")]
    ExpectedFailure,
}

/// A parameter with its value.
#[derive(Clone, Debug, Serialize)]
pub struct ParameterRow {
    /// Name of the parameter.
    pub name: String,
    /// Value as GLSL.
    pub value: String,
}

/// Random values for which a test fails.
#[derive(Clone, Debug, Serialize)]
pub struct CounterexampleRow {
    /// Number of the case, from 0.
    pub case: u32,
    /// The simplest values that were found.
    pub values: Vec<ParameterRow>,
    /// The values of the case.
    pub first: Vec<ParameterRow>,
    /// The comment that makes a test of the simplest values.
    pub each: String,
}

/// A comparison in a test.
#[derive(Clone, Debug, Serialize)]
pub struct ConditionRow {
    /// Position of the comparison: `file:line:column`.
    pub at: Option<String>,
    /// Source text of the comparison.
    pub text: String,
    /// Result of the comparison.
    pub answer: String,
    /// The values of its operands.
    pub values: Vec<ValueRow>,
    /// The largest difference of the arguments of `approx`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub difference: Option<String>,
}

/// An operand of a comparison.
#[derive(Clone, Debug, Serialize)]
pub struct ValueRow {
    /// Source text of the operand.
    pub text: String,
    /// Value of the operand.
    pub value: String,
}

/// The results of a run.
#[derive(Default, Serialize)]
pub struct Tally {
    /// Version of the JSON format.
    pub schema: u32,
    /// Number of tests that passed, including golden images that were written.
    pub passed: usize,
    /// Number of tests that failed.
    pub failed: usize,
    /// Number of tests that failed as expected.
    pub expected_failures: usize,
    /// Complete shaders without a golden image.
    pub without_golden: Vec<String>,
    /// The results of the tests.
    pub tests: Vec<TestRow>,
    /// Notes about functions that look like tests.
    pub notes: Vec<String>,
}

impl ParameterRow {
    pub fn of((name, value): &(String, String)) -> ParameterRow {
        ParameterRow {
            name: name.clone(),
            value: value.clone(),
        }
    }

    fn text(&self) -> String {
        format!("{} = {}", self.name, self.value)
    }
}

impl TestRow {
    pub fn passed(file: &str, name: &str) -> TestRow {
        TestRow {
            file: file.to_string(),
            name: name.to_string(),
            ..TestRow::default()
        }
    }

    /// A test that failed with this message.
    pub fn failed(file: &str, name: &str, message: impl Into<String>) -> TestRow {
        TestRow {
            status: Status::Failed,
            message: Some(message.into()),
            ..TestRow::passed(file, name)
        }
    }

    /// The same test, if it is expected to fail.
    pub fn expected_to_fail(self, reason: &str) -> TestRow {
        let (status, message) = match self.status {
            Status::Failed => (Status::ExpectedFailure, self.message),
            _ => {
                let message = format!("passed, but is expected to fail: {reason}");
                (Status::Failed, Some(message))
            }
        };
        TestRow {
            status,
            message,
            expected_failure: Some(reason.to_string()),
            ..self
        }
    }

    /// Name of the file and the test.
    pub fn title(&self) -> String {
        match self.name.as_str() {
            "" => self.file.clone(),
            name => format!("{}: {name}", self.file),
        }
    }

    /// The line printed when the test ends.
    pub fn line(&self) -> String {
        let what = match self.status {
            Status::Passed => "ok",
            Status::Recorded => "blessed",
            Status::Failed => "FAILED",
            Status::ExpectedFailure => "expected failure",
        };
        let reason = self
            .expected_failure
            .as_ref()
            .filter(|_| self.status != Status::Failed);
        let reason = reason.map_or(String::new(), |reason| format!(" ({reason})"));
        let operations = self
            .operations
            .map_or(String::new(), |n| format!(", {} operations", short(n)));
        format!("{} ... {what}{reason}{operations}\n", self.title())
    }

    /// The details of a failed test.
    pub fn text(&self) -> String {
        let at = self.at.as_ref().unwrap_or(&self.file);
        let name = match self.name.as_str() {
            "" => String::new(),
            name => format!("{name}: "),
        };
        let message = self.message.as_deref().unwrap_or("failed");
        let mut text = format!("{at}: {name}{message}\n");
        text.push_str(&self.details());
        text
    }

    /// The values of its comparisons, and what fails.
    pub fn details(&self) -> String {
        let mut text = String::new();
        for condition in &self.conditions {
            let line = condition.at.as_deref().and_then(|at| at.rsplit(':').nth(1));
            let line = line.map_or(String::new(), |line| format!("line {line}: "));
            let (own, answer) = (&condition.text, &condition.answer);
            let difference = condition.difference.as_ref().filter(|_| answer != "true");
            let difference = difference.map_or(String::new(), |d| format!(", {d}"));
            text.push_str(&format!("  {line}`{own}` is {answer}{difference}\n"));
            let width = condition.values.iter().map(|v| v.text.chars().count());
            let width = width.max().unwrap_or(0);
            for ValueRow { text: own, value } in &condition.values {
                text.push_str(&format!("    {own:width$}  {value}\n"));
            }
        }
        if let Some(found) = &self.counterexample {
            let first: Vec<String> = found.first.iter().map(ParameterRow::text).collect();
            let (number, first) = (found.case + 1, first.join(", "));
            text.push_str(&format!("  first found as case {number}: {first}\n"));
            text.push_str(&format!("  to test these values: {}\n", found.each));
        }
        text
    }
}

impl Tally {
    /// Adds the results of tests.
    pub fn add(&mut self, rows: Vec<TestRow>) {
        for row in rows {
            match row.status {
                Status::Failed => self.failed += 1,
                Status::ExpectedFailure => self.expected_failures += 1,
                Status::Passed | Status::Recorded => self.passed += 1,
            }
            self.tests.push(row);
        }
    }

    /// The JSON object.
    pub fn json(&self) -> String {
        let text = serde_json::to_string_pretty(self).unwrap_or_default();
        format!("{text}\n")
    }

    /// The text after the last test: failures and totals.
    pub fn text(&self) -> String {
        let failed = self.tests.iter().filter(|t| t.status == Status::Failed);
        let mut text: String = failed.map(|row| format!("\n{}", row.text())).collect();
        if !self.tests.is_empty() {
            text.push('\n');
        }
        text.push_str(&format!("{} passed, {} failed", self.passed, self.failed));
        if self.expected_failures > 0 {
            text.push_str(&format!(", {} failed as expected", self.expected_failures));
        }
        match self.without_golden.len() {
            0 => {}
            1 => text.push_str("; 1 complete shader has no golden image, use --bless to create it"),
            n => text.push_str(&format!(
                "; {n} complete shaders have no golden image, use --bless to create them"
            )),
        }
        text.push('\n');
        text
    }
}
