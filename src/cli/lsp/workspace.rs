//! The files of the disk and their configurations.

use super::super::config::{ConfigArgs, ConfigSource, Configs, Exclusion, LastGood, absolute};
use super::super::disk::Disk;
use super::super::input::collect;
use super::super::port::put_channels;
use super::pages::PageFiles;
use crate::detect::kind::is_searched;
use crate::engine::config::Selection;
use crate::engine::{Files, Options};
use crate::format::StyleChoice;
use crate::lsp::{ConfigFinding, SampleRuns, Workspace};
use crate::port::Project;
use gen_lsp_types::Uri;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The workspace folders on disk.
pub struct DiskWorkspace {
    disk: Disk,
    /// Options for checking without sample runs.
    quick: Configs,
    /// Options for checking with sample runs.
    full: Configs,
    last_good: Arc<LastGood>,
    pages: Arc<PageFiles>,
}

impl DiskWorkspace {
    /// Reads no file yet.
    pub fn new(
        folders: &[PathBuf],
        pages: Arc<PageFiles>,
        last_good: Arc<LastGood>,
    ) -> DiskWorkspace {
        DiskWorkspace {
            disk: Disk::new(),
            quick: configs(folders, Some(0)).with_last_good(last_good.clone()),
            full: configs(folders, None).with_last_good(last_good.clone()),
            last_good,
            pages,
        }
    }
}

/// The options for checking files in some folders.
fn configs(folders: &[PathBuf], run_samples: Option<u32>) -> Configs {
    Configs::new(ConfigArgs {
        given: Selection {
            run_samples,
            ..Selection::default()
        },
        source: ConfigSource::Nearest,
        exclusion: Exclusion::Named,
        paths: folders.to_vec(),
    })
}

impl Workspace for DiskWorkspace {
    fn saved(&self) -> &dyn Files {
        &self.disk
    }

    fn options(&self, path: &Path, runs: SampleRuns) -> Option<Arc<Options>> {
        let configs = match runs {
            SampleRuns::Off => &self.quick,
            SampleRuns::AsConfigured => &self.full,
        };
        configs.options(path).ok()
    }

    fn invalid_configs(&self, paths: &[PathBuf]) -> Vec<ConfigFinding> {
        for path in paths {
            // An invalid one is kept as a problem.
            let _ = self.quick.config(path);
        }
        let problems = self.last_good.problems().into_iter();
        let findings = problems.map(|problem| ConfigFinding {
            path: problem.file,
            at: problem.at,
            message: problem.message,
        });
        findings.collect()
    }

    fn style(&self, path: &Path, client: StyleChoice) -> Result<StyleChoice, Arc<str>> {
        self.quick.style_or(path, client)
    }

    fn leaves_out(&self, path: &Path) -> bool {
        self.quick.leaves_out(&absolute(path))
    }

    fn files(&self, folders: &[PathBuf]) -> Vec<PathBuf> {
        let collected = collect(folders, None, &self.quick);
        let inputs = collected.inputs.into_iter();
        inputs.filter_map(|input| input.path).collect()
    }

    fn project_files(&self, path: &Path, folders: &[PathBuf]) -> Vec<PathBuf> {
        let open = folders.iter().filter(|folder| path.starts_with(folder));
        let known = self.quick.project_root(path).into_iter();
        let outermost = known
            .chain(open.cloned())
            .min_by_key(|f| f.components().count());
        if let Some(root) = outermost {
            return self.files(&[root]);
        }
        let folder = path.parent().unwrap_or(Path::new("/"));
        let names = self.disk.names(folder).into_iter();
        let names = names.filter(|name| is_searched(name));
        self.files(&names.map(|name| folder.join(name)).collect::<Vec<_>>())
    }

    fn page(&self, rule: &str) -> Option<Uri> {
        self.pages.uri(rule)
    }

    fn write_page(&self, name: &str, content: &str) -> Option<Uri> {
        self.pages.write_anew(name, content)
    }

    fn put_channels(&self, project: &mut Project, input: &Path) -> Result<(), String> {
        put_channels(project, input, &[]).map(|_| ())
    }

    fn renewed(&self, folders: &[PathBuf]) -> Arc<dyn Workspace> {
        let last_good = Arc::new(self.last_good.renewed());
        Arc::new(DiskWorkspace::new(folders, self.pages.clone(), last_good))
    }
}
