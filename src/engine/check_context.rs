//! The environment of a check: options and files.

use crate::files::{Dependency, Files};
use crate::options::Options;

/// What is kept of a checked shader.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Keep {
    /// The findings only.
    Findings,
    /// The checked program too.
    Programs,
}

/// The environment of a check.
#[derive(Clone, Copy)]
pub struct CheckContext<'a> {
    /// The options of the check.
    pub options: &'a Options,
    /// Access to other files.
    pub files: &'a dyn Files,
    /// What is kept of checked shaders.
    pub keep: Keep,
}

impl<'a> CheckContext<'a> {
    /// An environment that keeps findings only.
    pub fn new(options: &'a Options, files: &'a dyn Files) -> CheckContext<'a> {
        CheckContext {
            options,
            files,
            keep: Keep::Findings,
        }
    }

    /// Whether the file of this name is checked in the same run.
    pub fn is_checked(&self, name: &str) -> bool {
        self.files.depends_on(Dependency::Checked(name));
        self.options.checked.contains(name)
    }
}
