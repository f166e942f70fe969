//! The result of checking a text.

use crate::shader::analysis::Analysis;
use crate::shader::export::ExportText;
use crate::shader::shader_input::Shader;
use crate::text::split::Unread;
use shaderlint_detect::embed::Embedded;
use shaderlint_detect::kind::ShaderLanguage;
use shaderlint_diagnostic::Diagnostic;
use shaderlint_lint::CheckedSpans;
use shaderlint_text::{FileId, Role, Sources};
use std::sync::Arc;

/// The result of checking a text.
#[derive(Default)]
pub struct Report {
    /// The source texts that findings refer to.
    pub sources: Arc<Sources>,
    /// The findings in source order.
    pub diagnostics: Vec<Diagnostic>,
    /// The input file; `None` for an export, whose passes are separate files.
    pub file: Option<FileId>,
    /// The shaders of the file.
    pub shaders: Vec<Shader>,
    /// Number of findings dropped because there are too many.
    pub left_out: usize,
    /// Number of infos that were counted instead of reported.
    pub counted_infos: usize,
    /// Why the file was not checked.
    pub unread: Option<Unread>,
    /// The language of a shader that was not checked because WebGL does not support it.
    pub language: Option<ShaderLanguage>,
    /// The analyses of the shaders, if [`analyze`](crate::analyze) was called.
    pub analyses: Vec<Analysis>,
    /// The embedded shaders of a page, script or document.
    pub(crate) embedded: Vec<Embedded>,
    /// Whether the file contains embedded shaders.
    pub(crate) holds_others: bool,
    /// Positions of the code of passes in an export.
    pub(crate) export: Option<ExportText>,
    /// What was checked, if there are errors.
    pub(crate) checked_spans: Option<CheckedSpans>,
}

impl Report {
    /// Whether the file includes other files.
    pub fn includes(&self) -> bool {
        let users = self.sources.files().iter().filter(|f| f.role == Role::User);
        self.file.is_some() && users.count() > 1
    }

    /// Whether the file contains embedded shaders.
    pub fn holds_shaders(&self) -> bool {
        self.holds_others
    }

    /// The embedded shaders of a page, script or document.
    pub fn embedded(&self) -> &[Embedded] {
        &self.embedded
    }

    /// Whether the fix of a finding can be written to the file.
    pub fn can_apply(&self, diagnostic: &Diagnostic) -> bool {
        let fix = diagnostic.fix.as_ref();
        fix.is_some_and(|fix| fix.edits.iter().all(|e| self.edit_of_input(e).is_some()))
    }
}
