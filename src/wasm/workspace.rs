//! The workspace of files that the host sent.

use super::files::MemoryFiles;
use gen_lsp_types::Uri;
use shaderlint_detect::kind::is_searched;
use shaderlint_diagnostic::ERRORS;
use shaderlint_engine::config::ProjectLimit;
use shaderlint_format::StyleChoice;
use shaderlint_lsp::{Workspace, WorkspaceConfigs};
use shaderlint_project::Files;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A workspace of files that the host sent, with their configurations.
pub struct SentWorkspace {
    saved: Arc<MemoryFiles>,
    configs: WorkspaceConfigs,
    /// Address of the documentation; ends with a slash.
    site: Option<String>,
}

impl SentWorkspace {
    /// `site` is the address of the documentation, which findings refer to.
    pub fn new(
        saved: Arc<MemoryFiles>,
        folders: &[PathBuf],
        site: Option<String>,
    ) -> SentWorkspace {
        SentWorkspace {
            configs: WorkspaceConfigs::new(saved.clone(), ProjectLimit::Nothing, folders),
            saved,
            site,
        }
    }
}

impl Workspace for SentWorkspace {
    fn saved(&self) -> &dyn Files {
        &*self.saved
    }

    fn configs(&self) -> &WorkspaceConfigs {
        &self.configs
    }

    fn style(&self, path: &Path, client: StyleChoice) -> Result<StyleChoice, Arc<str>> {
        self.configs.quick.style(path, client)
    }

    fn files(&self, folders: &[PathBuf]) -> Vec<PathBuf> {
        let inside = folders.iter().flat_map(|folder| self.saved.below(folder));
        let name = |path: &Path| {
            path.file_name()
                .map(|name| is_searched(&name.to_string_lossy()))
        };
        let searched = inside.filter(|path| name(path) == Some(true) && !self.leaves_out(path));
        let searched: BTreeSet<PathBuf> = searched.collect();
        searched.into_iter().collect()
    }

    fn project_files(&self, path: &Path, folders: &[PathBuf]) -> Vec<PathBuf> {
        let open = folders.iter().filter(|folder| path.starts_with(folder));
        let outermost = open.min_by_key(|folder| folder.components().count());
        let folder = outermost.map(PathBuf::as_path).or(path.parent());
        self.files(&[folder.unwrap_or(Path::new("/")).to_path_buf()])
    }

    fn page(&self, rule: &str) -> Option<Uri> {
        let site = self.site.as_ref()?;
        let folder = match ERRORS.contains(&rule) {
            true => "errors",
            false => "rules",
        };
        Some(Uri(format!("{site}{folder}/{rule}")))
    }

    fn write_page(&self, _: &str, _: &str) -> Option<Uri> {
        None
    }

    fn renewed(&self, folders: &[PathBuf]) -> Arc<dyn Workspace> {
        Arc::new(SentWorkspace {
            saved: self.saved.clone(),
            configs: self.configs.renewed(folders),
            site: self.site.clone(),
        })
    }
}
