//! Access to files, provided by the caller of the engine, and what is remembered of them.

pub mod family;
pub mod file_cache;
pub mod for_others;
pub mod imports;
pub mod manifest;
pub mod pass_name;
pub mod passes;
pub mod repository;
pub mod scan;
pub mod shaders;
pub mod words;

use shaderlint_text::path::plain;
use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Size limit of [`Files::load`] in bytes.
pub const MAX_LOADED: u64 = 4 * 1024 * 1024;

/// Files by path: a disk, the buffers of an editor, a map. Relative paths are resolved against
/// [`Files::here`].
pub trait Files: Sync {
    /// Reads a file.
    ///
    /// # Errors
    /// If there is no such file, or it cannot be read.
    fn load(&self, path: &Path) -> Result<Arc<str>, LoadError>;

    /// The type of the entry at a path.
    fn entry(&self, path: &Path) -> Option<FileType>;

    /// The names in a folder, in any order.
    fn names(&self, folder: &Path) -> Vec<String>;

    /// The folder that relative paths are resolved against.
    fn here(&self) -> &Path;

    /// The absolute path without `..` and symbolic links; `None` if there is no entry.
    fn real(&self, path: &Path) -> Option<PathBuf> {
        self.entry(path).map(|_| plain(&self.here().join(path)))
    }

    /// A number that changes whenever the text of a file, or the names in a folder, change; `None`
    /// if unknown, which disables caching.
    fn version(&self, _path: &Path) -> Option<u64> {
        None
    }

    /// Notes what a check depends on that it does not ask here, because it is known already.
    fn depends_on(&self, _what: Dependency<'_>) {}
}

/// What a check depends on, besides its own text and options and what it asks [`Files`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Dependency<'a> {
    /// The text of a file.
    Text(&'a Path),
    /// The names in a folder.
    Names(&'a Path),
    /// Whether the file of this name is checked in the same run.
    Checked(&'a str),
    /// All code of the repository.
    Repository,
}

/// The type of a directory entry.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FileType {
    /// A regular file.
    File,
    /// A folder.
    Folder,
}

/// Why a file cannot be loaded.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LoadError {
    /// There is no such file.
    NotFound,
    /// The file has more than [`MAX_LOADED`] bytes.
    TooLarge,
    /// The file cannot be read, or is not UTF-8.
    Unreadable,
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            LoadError::NotFound => "file not found",
            LoadError::TooLarge => "the file is too large",
            LoadError::Unreadable => "cannot read the file",
        })
    }
}

impl std::error::Error for LoadError {}

/// A file system without files, for texts on their own.
#[derive(Clone, Copy, Default, Debug)]
pub struct NoFiles;

impl Files for NoFiles {
    fn load(&self, _path: &Path) -> Result<Arc<str>, LoadError> {
        Err(LoadError::NotFound)
    }

    fn entry(&self, _path: &Path) -> Option<FileType> {
        None
    }

    fn names(&self, _folder: &Path) -> Vec<String> {
        Vec::new()
    }

    fn here(&self) -> &Path {
        Path::new("/")
    }
}

/// Files by absolute path, such as `/shaders/noise.glsl`.
impl Files for BTreeMap<PathBuf, Arc<str>> {
    fn load(&self, path: &Path) -> Result<Arc<str>, LoadError> {
        let text = self.get(&plain(&self.here().join(path)));
        text.cloned().ok_or(LoadError::NotFound)
    }

    fn entry(&self, path: &Path) -> Option<FileType> {
        let path = plain(&self.here().join(path));
        if self.contains_key(&path) {
            return Some(FileType::File);
        }
        let mut after = self.range(path.clone()..).map(|(p, _)| p);
        let is_folder = after.next().is_some_and(|p| p.starts_with(&path));
        is_folder.then_some(FileType::Folder)
    }

    fn names(&self, folder: &Path) -> Vec<String> {
        let folder = plain(&self.here().join(folder));
        let name = |path: &PathBuf| {
            let first = path.strip_prefix(&folder).ok()?.components().next()?;
            Some(first.as_os_str().to_string_lossy().into_owned())
        };
        let mut names: Vec<String> = self.keys().filter_map(name).collect();
        names.dedup();
        names
    }

    fn here(&self) -> &Path {
        Path::new("/")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_of_an_in_memory_file_map_exist() {
        let paths = ["/a/b.glsl", "/a/c/d.glsl", "/a.glsl"];
        let files: BTreeMap<PathBuf, Arc<str>> =
            paths.iter().map(|p| (p.into(), "x".into())).collect();
        assert_eq!(
            files.entry(Path::new("a/./c/../b.glsl")),
            Some(FileType::File)
        );
        assert_eq!(files.entry(Path::new("/a/c")), Some(FileType::Folder));
        assert_eq!(files.entry(Path::new("/b")), None);
        assert_eq!(files.names(Path::new("/a")), ["b.glsl", "c"]);
        assert_eq!(files.names(Path::new("")), ["a", "a.glsl"]);
        assert_eq!(files.load(Path::new("c.glsl")), Err(LoadError::NotFound));
    }
}
