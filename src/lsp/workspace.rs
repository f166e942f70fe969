//! What the server requires from its environment.

use gen_lsp_types::Uri;
use shaderlint_engine::{Files, Options};
use shaderlint_format::StyleChoice;
use shaderlint_port::Project;
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

/// A configuration that cannot be used.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ConfigFinding {
    /// Path of the configuration file.
    pub path: PathBuf,
    /// Line and column in characters, from 1, if a place is wrong.
    pub at: Option<(u32, u32)>,
    /// What is wrong.
    pub message: String,
}

/// The files that are not open, and the options of all files.
pub trait Workspace: Send + Sync {
    /// The files that are not open.
    fn saved(&self) -> &dyn Files;

    /// The options for checking a file; `None` if its configuration never was valid.
    fn options(&self, path: &Path, runs: SampleRuns) -> Option<Arc<Options>>;

    /// The configurations that cannot be used, of those that apply to some files. Their last valid
    /// content is used.
    fn invalid_configs(&self, paths: &[PathBuf]) -> Vec<ConfigFinding>;

    /// The formatting style of a file: as configured, and otherwise `client`.
    ///
    /// # Errors
    /// A message if the configuration is invalid.
    fn style(&self, path: &Path, client: StyleChoice) -> Result<StyleChoice, Arc<str>>;

    /// Whether the configuration excludes a file.
    fn leaves_out(&self, path: &Path) -> bool;

    /// The files in some folders that may contain shaders.
    fn files(&self, folders: &[PathBuf]) -> Vec<PathBuf>;

    /// The files of the project that contains a file: its repository, package or configuration, or
    /// the one of `folders` that it is in. Without any, the files next to it.
    fn project_files(&self, path: &Path, folders: &[PathBuf]) -> Vec<PathBuf>;

    /// The URI of the documentation of a rule or compile error.
    fn page(&self, rule: &str) -> Option<Uri>;

    /// Writes a page where a browser can open it, and returns its URI.
    fn write_page(&self, name: &str, content: &str) -> Option<Uri>;

    /// Puts on the channels of a project what a file next to `input`, a shader or a folder of
    /// passes, gives them.
    ///
    /// # Errors
    /// A message if the file is invalid.
    fn put_channels(&self, _project: &mut Project, _input: &Path) -> Result<(), String> {
        Ok(())
    }

    /// The same workspace with other folders and with its configurations read again.
    fn renewed(&self, folders: &[PathBuf]) -> Arc<dyn Workspace>;
}
