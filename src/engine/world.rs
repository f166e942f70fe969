//! What a text is judged with.

use super::files::Files;
use super::options::Options;

/// Whether what is known of a shader is kept.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Keep {
    /// Only what is said of it.
    Findings,
    /// All of it.
    Programs,
}

/// What a text is judged with.
#[derive(Clone, Copy)]
pub struct World<'a> {
    /// How.
    pub options: &'a Options,
    /// The files around it.
    pub files: &'a dyn Files,
    /// What is kept of it.
    pub keep: Keep,
}

impl<'a> World<'a> {
    /// Of what only the findings are kept.
    pub fn new(options: &'a Options, files: &'a dyn Files) -> World<'a> {
        World {
            options,
            files,
            keep: Keep::Findings,
        }
    }
}
