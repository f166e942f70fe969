//! The environment of a check: options and files.

use crate::options::Options;
use shaderlint_project::{FileAccess, Files};

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

    /// An environment that keeps programs too.
    pub fn keeping(options: &'a Options, files: &'a dyn Files) -> CheckContext<'a> {
        CheckContext {
            keep: Keep::Programs,
            ..CheckContext::new(options, files)
        }
    }

    /// What the files around a shader are found with.
    pub fn file_access(&self) -> FileAccess<'a> {
        self.options.file_access(self.files)
    }
}
