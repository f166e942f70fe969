//! The files of the disk, for the engine.

use crate::engine::{FileType, Files, LoadError, MAX_LOADED};
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The files of the disk.
pub struct Disk {
    here: PathBuf,
}

impl Disk {
    /// As the folder that the program runs in sees it.
    pub fn new() -> Disk {
        Disk {
            here: std::env::current_dir().unwrap_or_default(),
        }
    }
}

impl Files for Disk {
    fn load(&self, path: &Path) -> Result<Arc<str>, LoadError> {
        let data = fs::metadata(path).map_err(|_| LoadError::NotFound)?;
        if !data.is_file() {
            return Err(LoadError::NotFound);
        }
        if data.len() > MAX_LOADED {
            return Err(LoadError::TooLarge);
        }
        let text = fs::read_to_string(path);
        text.map(Arc::from).map_err(|e| match e.kind() {
            io::ErrorKind::NotFound => LoadError::NotFound,
            _ => LoadError::Unreadable,
        })
    }

    fn entry(&self, path: &Path) -> Option<FileType> {
        let data = fs::metadata(path).ok()?;
        match data.is_dir() {
            true => Some(FileType::Folder),
            false => data.is_file().then_some(FileType::File),
        }
    }

    fn names(&self, folder: &Path) -> Vec<String> {
        let folder = match folder.as_os_str().is_empty() {
            true => Path::new("."),
            false => folder,
        };
        let entries = fs::read_dir(folder).into_iter().flatten();
        let names = entries.filter_map(|e| e.ok()?.file_name().into_string().ok());
        names.collect()
    }

    fn here(&self) -> &Path {
        &self.here
    }

    fn real(&self, path: &Path) -> Option<PathBuf> {
        path.canonicalize().ok()
    }

    fn version(&self, path: &Path) -> Option<u64> {
        let data = fs::metadata(path).ok()?;
        let mut hasher = DefaultHasher::new();
        (data.len(), data.modified().ok()?).hash(&mut hasher);
        Some(hasher.finish())
    }
}
