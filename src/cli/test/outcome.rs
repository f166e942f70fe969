//! What came of tests, for people and for programs.

use super::args::TestFormat;
use super::difference::PictureDifference;
use serde::Serialize;

/// What came of a test. Fields are only ever added.
#[derive(Clone, Debug, Serialize)]
pub struct TestRow {
    /// The file.
    pub file: String,
    /// The function, or the picture; empty where the file itself is wrong.
    pub name: String,
    /// Whether it passed.
    pub status: Status,
    /// Where it stands: `file:line:column`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<String>,
    /// What is to be said of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub message: Option<String>,
    /// What a function that failed compared, at the first pixel that is wrong.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub conditions: Vec<ConditionRow>,
    /// How far a picture is from the one that was blessed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub difference: Option<PictureDifference>,
    /// The picture that was written.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub written: Option<String>,
}

/// Whether a test passed.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// It did.
    Passed,
    /// It is a picture that was written.
    Blessed,
    /// It did not.
    Failed,
}

/// A comparison of a test.
#[derive(Clone, Debug, Serialize)]
pub struct ConditionRow {
    /// Where it stands: `file:line:column`.
    pub at: Option<String>,
    /// As it is written.
    pub text: String,
    /// What came of it.
    pub answer: String,
    /// What it compared.
    pub values: Vec<ValueRow>,
}

/// A side of a comparison.
#[derive(Clone, Debug, Serialize)]
pub struct ValueRow {
    /// As it is written.
    pub text: String,
    /// What it was.
    pub value: String,
}

/// All that came of a run.
#[derive(Default, Serialize)]
pub struct Tally {
    /// Of this form.
    pub schema: u32,
    /// How many tests passed, pictures that were blessed among them.
    pub passed: usize,
    /// How many did not.
    pub failed: usize,
    /// The whole shaders of which no picture was blessed.
    pub without_picture: Vec<String>,
    /// The tests.
    pub tests: Vec<TestRow>,
    /// What else is to be said.
    pub notes: Vec<String>,
}

impl TestRow {
    /// A test that passed.
    pub fn passed(file: &str, name: &str) -> TestRow {
        TestRow {
            file: file.to_string(),
            name: name.to_string(),
            status: Status::Passed,
            at: None,
            message: None,
            conditions: Vec::new(),
            difference: None,
            written: None,
        }
    }

    /// A test that did not, and why.
    pub fn failed(file: &str, name: &str, message: impl Into<String>) -> TestRow {
        TestRow {
            status: Status::Failed,
            message: Some(message.into()),
            ..TestRow::passed(file, name)
        }
    }

    /// How it is called.
    fn title(&self) -> String {
        match self.name.as_str() {
            "" => self.file.clone(),
            name => format!("{}: {name}", self.file),
        }
    }

    /// The line of a test.
    pub fn line(&self) -> String {
        let what = match self.status {
            Status::Passed => "ok",
            Status::Blessed => "blessed",
            Status::Failed => "FAILED",
        };
        format!("{} ... {what}\n", self.title())
    }

    /// What is said of a test that failed.
    fn text(&self) -> String {
        let at = self.at.as_ref().unwrap_or(&self.file);
        let name = match self.name.as_str() {
            "" => String::new(),
            name => format!("{name}: "),
        };
        let message = self.message.as_deref().unwrap_or("it failed");
        let mut text = format!("{at}: {name}{message}\n");
        for condition in &self.conditions {
            let line = condition.at.as_deref().and_then(|at| at.rsplit(':').nth(1));
            let line = line.map_or(String::new(), |line| format!("line {line}: "));
            let (own, answer) = (&condition.text, &condition.answer);
            text.push_str(&format!("  {line}`{own}` is {answer}\n"));
            let width = condition.values.iter().map(|v| v.text.chars().count());
            let width = width.max().unwrap_or(0);
            for ValueRow { text: own, value } in &condition.values {
                text.push_str(&format!("    {own:width$}  {value}\n"));
            }
        }
        text
    }
}

impl Tally {
    /// Takes over what came of tests.
    pub fn add(&mut self, rows: Vec<TestRow>) {
        for row in rows {
            match row.status {
                Status::Failed => self.failed += 1,
                Status::Passed | Status::Blessed => self.passed += 1,
            }
            self.tests.push(row);
        }
    }

    /// What is said at the end.
    pub fn text(&self, format: TestFormat) -> String {
        if format == TestFormat::Json {
            let text = serde_json::to_string_pretty(self).unwrap_or_default();
            return format!("{text}\n");
        }
        let failed = self.tests.iter().filter(|t| t.status == Status::Failed);
        let mut text: String = failed.map(|row| format!("\n{}", row.text())).collect();
        if !self.tests.is_empty() {
            text.push('\n');
        }
        text.push_str(&format!("{} passed, {} failed", self.passed, self.failed));
        match self.without_picture.len() {
            0 => {}
            1 => text.push_str("; 1 whole shader has no picture to compare with, --bless draws it"),
            n => text.push_str(&format!(
                "; {n} whole shaders have no picture to compare with, --bless draws them"
            )),
        }
        text.push('\n');
        text
    }
}
