//! The modules that a script imports.

use super::embedded::InsertedPart;

/// Reads the modules that a script imports.
pub trait ImportedTexts {
    /// The text that a module exports under a name; `default` is the default export, and the whole text
    /// of a file that is no script.
    fn text(&self, path: &str, name: &str) -> Option<InsertedPart>;
}

/// No module can be read.
pub struct NoModules;

impl ImportedTexts for NoModules {
    fn text(&self, _: &str, _: &str) -> Option<InsertedPart> {
        None
    }
}
