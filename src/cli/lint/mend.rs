//! `--fix`, `--unsafe-fixes` and `--diff`.

use super::super::input::InputFile;
use super::super::output::{diff, replace};
use super::args::LintArgs;
use crate::engine::{Files, Options, mend};
use crate::lint::Allow;
use crate::text::{Content, Encoding};

/// What is done with fixes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Mend {
    allow: Allow,
    into: Into,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Into {
    Files,
    Diff,
}

/// What was done with the fixes of one input.
pub enum Mended {
    /// So many were written into the file.
    Written(usize),
    /// Text for standard output: a diff, or standard input mended.
    Text(String),
    /// They were not written, for this reason.
    Refused(String),
}

impl Mend {
    /// What the arguments ask for.
    pub fn of(args: &LintArgs) -> Option<Mend> {
        let is_asked = args.fix || args.unsafe_fixes || args.diff;
        is_asked.then_some(Mend {
            allow: if args.unsafe_fixes {
                Allow::Unsafe
            } else {
                Allow::Safe
            },
            into: if args.diff { Into::Diff } else { Into::Files },
        })
    }

    /// Whether standard output is taken by text, so that findings must go elsewhere.
    pub fn prints(self, inputs: &[InputFile]) -> bool {
        self.into == Into::Diff || inputs.iter().any(|i| i.path.is_none())
    }

    /// Whether files are written.
    pub fn writes(self) -> bool {
        self.into == Into::Files
    }

    /// Mends one input. Gives its text as it is now, where that is another.
    pub fn apply(
        self,
        input: &InputFile,
        content: &Content,
        options: &Options,
        files: &dyn Files,
    ) -> (Option<String>, Option<Mended>) {
        let is_stdin = input.path.is_none();
        let unchanged = || {
            let passes_through = is_stdin && self.into == Into::Files;
            passes_through.then(|| Mended::Text(content.text.clone()))
        };
        if content.encoding != Encoding::Utf8 {
            return (None, unchanged());
        }
        let fixed = mend(&input.name, &content.text, options, files, self.allow);
        if fixed.applied.is_empty() || fixed.text == content.text {
            return (None, unchanged());
        }
        match (self.into, &input.path) {
            (Into::Diff, _) => {
                let diff = diff(&input.name, &content.text, &fixed.text);
                (None, Some(Mended::Text(diff)))
            }
            (Into::Files, None) => (Some(fixed.text.clone()), Some(Mended::Text(fixed.text))),
            (Into::Files, Some(path)) => {
                match replace(path, content.text.as_bytes(), fixed.text.as_bytes()) {
                    Ok(()) => (Some(fixed.text), Some(Mended::Written(fixed.applied.len()))),
                    Err(error) => (
                        None,
                        Some(Mended::Refused(format!(
                            "the fixes cannot be written: {error}"
                        ))),
                    ),
                }
            }
        }
    }
}
