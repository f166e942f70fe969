//! What is kept of the files around a text, so that each is read once in a run.

use super::files::Files;
use super::include::passes::Passes;
use super::include::scan::IncludedFile;
use super::repository::{RepositoryWords, top};
use std::collections::{BTreeSet, HashMap};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock};

/// What earlier checks have read of files. Options that are cloned share it.
#[derive(Default, Debug)]
pub struct Memo {
    /// By path without links: the version of the file that was read.
    texts: Mutex<HashMap<PathBuf, (u64, Arc<IncludedFile>)>>,
    /// By folder: the version of its names that was read, and the passes of ShaderToy among them.
    passes: Mutex<HashMap<PathBuf, (u64, Arc<Passes>)>>,
    /// By folder, the packages of its project.
    packages: Mutex<HashMap<PathBuf, Arc<BTreeSet<String>>>>,
    /// By folder: the top of its repository.
    tops: Mutex<HashMap<PathBuf, Arc<PathBuf>>>,
    /// By the top of a repository: the words of its code.
    words: Mutex<HashMap<PathBuf, Arc<OnceLock<RepositoryWords>>>>,
}

impl Memo {
    /// What stands in a file, read anew where it has changed.
    pub(super) fn text(&self, files: &dyn Files, real: &Path) -> Option<Arc<IncludedFile>> {
        of_version(&self.texts, files, real, || {
            Some(IncludedFile::new(files.load(real).ok()?))
        })
    }

    /// The files of a folder that are called like passes, listed anew where names have come or gone.
    pub(super) fn passes(&self, files: &dyn Files, folder: &Path) -> Arc<Passes> {
        let found = of_version(&self.passes, files, folder, || {
            Some(Passes::inside(files, folder))
        });
        found.unwrap_or_default()
    }

    /// The packages of a folder's project, which `find` looks for.
    pub(super) fn packages(
        &self,
        folder: &Path,
        find: impl FnOnce() -> BTreeSet<String>,
    ) -> Arc<BTreeSet<String>> {
        kept(&self.packages, folder, find)
    }

    /// Whether a word appears in another file of the repository of this one, and whether all of its
    /// files were read for that.
    pub(super) fn is_beside(&self, word: &str, file: &Path, files: &dyn Files) -> (bool, bool) {
        self.of_repository(file, files, |words| {
            (words.is_beside(word, file), words.is_all)
        })
    }

    /// Whether a program of the repository may write `#version` before the shaders of others.
    pub(super) fn adds_version(&self, file: &Path, files: &dyn Files) -> bool {
        self.of_repository(file, files, |words| words.adds_version || !words.is_all)
    }

    fn of_repository<T>(
        &self,
        file: &Path,
        files: &dyn Files,
        ask: impl FnOnce(&RepositoryWords) -> T,
    ) -> T {
        let folder = file.parent().unwrap_or(Path::new(""));
        let top = kept(&self.tops, folder, || top(file, files));
        let words = kept(&self.words, &top, OnceLock::new);
        ask(words.get_or_init(|| RepositoryWords::under(&top, files)))
    }
}

/// What is known of a file or folder as it is now. Nothing is kept where its version is not known.
fn of_version<T>(
    known: &Mutex<HashMap<PathBuf, (u64, Arc<T>)>>,
    files: &dyn Files,
    path: &Path,
    find: impl FnOnce() -> Option<T>,
) -> Option<Arc<T>> {
    // Asked first: what changes while it is read is read again.
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

/// What is known of a folder, found out where it is not known yet.
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
