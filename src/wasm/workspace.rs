//! Files in memory.

use super::configs::SentConfigs;
use gen_lsp_types::Uri;
use shaderlint_diagnostic::ERRORS;
use shaderlint_engine::{FileType, Files, LoadError, Options};
use shaderlint_format::StyleChoice;
use shaderlint_lsp::{ConfigFinding, SampleRuns, Workspace};
use shaderlint_text::kind::is_searched;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard};

/// Files by path. Those of a workspace change while it is used.
#[derive(Default)]
pub struct MemoryFiles {
    texts: Mutex<BTreeMap<PathBuf, Arc<str>>>,
}

impl MemoryFiles {
    /// Files with these contents.
    pub fn new(texts: &BTreeMap<PathBuf, String>) -> MemoryFiles {
        let texts = texts.iter();
        let texts = texts.map(|(path, text)| (path.clone(), Arc::from(text.as_str())));
        MemoryFiles {
            texts: Mutex::new(texts.collect()),
        }
    }

    /// Replaces the text of a file, or removes it. Returns whether there was one.
    pub fn put(&self, path: PathBuf, text: Option<&str>) -> bool {
        let mut texts = self.lock();
        let before = match text {
            Some(text) => texts.insert(path, Arc::from(text)),
            None => texts.remove(&path),
        };
        before.is_some()
    }

    /// The files in a folder and in those below.
    fn below(&self, folder: &Path) -> Vec<PathBuf> {
        let texts = self.lock();
        let from = texts.range(folder.to_path_buf()..).map(|(path, _)| path);
        from.take_while(|path| path.starts_with(folder))
            .cloned()
            .collect()
    }

    fn lock(&self) -> MutexGuard<'_, BTreeMap<PathBuf, Arc<str>>> {
        let texts = self.texts.lock();
        texts.unwrap_or_else(|poisoned| poisoned.into_inner())
    }
}

impl Files for MemoryFiles {
    fn load(&self, path: &Path) -> Result<Arc<str>, LoadError> {
        self.lock().get(path).cloned().ok_or(LoadError::NotFound)
    }

    fn entry(&self, path: &Path) -> Option<FileType> {
        let texts = self.lock();
        let (first, _) = texts.range(path.to_path_buf()..).next()?;
        match first {
            first if first == path => Some(FileType::File),
            first => first.starts_with(path).then_some(FileType::Folder),
        }
    }

    fn names(&self, folder: &Path) -> Vec<String> {
        let inside = self.below(folder);
        let names = inside.iter().filter_map(|path| {
            let name = path.strip_prefix(folder).ok()?.components().next()?;
            Some(name.as_os_str().to_string_lossy().into_owned())
        });
        let names: BTreeSet<String> = names.collect();
        names.into_iter().collect()
    }

    fn here(&self) -> &Path {
        Path::new("/")
    }

    fn real(&self, path: &Path) -> Option<PathBuf> {
        self.entry(path).map(|_| path.to_path_buf())
    }

    fn version(&self, _: &Path) -> Option<u64> {
        None
    }
}

/// A workspace of files that the host sent, with their configurations.
pub struct SentWorkspace {
    saved: Arc<MemoryFiles>,
    folders: Vec<PathBuf>,
    configs: SentConfigs,
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
            configs: SentConfigs::new(saved.clone()),
            saved,
            folders: folders.to_vec(),
            site,
        }
    }

    /// The workspace folders around a file, innermost first.
    fn around(&self, path: &Path) -> Vec<PathBuf> {
        let around = self.folders.iter().filter(|f| path.starts_with(f));
        let mut around: Vec<PathBuf> = around.cloned().collect();
        around.sort_by_key(|folder| Reverse(folder.components().count()));
        around
    }
}

impl Workspace for SentWorkspace {
    fn saved(&self) -> &dyn Files {
        &*self.saved
    }

    fn options(&self, path: &Path, runs: SampleRuns) -> Option<Arc<Options>> {
        self.configs.options(path, self.around(path), runs)
    }

    fn style(&self, path: &Path, client: StyleChoice) -> Result<StyleChoice, Arc<str>> {
        self.configs.style(path, client)
    }

    fn leaves_out(&self, path: &Path) -> bool {
        let config = self.configs.nearest(path);
        config.is_ok_and(|config| config.is_some_and(|config| config.leaves_out(path)))
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

    fn invalid_configs(&self, paths: &[PathBuf]) -> Vec<ConfigFinding> {
        self.configs.problems(paths)
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
            folders: folders.to_vec(),
            configs: self.configs.renewed(),
            site: self.site.clone(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_are_what_files_lie_in() {
        let texts = ["/a/b.glsl", "/a-c.glsl", "/a/d/e.glsl"];
        let texts = texts.map(|path| (PathBuf::from(path), String::new()));
        let files = MemoryFiles::new(&texts.into());
        assert_eq!(files.names(Path::new("/a")), ["b.glsl", "d"]);
        assert_eq!(files.entry(Path::new("/a")), Some(FileType::Folder));
        assert_eq!(files.entry(Path::new("/a/b.glsl")), Some(FileType::File));
        assert_eq!(files.entry(Path::new("/a/b")), None);
        assert!(files.load(Path::new("/a/d/e.glsl")).is_ok());
    }
}
