//! Mistakes in the text rather than in the grammar: lost spaces and comment marks, entities of a
//! web page, the marks of a merge, notations of other languages.
//!
//! A parser sees them as several unrelated errors. Each is proved as macros are: the lines of the
//! errors are edited, and the edit is the cause if errors disappear and none appear.

mod comment;
mod conflict;
mod copy;
mod entity;
mod fence;
mod function;
mod join;
mod line;
mod notation;
mod space;
mod statement;
#[cfg(test)]
mod tests;
mod variable;
mod word;

use super::FaultyShader;
use super::candidate::RepairCandidate;
use line::FaultyLine;
use shaderlint_diagnostic::{Diagnostic, ErrorKind, Fix, error};
use shaderlint_text::{Edit, Span};

/// Maximum number of candidates for one shader.
const MAX_CANDIDATES: usize = 60;

impl FaultyShader<'_> {
    /// Candidate repairs of the text on the lines of errors, the most certain first.
    pub(super) fn text_repairs(&self) -> Vec<RepairCandidate> {
        // After code that is nested too deeply, the errors are consequences of where parsing ended.
        if self.errors.iter().any(|d| d.is(error::BROWSER_LIMIT)) {
            return Vec::new();
        }
        let lines = self.faulty_lines();
        let mut all = Vec::new();
        self.copies(&mut all);
        if let Some(line) = lines.first() {
            self.prose(line, &mut all);
        }
        for line in &lines {
            all.extend(self.conflict(line));
            all.extend(self.fences(line));
            all.extend(self.entities(line));
            self.pasted_marks(line, &mut all);
            self.comments(line, &mut all);
            self.spaces(line, &mut all);
            self.joins(line, &mut all);
            self.strays(line, &mut all);
            self.variables(line, &mut all);
            all.extend(self.methods(line));
            self.notations(line, &mut all);
            self.statements(line, &mut all);
            self.words(line, &mut all);
            self.functions(line, &mut all);
        }
        all.truncate(MAX_CANDIDATES);
        all
    }
}

/// A candidate whose fix writes another text.
fn replacement(
    kind: ErrorKind,
    span: Span,
    message: impl Into<String>,
    text: String,
) -> RepairCandidate {
    let title = format!("use `{text}`");
    candidate(kind, span, message, title, vec![Edit::replace(span, text)])
}

/// A candidate that is reported with its edits as a fix.
fn candidate(
    kind: ErrorKind,
    span: Span,
    message: impl Into<String>,
    title: impl Into<String>,
    edits: Vec<Edit>,
) -> RepairCandidate {
    let found = Diagnostic::error(kind, span, message);
    RepairCandidate::of_error(&found, Fix::suggestion(title, edits))
}

/// A candidate for a syntax error.
fn syntax(
    span: Span,
    message: impl Into<String>,
    title: impl Into<String>,
    edits: Vec<Edit>,
) -> RepairCandidate {
    candidate(error::SYNTAX_ERROR, span, message, title, edits)
}

/// A candidate for code of another language.
fn foreign(
    span: Span,
    message: impl Into<String>,
    title: impl Into<String>,
    edits: Vec<Edit>,
) -> RepairCandidate {
    candidate(error::FOREIGN_SYNTAX, span, message, title, edits)
}
