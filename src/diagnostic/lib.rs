//! Findings as data, independent of colour, line numbers and output format.

mod code;

pub use code::{Certainty, ERRORS, ErrorKind, Facet, Lack, error};

use serde::{Deserialize, Serialize};
use shaderlint_text::{Edit, Span};
use std::sync::Arc;

/// Severity of a finding.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
pub enum Severity {
    /// Useful to know.
    Info,
    /// The shader compiles but probably does not do what was intended.
    Warning,
    /// The browser's WebGL2 compiler rejects the shader.
    Error,
}

impl Severity {
    /// The word used in every output format.
    pub const fn name(self) -> &'static str {
        match self {
            Severity::Info => "info",
            Severity::Warning => "warning",
            Severity::Error => "error",
        }
    }
}

/// An annotation of a source span.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Label {
    /// The annotated span.
    pub span: Span,
    /// Text of the annotation: lower case, no full stop.
    pub message: String,
}

/// Whether a fix can be applied without review.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Serialize, Deserialize)]
pub enum Applicability {
    /// Keeps the output of the shader, or is the only way to make it compile.
    Safe,
    /// Probably intended, but the output may change.
    Unsafe,
}

impl Applicability {
    /// The word used in machine-readable formats.
    pub const fn name(self) -> &'static str {
        match self {
            Applicability::Safe => "safe",
            Applicability::Unsafe => "unsafe",
        }
    }
}

/// A fix for a finding. Its edits never overlap.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Fix {
    /// What it does, as an imperative: "use `1.0`".
    pub title: String,
    /// Whether it can be applied without review.
    pub applicability: Applicability,
    /// The edits; they must be applied together.
    pub edits: Vec<Edit>,
}

impl Fix {
    /// A fix that can be applied without review.
    pub fn safe(title: impl Into<String>, edits: Vec<Edit>) -> Fix {
        Fix {
            title: title.into(),
            applicability: Applicability::Safe,
            edits,
        }
    }

    /// A safe fix that replaces the text under `span` with `text`.
    pub fn safe_replacement(span: Span, text: impl Into<String>) -> Fix {
        let text = text.into();
        Fix::safe(format!("use `{text}`"), vec![Edit::replace(span, text)])
    }

    /// A fix that needs review and replaces the text under `span` with `text`.
    pub fn suggested_replacement(span: Span, text: impl Into<String>) -> Fix {
        let text = text.into();
        Fix::suggestion(format!("use `{text}`"), vec![Edit::replace(span, text)])
    }

    /// A fix that needs review.
    pub fn suggestion(title: impl Into<String>, edits: Vec<Edit>) -> Fix {
        Fix {
            title: title.into(),
            applicability: Applicability::Unsafe,
            edits,
        }
    }
}

/// A macro call that produced the code in question.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct MacroUse {
    /// Name of the macro.
    pub name: String,
    /// The call: from the macro's name to the closing parenthesis.
    pub call: Span,
    /// The name in the `#define`.
    pub definition: Span,
}

/// Where a finding is documented.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub enum Origin {
    /// A compile error; `rules/errors/NAME.md`.
    Compiler,
    /// A lint rule; `rules/NAME.md`.
    Rule,
    /// A message of the report itself about omitted findings; `README.md`.
    Report,
}

/// What a syntax error is about, for use by code; messages are for people only.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Subject {
    /// Anything else.
    #[default]
    Other,
    /// A missing `}`.
    MissingClose,
    /// A misplaced brace, or a missing `{`.
    Brace,
    /// A statement outside a function.
    OuterStatement,
    /// A function header without a return type.
    UntypedFunction,
    /// Whitespace or comments before `#version`.
    BlankFront,
}

impl Subject {
    /// Whether it is about braces, which affect the structure of the following code.
    pub const fn is_brace(self) -> bool {
        matches!(self, Subject::MissingClose | Subject::Brace)
    }
}

/// One finding. Serialized, it has what is printed and does not refer to a table.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Diagnostic {
    /// Name of the rule or error, also the name of its page.
    #[serde(skip)]
    pub rule: &'static str,
    /// Kind of compile error, for use by code; `None` for lint rules.
    #[serde(skip)]
    pub kind: Option<ErrorKind>,
    /// Whether it is from the compiler, a lint rule or the report.
    pub origin: Origin,
    /// Info, warning or error.
    pub severity: Severity,
    /// Title: what is wrong, in lower case, without a full stop, names in backticks.
    pub message: String,
    /// What a syntax error is about.
    #[serde(skip)]
    pub subject: Subject,
    /// Primary span.
    pub span: Span,
    /// Annotation of the primary span; may be empty.
    pub label: String,
    /// Secondary spans with annotations.
    pub labels: Vec<Label>,
    /// Other places of the same mistake, with the messages that they would have on their own.
    #[serde(skip)]
    pub others: Vec<Label>,
    /// Explanations: the rule of the language, or evidence.
    pub notes: Vec<String>,
    /// Suggestions, in words and code.
    pub help: Vec<String>,
    /// The macro calls that produced the code, innermost first.
    pub macros: Vec<MacroUse>,
    /// How to fix it automatically.
    pub fix: Option<Fix>,
    /// For a shader fragment: the hosts assumed to complete it.
    #[serde(skip)]
    pub part: Option<Arc<[String]>>,
}

