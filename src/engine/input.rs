//! An input, split into shaders.

use super::export::Written;
use super::include::Hushed;
use super::part::Part;
use shaderlint_diagnostic::Diagnostic;
use shaderlint_text::embed::Embedded;
use shaderlint_text::{FileId, Sources};
use std::sync::Arc;

/// An input, split into shaders.
#[derive(Default)]
pub struct SplitInput {
    /// The texts.
    pub sources: Arc<Sources>,
    /// Its shaders.
    pub parts: Vec<Part>,
    /// The file of the input itself; `None` for an export.
    pub file: Option<FileId>,
    /// The shaders inside it, where it is a page, a script or a text.
    pub embedded: Vec<Embedded>,
    /// What is wrong before any shader is read.
    pub problems: Vec<Diagnostic>,
    /// Where the code of the passes is written, where it is an export.
    pub export: Option<Written>,
    /// Files whose findings are not told here.
    pub hushed: Hushed,
}
