//! The files of the disk and their configurations.

use super::super::config::{project_limit, style};
use super::super::disk::Disk;
use super::super::input::collect;
use super::super::port::put_channels;
use super::pages::PageFiles;
use crate::detect::kind::is_searched;
use crate::format::StyleChoice;
use crate::lsp::{Workspace, WorkspaceConfigs};
use crate::project::{Files, GivenOrder, Project};
use gen_lsp_types::Uri;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The workspace folders on disk.
pub struct DiskWorkspace {
    disk: Arc<Disk>,
    configs: WorkspaceConfigs,
    pages: Arc<PageFiles>,
}

impl DiskWorkspace {
    /// Reads no file yet.
    pub fn new(folders: &[PathBuf], pages: Arc<PageFiles>) -> DiskWorkspace {
        let disk = Arc::new(Disk::new());
        DiskWorkspace {
            configs: WorkspaceConfigs::new(disk.clone(), project_limit(), folders),
            disk,
            pages,
        }
    }
}

impl Workspace for DiskWorkspace {
    fn saved(&self) -> &dyn Files {
        &*self.disk
    }

    fn configs(&self) -> &WorkspaceConfigs {
        &self.configs
    }

    fn style(&self, path: &Path, client: StyleChoice) -> Result<StyleChoice, Arc<str>> {
        style(&self.configs.quick, path, client)
    }

    fn files(&self, folders: &[PathBuf]) -> Vec<PathBuf> {
        let collected = collect(folders, None, &self.configs.quick);
        let inputs = collected.inputs.into_iter();
        inputs.filter_map(|input| input.path).collect()
    }

    fn project_files(&self, path: &Path, folders: &[PathBuf]) -> Vec<PathBuf> {
        let open = folders.iter().filter(|folder| path.starts_with(folder));
        let known = self.configs.quick.project_root(path).into_iter();
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

    fn put_channels(&self, project: &mut Project, orders: &[GivenOrder]) -> Result<(), String> {
        put_channels(project, orders).map(|_| ())
    }

    fn renewed(&self, folders: &[PathBuf]) -> Arc<dyn Workspace> {
        Arc::new(DiskWorkspace {
            disk: self.disk.clone(),
            configs: self.configs.renewed(folders),
            pages: self.pages.clone(),
        })
    }
}
