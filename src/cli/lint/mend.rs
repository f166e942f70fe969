//! `--fix`, `--unsafe-fixes` and `--diff`.

use super::super::document::{Options, check_with, fix_with, is_export};
use super::super::input::{Content, Encoding, InputFile};
use super::super::output::{diff, replace};
use super::args::Args;
use crate::lint::Allow;

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
    /// There are some, but files of this kind are not written.
    Left(String),
}

impl Mend {
    /// What the arguments ask for.
    pub fn of(args: &Args) -> Option<Mend> {
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

    /// Mends one input. Gives its text as it is now, where that is another.
    pub fn apply(
        self,
        input: &InputFile,
        content: &Content,
        options: &Options,
    ) -> (Option<String>, Option<Mended>) {
        let is_stdin = input.path.is_none();
        let unchanged = || {
            let passes_through = is_stdin && self.into == Into::Files;
            passes_through.then(|| Mended::Text(content.text.clone()))
        };
        if content.encoding != Encoding::Utf8 {
            return (None, unchanged());
        }
        if is_export(&input.name) {
            let left = || left(count(input, content, options, self.allow));
            return (None, unchanged().or_else(left));
        }
        let fixed = fix_with(&input.name, &content.text, options, self.allow);
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

/// How many findings in an export have a fix.
fn count(input: &InputFile, content: &Content, options: &Options, allow: Allow) -> usize {
    let findings = check_with(&input.name, content.clone(), options);
    let fixes = findings.iter().flat_map(|f| &f.diagnostics);
    let fixes = fixes.filter_map(|d| d.fix.as_ref());
    fixes.filter(|f| allow.permits(f)).count()
}

fn left(count: usize) -> Option<Mended> {
    let what = match count {
        0 => return None,
        1 => "1 fix is",
        _ => &format!("{count} fixes are"),
    };
    Some(Mended::Left(format!(
        "{what} not written, since an export holds code in escapes; save the pass as a file of its own"
    )))
}
