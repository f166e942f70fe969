//! What the server requires from its environment.

use gen_lsp_types::Uri;
use shaderlint_engine::Options;
use shaderlint_engine::config::{
    ConfigArgs, ConfigProblem, ConfigSource, Configs, Exclusion, LastGood, ProjectLimit, Selection,
};
use shaderlint_format::StyleChoice;
use shaderlint_project::Files;
use shaderlint_project::{GivenOrder, NoMedia, Project};
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

    /// The configurations of the files.
    fn configs(&self) -> &WorkspaceConfigs;

    /// The options for checking a file; `None` if its configuration never was valid.
    fn options(&self, path: &Path, runs: SampleRuns) -> Option<Arc<Options>> {
        self.configs().options(path, runs)
    }

    /// The configurations that cannot be used, of those that apply to some files. Their last valid
    /// content is used.
    fn invalid_configs(&self, paths: &[PathBuf]) -> Vec<ConfigProblem> {
        self.configs().invalid(paths)
    }

    /// The formatting style of a file: as configured, and otherwise `client`.
    ///
    /// # Errors
    /// A message if the configuration is invalid.
    fn style(&self, path: &Path, client: StyleChoice) -> Result<StyleChoice, Arc<str>>;

    /// Whether the configuration excludes a file.
    fn leaves_out(&self, path: &Path) -> bool {
        self.configs().quick.leaves_out(path)
    }

    /// The files in some folders that may contain shaders.
    fn files(&self, folders: &[PathBuf]) -> Vec<PathBuf>;

    /// The files of the project that contains a file: its repository, package or configuration, or
    /// the one of `folders` that it is in. Without any, the files next to it.
    fn project_files(&self, path: &Path, folders: &[PathBuf]) -> Vec<PathBuf>;

    /// The URI of the documentation of a rule or compile error.
    fn page(&self, rule: &str) -> Option<Uri>;

    /// Writes a page where a browser can open it, and returns its URI.
    fn write_page(&self, name: &str, content: &str) -> Option<Uri>;

    /// Puts on the channels of a project what files beside it give them. Without access to media,
    /// these are passes and devices.
    ///
    /// # Errors
    /// A message if an order cannot be carried out.
    fn put_channels(&self, project: &mut Project, orders: &[GivenOrder]) -> Result<(), String> {
        project.put_all(orders, &mut NoMedia)
    }

    /// The same workspace with other folders and with its configurations read again.
    fn renewed(&self, folders: &[PathBuf]) -> Arc<dyn Workspace>;
}

/// The configurations of the files in some folders.
pub struct WorkspaceConfigs {
    files: Arc<dyn Files + Send>,
    limit: ProjectLimit,
    /// For checking without sample runs.
    pub quick: Configs,
    /// For checking with sample runs.
    full: Configs,
    last_good: Arc<LastGood>,
}

impl WorkspaceConfigs {
    /// Reads no file yet.
    pub fn new(files: Arc<dyn Files + Send>, limit: ProjectLimit, folders: &[PathBuf]) -> Self {
        WorkspaceConfigs::after(LastGood::default(), files, limit, folders)
    }

    /// Reads all files again. An invalid configuration is replaced by its last valid content.
    pub fn renewed(&self, folders: &[PathBuf]) -> Self {
        let (files, limit) = (self.files.clone(), self.limit.clone());
        WorkspaceConfigs::after(self.last_good.renewed(), files, limit, folders)
    }

    fn after(
        last_good: LastGood,
        files: Arc<dyn Files + Send>,
        limit: ProjectLimit,
        folders: &[PathBuf],
    ) -> Self {
        let last_good = Arc::new(last_good);
        let configs = |run_samples| {
            let asked = ConfigArgs {
                given: Selection {
                    run_samples,
                    ..Selection::default()
                },
                source: ConfigSource::Nearest,
                exclusion: Exclusion::Named,
                paths: folders.to_vec(),
            };
            let configs = Configs::new(files.clone(), limit.clone(), asked);
            configs.with_last_good(last_good.clone())
        };
        let (quick, full) = (configs(Some(0)), configs(None));
        WorkspaceConfigs {
            files,
            limit,
            quick,
            full,
            last_good,
        }
    }

    /// The options for checking a file; `None` if its configuration never was valid.
    pub fn options(&self, path: &Path, runs: SampleRuns) -> Option<Arc<Options>> {
        let configs = match runs {
            SampleRuns::Off => &self.quick,
            SampleRuns::AsConfigured => &self.full,
        };
        configs.options(path).ok()
    }

    /// The configurations that cannot be used, of those that apply to some files.
    pub fn invalid(&self, paths: &[PathBuf]) -> Vec<ConfigProblem> {
        for path in paths {
            // An invalid one is kept as a problem.
            let _ = self.quick.config(path);
        }
        self.last_good.problems()
    }
}
