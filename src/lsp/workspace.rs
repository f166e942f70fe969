//! What the server needs from whoever runs it.

use gen_lsp_types::Uri;
use shaderlint_engine::{Files, Options};
use shaderlint_format::StyleChoice;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Whether a check runs shaders.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SampleRuns {
    /// Only static analysis.
    Off,
    /// As configured.
    AsConfigured,
}

/// The files that are not open, and the options of all files.
pub trait Workspace: Send + Sync {
    /// The files that are not open.
    fn saved(&self) -> &dyn Files;

    /// The options for checking a file; `None` if its configuration is invalid.
    fn options(&self, path: &Path, runs: SampleRuns) -> Option<Arc<Options>>;

    /// The formatting style of a file: as configured, and otherwise `client`.
    ///
    /// # Errors
    /// A message if the configuration is invalid.
    fn style(&self, path: &Path, client: StyleChoice) -> Result<StyleChoice, Arc<str>>;

    /// Whether the configuration excludes a file.
    fn leaves_out(&self, path: &Path) -> bool;

    /// The files in some folders that may contain shaders.
    fn files(&self, folders: &[PathBuf]) -> Vec<PathBuf>;

    /// The URI of the documentation of a rule or compile error.
    fn page(&self, rule: &str) -> Option<Uri>;

    /// Writes a page where a browser can open it, and returns its URI.
    fn write_page(&self, name: &str, content: &str) -> Option<Uri>;

    /// The same workspace with other folders and with its configurations read again.
    fn renewed(&self, folders: &[PathBuf]) -> Arc<dyn Workspace>;
}
