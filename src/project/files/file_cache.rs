//! A cache of files and folders, so that each is read once per run.

use super::imports::ShaderImports;
use super::passes::Passes;
use super::repository::{RepositoryWords, top};
use super::scan::IncludedFile;
use super::shaders::RepositoryShaders;
use crate::files::{Dependency, Files};
use std::collections::{BTreeSet, HashMap};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock};

/// Contents of files that earlier checks have read. Cloned options share it.
#[derive(Default, Debug)]
pub struct FileCache {
    /// By real path: the cached version and the file.
    texts: Mutex<HashMap<PathBuf, (u64, Arc<IncludedFile>)>>,
    /// By folder: the cached version and the ShaderToy passes in it.
    passes: Mutex<HashMap<PathBuf, (u64, Arc<Passes>)>>,
    /// By folder: the packages of its project.
    packages: Mutex<HashMap<PathBuf, Arc<BTreeSet<String>>>>,
    /// By folder of a package beside a shader, installed or not: the release of the package there.
    releases: Mutex<HashMap<PathBuf, Arc<Option<u32>>>>,
    /// By folder: the root of its repository.
    tops: Mutex<HashMap<PathBuf, Arc<PathBuf>>>,
    /// By root of a repository: the words in its code.
    words: Mutex<HashMap<PathBuf, Arc<OnceLock<RepositoryWords>>>>,
    /// By root of a repository: the shaders that its scripts import.
    imports: Mutex<HashMap<PathBuf, Arc<OnceLock<ShaderImports>>>>,
    /// By root of a repository: its GLSL files and chunks.
    shaders: Mutex<HashMap<PathBuf, Arc<OnceLock<RepositoryShaders>>>>,
}

impl FileCache {
    /// A file, read again if it has changed.
    pub fn text(&self, files: &dyn Files, real: &Path) -> Option<Arc<IncludedFile>> {
        files.depends_on(Dependency::Text(real));
        of_version(&self.texts, files, real, || {
            Some(IncludedFile::new(files.load(real).ok()?))
        })
    }

    /// The files in a folder that are named like passes, listed again if files were added or
    /// removed.
    pub fn passes(&self, files: &dyn Files, folder: &Path) -> Arc<Passes> {
        files.depends_on(Dependency::Names(folder));
        let found = of_version(&self.passes, files, folder, || {
            Some(Passes::inside(files, folder))
        });
        let found = found.unwrap_or_default();
        for path in &found.manifests {
            files.depends_on(Dependency::Text(path));
        }
        found
    }

    /// The packages of a folder's project; `find` computes them.
    pub fn packages(
        &self,
        folder: &Path,
        files: &dyn Files,
        find: impl FnOnce() -> BTreeSet<String>,
    ) -> Arc<BTreeSet<String>> {
        files.depends_on(Dependency::Repository);
        kept(&self.packages, folder, find)
    }

    /// The release of a package for shaders beside its folder; `find` computes it.
    pub fn release(
        &self,
        module: &Path,
        files: &dyn Files,
        find: impl FnOnce() -> Option<u32>,
    ) -> Arc<Option<u32>> {
        files.depends_on(Dependency::Repository);
        kept(&self.releases, module, find)
    }

    /// Whether a word appears in another file of the repository, and whether all of its files were
    /// read.
    pub fn is_elsewhere(&self, word: &str, file: &Path, files: &dyn Files) -> (bool, bool) {
        self.of_repository(file, files, |words| {
            (words.is_elsewhere(word, file), words.is_all)
        })
    }

    /// Whether another file of the repository may declare a name for a complete shader of this file.
    pub fn may_be_declared(&self, name: &str, file: &Path, files: &dyn Files) -> bool {
        self.of_repository(file, files, |words| {
            !words.is_all || words.may_be_declared(name, file, files)
        })
    }

    /// Whether another file of the repository declares a name outside of complete shaders.
    pub fn is_declared(&self, name: &str, file: &Path, files: &dyn Files) -> bool {
        self.of_repository(file, files, |words| {
            !words.is_all || words.is_declared(name, file, files)
        })
    }

    /// Whether complete shaders of other files declare an input or output of this name for themselves, and
    /// none lacks it.
    pub fn is_owned(&self, name: &str, file: &Path, files: &dyn Files) -> bool {
        self.of_repository(file, files, |words| words.is_owned(name, file, files))
    }

    /// The root of the repository that contains a file.
    pub fn top(&self, file: &Path, files: &dyn Files) -> Arc<PathBuf> {
        let folder = file.parent().unwrap_or(Path::new(""));
        kept(&self.tops, folder, || top(file, files))
    }

    /// The scripts of the repository that import a shader file.
    pub fn importers(&self, file: &Path, files: &dyn Files) -> Vec<PathBuf> {
        files.depends_on(Dependency::Repository);
        let top = self.top(file, files);
        let imports = kept(&self.imports, &top, OnceLock::new);
        imports
            .get_or_init(|| ShaderImports::under(&top, files))
            .of(file)
            .to_vec()
    }

    /// Asks for GLSL files and chunks of the repository that contains a file.
    pub fn shaders<T>(
        &self,
        file: &Path,
        files: &dyn Files,
        ask: impl FnOnce(&RepositoryShaders) -> T,
    ) -> T {
        files.depends_on(Dependency::Repository);
        let top = self.top(file, files);
        let shaders = kept(&self.shaders, &top, OnceLock::new);
        ask(shaders.get_or_init(|| RepositoryShaders::under(&top, files)))
    }

    /// Whether a program in the repository may write `#version` before shaders.
    pub fn adds_version(&self, file: &Path, files: &dyn Files) -> bool {
        self.of_repository(file, files, |words| words.adds_version || !words.is_all)
    }

    fn of_repository<T>(
        &self,
        file: &Path,
        files: &dyn Files,
        ask: impl FnOnce(&RepositoryWords) -> T,
    ) -> T {
        files.depends_on(Dependency::Repository);
        let top = self.top(file, files);
        let words = kept(&self.words, &top, OnceLock::new);
        ask(words.get_or_init(|| RepositoryWords::under(&top, files)))
    }
}

/// A cached value for the current version of a file or folder. Nothing is cached if the version is
/// unknown.
fn of_version<T>(
    known: &Mutex<HashMap<PathBuf, (u64, Arc<T>)>>,
    files: &dyn Files,
    path: &Path,
    find: impl FnOnce() -> Option<T>,
) -> Option<Arc<T>> {
    // Determined first, so that later changes invalidate the value.
    let version = files.version(path);
    if let (Some(now), Some((then, kept))) = (version, lock(known).get(path))
        && now == *then
    {
        return Some(kept.clone());
    }
    let found = Arc::new(find()?);
    if let Some(version) = version {
        lock(known).insert(path.to_path_buf(), (version, found.clone()));
    }
    Some(found)
}

/// A cached value of a folder, computed on first use.
fn kept<T>(
    known: &Mutex<HashMap<PathBuf, Arc<T>>>,
    folder: &Path,
    find: impl FnOnce() -> T,
) -> Arc<T> {
    if let Some(known) = lock(known).get(folder) {
        return known.clone();
    }
    let found = Arc::new(find());
    lock(known).insert(folder.to_path_buf(), found.clone());
    found
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex
        .lock()
        .unwrap_or_else(|poisoned| poisoned.into_inner())
}