impl Diagnostic {
    /// Creates a compile error; `kind` is one of [`error`].
    pub fn error(kind: ErrorKind, span: Span, message: impl Into<String>) -> Diagnostic {
        Diagnostic::of(kind, Severity::Error, span, message)
    }

    /// Creates a finding of any severity about a possible compile error; `kind` is one of
    /// [`error`].
    pub fn of(
        kind: ErrorKind,
        severity: Severity,
        span: Span,
        message: impl Into<String>,
    ) -> Diagnostic {
        let d = Diagnostic::new(kind.name, Origin::Compiler, severity, span, message);
        Diagnostic {
            kind: Some(kind),
            ..d
        }
    }

    /// Creates a finding with the required fields.
    pub fn new(
        rule: &'static str,
        origin: Origin,
        severity: Severity,
        span: Span,
        message: impl Into<String>,
    ) -> Diagnostic {
        Diagnostic {
            rule,
            kind: None,
            origin,
            severity,
            message: message.into(),
            subject: Subject::Other,
            span,
            label: String::new(),
            labels: Vec::new(),
            others: Vec::new(),
            notes: Vec::new(),
            help: Vec::new(),
            macros: Vec::new(),
            fix: None,
            part: None,
        }
    }

    /// Whether it is an error of this kind.
    pub fn is(&self, kind: ErrorKind) -> bool {
        self.kind == Some(kind)
    }

    /// Whether it is an error of a kind with this property.
    pub fn has(&self, facet: Facet) -> bool {
        self.kind.is_some_and(|kind| kind.has(facet))
    }

    /// How reliable it is in a shader fragment.
    pub fn certainty(&self) -> Certainty {
        self.kind.map_or(Certainty::Never, |kind| kind.certainty)
    }

    /// What the shader lacks, if this error says so.
    pub fn lacks(&self) -> Option<Lack> {
        self.kind?.lacks
    }

    /// Sets what a syntax error is about.
    pub fn about(mut self, subject: Subject) -> Diagnostic {
        self.subject = subject;
        self
    }

    /// Sets the annotation of the primary span.
    pub fn mark(mut self, message: impl Into<String>) -> Diagnostic {
        self.label = message.into();
        self
    }

    /// Adds an annotated secondary span.
    pub fn label(mut self, span: Span, message: impl Into<String>) -> Diagnostic {
        self.labels.push(Label {
            span,
            message: message.into(),
        });
        self
    }

    /// Adds an explanation.
    pub fn note(mut self, note: impl Into<String>) -> Diagnostic {
        self.notes.push(note.into());
        self
    }

    /// Adds a suggestion.
    pub fn help(mut self, help: impl Into<String>) -> Diagnostic {
        self.help.push(help.into());
        self
    }

    /// Sets the fix, if there is one. Where the code does not allow an edit, its title is a help.
    pub fn fix(mut self, fix: impl Into<Option<Fix>>) -> Diagnostic {
        self.set_fix(fix.into());
        self
    }

    /// As [`Diagnostic::fix`].
    pub fn set_fix(&mut self, fix: Option<Fix>) {
        match fix {
            Some(fix) if fix.edits.is_empty() => self.help.push(fix.title),
            fix => self.fix = fix,
        }
    }

    /// Path of the documentation page, relative to the repository root.
    pub fn page(&self) -> String {
        match self.origin {
            Origin::Compiler => format!("rules/errors/{}.md", self.rule),
            Origin::Report => "README.md".to_string(),
            Origin::Rule => format!("rules/{}.md", self.rule.replace('-', "_")),
        }
    }
}

/// A number with its noun: `1 file`, `2 files`.
pub fn count<N: std::fmt::Display + PartialEq + From<u8>>(n: N, one: &str) -> String {
    let plural = if n == N::from(1) { "" } else { "s" };
    format!("{n} {one}{plural}")
}

#[cfg(test)]
mod tests {
    use super::count;

    #[test]
    fn only_a_count_of_one_is_singular() {
        assert_eq!(count(0_usize, "file"), "0 files");
        assert_eq!(count(1_u8, "file"), "1 file");
        assert_eq!(count(12_u64, "more finding"), "12 more findings");
    }
}
