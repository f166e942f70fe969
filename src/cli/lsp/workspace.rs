//! The files of the disk and their configurations.

use super::super::config::{ConfigArgs, ConfigSource, Configs, Exclusion, absolute};
use super::super::disk::Disk;
use super::super::input::collect;
use super::pages::PageFiles;
use crate::engine::config::Selection;
use crate::engine::{Files, Options};
use crate::format::StyleChoice;
use crate::lsp::{SampleRuns, Workspace};
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
    pages: Arc<PageFiles>,
}

impl DiskWorkspace {
    /// Reads no file yet.
    pub fn new(folders: &[PathBuf], pages: Arc<PageFiles>) -> DiskWorkspace {
        DiskWorkspace {
            disk: Disk::new(),
            quick: configs(folders, Some(0)),
            full: configs(folders, None),
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

    fn page(&self, rule: &str) -> Option<Uri> {
        self.pages.uri(rule)
    }

    fn write_page(&self, name: &str, content: &str) -> Option<Uri> {
        self.pages.write_anew(name, content)
    }

    fn renewed(&self, folders: &[PathBuf]) -> Arc<dyn Workspace> {
        Arc::new(DiskWorkspace::new(folders, self.pages.clone()))
    }
}
