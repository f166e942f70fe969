//! What shaderlint has to say, as data: no colour, no line numbers, no output format.

mod code;

pub use code::{Certainty, ERRORS, ErrorKind, Facet, Lack, error};

use shaderlint_text::{Edit, Span};
use std::sync::Arc;

/// How bad a finding is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Severity {
    /// Worth knowing.
    Info,
    /// The shader compiles, but it is probably not what was meant.
    Warning,
    /// The browser's WebGL2 compiler refuses the shader.
    Error,
}

impl Severity {
    /// The word that every output format prints.
    pub const fn name(self) -> &'static str {
        match self {
            Severity::Info => "info",
            Severity::Warning => "warning",
            Severity::Error => "error",
        }
    }
}

/// A remark on a place that explains the finding.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Label {
    /// The place.
    pub span: Span,
    /// The remark, lower case and without a full stop.
    pub message: String,
}

/// Whether a fix may be applied without a look.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Applicability {
    /// Keeps what the shader draws, or makes a shader compile in the only way that fits.
    Safe,
    /// Probably what is meant, but the picture may change.
    Unsafe,
}

impl Applicability {
    /// The word that the machine formats print.
    pub const fn name(self) -> &'static str {
        match self {
            Applicability::Safe => "safe",
            Applicability::Unsafe => "unsafe",
        }
    }
}

/// A way to mend the finding. Its edits never overlap.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fix {
    /// What it does, as an order: "write `1.0`".
    pub title: String,
    /// Whether it may be applied unseen.
    pub applicability: Applicability,
    /// The edits, all of which belong together.
    pub edits: Vec<Edit>,
}

impl Fix {
    /// A fix that may be applied unseen.
    pub fn safe(title: impl Into<String>, edits: Vec<Edit>) -> Fix {
        Fix {
            title: title.into(),
            applicability: Applicability::Safe,
            edits,
        }
    }

    /// A fix that wants a look.
    pub fn suggestion(title: impl Into<String>, edits: Vec<Edit>) -> Fix {
        Fix {
            title: title.into(),
            applicability: Applicability::Unsafe,
            edits,
        }
    }
}

/// One macro call that the code at fault came through.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct MacroUse {
    /// Name of the macro.
    pub name: String,
    /// The call: from the macro's name to the closing parenthesis.
    pub call: Span,
    /// The name in the `#define`.
    pub definition: Span,
}

/// Which pages explain a finding's name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Origin {
    /// The compiler refuses the code; `rules/errors/NAME.md`.
    Compiler,
    /// A lint rule found it; `rules/NAME.md`.
    Rule,
    /// Who prints the findings speaks of what is left out; `README.md`.
    Report,
}

/// What an error of the syntax is about, for code that asks: messages are for people alone.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Subject {
    /// Nothing that anybody asks for.
    #[default]
    Other,
    /// A `}` that is missing.
    MissingClose,
    /// A brace that stands in the wrong place, or a `{` that is missing.
    Brace,
    /// A statement outside functions.
    OuterStatement,
    /// The head of a function without its type.
    UntypedFunction,
    /// Blanks or comments before `#version`.
    BlankFront,
}

impl Subject {
    /// Whether it is about braces, which move what stands where.
    pub const fn is_brace(self) -> bool {
        matches!(self, Subject::MissingClose | Subject::Brace)
    }
}

/// One finding.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Diagnostic {
    /// Name of the finding, which is also the name of its page.
    pub rule: &'static str,
    /// What kind of compile error it is, for code that decides; `None` of rules.
    pub kind: Option<ErrorKind>,
    /// Whether the compiler or a lint rule speaks.
    pub origin: Origin,
    /// How bad it is.
    pub severity: Severity,
    /// What is wrong: lower case, no full stop, names in backticks.
    pub message: String,
    /// What an error of the syntax is about.
    pub subject: Subject,
    /// Where.
    pub span: Span,
    /// A short remark printed right under the place; may be empty.
    pub label: String,
    /// Other places that explain it.
    pub labels: Vec<Label>,
    /// Why it is wrong.
    pub notes: Vec<String>,
    /// What to write instead, in words and code.
    pub help: Vec<String>,
    /// The macro calls that the code came through, innermost first.
    pub macros: Vec<MacroUse>,
    /// How to mend it.
    pub fix: Option<Fix>,
    /// Of a part of a shader: the hosts that are thought to complete it.
    pub part: Option<Arc<[String]>>,
}

impl Diagnostic {
    /// A compile error; `kind` is one of [`error`].
    pub fn error(kind: ErrorKind, span: Span, message: impl Into<String>) -> Diagnostic {
        Diagnostic::of(kind, Severity::Error, span, message)
    }

    /// What is said of code that may be a compile error; `kind` is one of [`error`].
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

    /// A finding with all that is not optional.
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

    /// Whether it is an error of a kind with this facet.
    pub fn has(&self, facet: Facet) -> bool {
        self.kind.is_some_and(|kind| kind.has(facet))
    }

    /// How sure it is in a part of a shader.
    pub fn certainty(&self) -> Certainty {
        self.kind.map_or(Certainty::Never, |kind| kind.certainty)
    }

    /// What the shader lacks, if that is the error.
    pub fn lacks(&self) -> Option<Lack> {
        self.kind?.lacks
    }

    /// Says what an error of the syntax is about.
    pub fn about(mut self, subject: Subject) -> Diagnostic {
        self.subject = subject;
        self
    }

    /// Sets the remark under the place itself.
    pub fn mark(mut self, message: impl Into<String>) -> Diagnostic {
        self.label = message.into();
        self
    }

    /// Points at another place.
    pub fn label(mut self, span: Span, message: impl Into<String>) -> Diagnostic {
        self.labels.push(Label {
            span,
            message: message.into(),
        });
        self
    }

    /// Says why.
    pub fn note(mut self, note: impl Into<String>) -> Diagnostic {
        self.notes.push(note.into());
        self
    }

    /// Says what to write instead.
    pub fn help(mut self, help: impl Into<String>) -> Diagnostic {
        self.help.push(help.into());
        self
    }

    /// Adds the fix, if there is one.
    pub fn fix(mut self, fix: impl Into<Option<Fix>>) -> Diagnostic {
        self.fix = fix.into();
        self
    }

    /// Path of the page that explains it, from the top of the repository.
    pub fn page(&self) -> String {
        match self.origin {
            Origin::Compiler => format!("rules/errors/{}.md", self.rule),
            Origin::Report => "README.md".to_string(),
            Origin::Rule => format!("rules/{}.md", self.rule.replace('-', "_")),
        }
    }
}
