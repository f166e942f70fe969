//! An input file, split into shaders.

use super::export::ExportText;
use super::shader_input::ShaderInput;
use shaderlint_detect::embed::Embedded;
use shaderlint_diagnostic::Diagnostic;
use shaderlint_project::Hushed;
use shaderlint_text::{FileId, Sources};
use std::sync::Arc;

/// An input file, split into shaders.
#[derive(Default)]
pub struct SplitInput {
    /// The source texts.
    pub sources: Arc<Sources>,
    pub parts: Vec<ShaderInput>,
    /// The input file; `None` for an export.
    pub file: Option<FileId>,
    /// The embedded shaders of a page, script or document.
    pub embedded: Vec<Embedded>,
    /// Findings about the file itself.
    pub problems: Vec<Diagnostic>,
    /// Positions of the code of passes in an export.
    pub export: Option<ExportText>,
    /// Files whose findings are not reported here.
    pub hushed: Hushed,
}
