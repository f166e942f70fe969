//! `--fix`, `--unsafe-fixes` and `--diff`.

use super::super::input::InputFile;
use super::super::output::{diff, replace};
use super::args::CheckArgs;
use crate::diagnostic::Diagnostic;
use crate::engine::{Options, fix_text};
use crate::lint::{Allow, Proof};
use crate::project::Files;
use crate::text::{Content, Encoding, Span};

/// Where fixes are written, and which are allowed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct FixMode {
    allow: Allow,
    into: Into,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Into {
    Files,
    Diff,
}

/// The result of applying fixes to one input.
#[derive(Default)]
pub struct FixOutcome {
    /// Where the fixed text went.
    pub applied: Option<AppliedFixes>,
    /// For each fixed finding: whether the image was verified to stay the same.
    pub proofs: Vec<Proof>,
    /// Findings that keep their fix because it would change the image, with spans in the text that
    /// is checked next.
    pub left: Vec<Diagnostic>,
}

impl FixOutcome {
    fn of(applied: Option<AppliedFixes>) -> FixOutcome {
        FixOutcome {
            applied,
            ..FixOutcome::default()
        }
    }
}

/// Where the fixed text of one input went.
pub enum AppliedFixes {
    /// The number of fixes written to the file.
    Written(usize),
    /// Text for standard output: a diff, or the fixed standard input.
    Text(String),
    /// Not written, with the reason.
    Refused(String),
}

impl FixMode {
    /// The fixes that the arguments ask for.
    pub fn of(args: &CheckArgs) -> Option<FixMode> {
        let is_asked = args.fix || args.unsafe_fixes || args.diff;
        is_asked.then_some(FixMode {
            allow: if args.unsafe_fixes {
                Allow::Unsafe
            } else {
                Allow::Safe
            },
            into: if args.diff { Into::Diff } else { Into::Files },
        })
    }

    /// Whether a diff or the fixed text goes to standard output, so that findings go to standard
    /// error.
    pub fn prints(self, inputs: &[InputFile]) -> bool {
        self.into == Into::Diff || inputs.iter().any(|i| i.path.is_none())
    }

    /// Whether files are written.
    pub fn writes(self) -> bool {
        self.into == Into::Files
    }

    /// Fixes one input. Returns its new text if it changed.
    pub fn apply(
        self,
        input: &InputFile,
        content: &Content,
        options: &Options,
        files: &dyn Files,
    ) -> (Option<String>, FixOutcome) {
        let is_stdin = input.path.is_none();
        let unchanged = || {
            let passes_through = is_stdin && self.into == Into::Files;
            passes_through.then(|| AppliedFixes::Text(content.text.clone()))
        };
        if content.encoding != Encoding::Utf8 {
            return (None, FixOutcome::of(unchanged()));
        }
        let fixed = fix_text(&input.name, &content.text, options, files, self.allow);
        let is_same = fixed.applied.is_empty() || fixed.text == content.text;
        let (text, applied) = match (self.into, &input.path) {
            _ if is_same => (None, unchanged()),
            (Into::Diff, _) => {
                let diff = diff(&input.name, &content.text, &fixed.text);
                (None, Some(AppliedFixes::Text(diff)))
            }
            (Into::Files, None) => {
                let text = fixed.text.clone();
                (Some(text.clone()), Some(AppliedFixes::Text(text)))
            }
            (Into::Files, Some(path)) => {
                match replace(path, content.text.as_bytes(), fixed.text.as_bytes()) {
                    Ok(()) => {
                        let count = fixed.applied.len();
                        (Some(fixed.text.clone()), Some(AppliedFixes::Written(count)))
                    }
                    Err(error) => {
                        let why = format!("cannot write the fixes: {error}");
                        (None, Some(AppliedFixes::Refused(why)))
                    }
                }
            }
        };
        let place = |found: &Diagnostic| match text {
            Some(_) => found.span,
            None => Span::new(fixed.origin(found.span.start), fixed.origin(found.span.end)),
        };
        let left = fixed.left.iter().map(|found| Diagnostic {
            span: place(found),
            ..found.clone()
        });
        let fix_outcome = FixOutcome {
            applied,
            left: left.collect(),
            proofs: fixed.proofs,
        };
        (text, fix_outcome)
    }
}
