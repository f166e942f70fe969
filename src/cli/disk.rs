//! Implements [`Files`] for the file system.

use crate::project::{FileType, Files, LoadError, MAX_LOADED};
use crate::text::{Content, Encoding};
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, SystemTime};

/// Changes within this time may have the same modification time. Clocks of file systems tick about
/// every ten milliseconds.
const TICK: Duration = Duration::from_millis(100);

/// The file system.
pub struct Disk {
    here: PathBuf,
}

impl Disk {
    /// Relative paths are resolved against the current folder.
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
        let bytes = fs::read(path).map_err(|e| match e.kind() {
            io::ErrorKind::NotFound => LoadError::NotFound,
            _ => LoadError::Unreadable,
        })?;
        // As the file itself is checked: a damaged character is no reason to read nothing.
        if let Some(text) = Content::utf16(&bytes) {
            return Ok(text.into());
        }
        match Content::of(bytes) {
            Content {
                encoding: Encoding::Binary,
                ..
            } => Err(LoadError::Unreadable),
            Content { text, .. } => Ok(text.into()),
        }
    }

    fn entry(&self, path: &Path) -> Option<FileType> {
        let data = fs::metadata(path).ok()?;
        match data.is_dir() {
            true => Some(FileType::Folder),
            false => data.is_file().then_some(FileType::File),
        }
    }

    fn names(&self, folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(named(folder)).into_iter().flatten();
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
        let data = fs::metadata(named(path)).ok()?;
        version_of(data.len(), data.modified().ok()?, SystemTime::now())
    }
}

/// The version of a file of `size` bytes. `None` while the file could change again with the same
/// modification time.
fn version_of(size: u64, modified: SystemTime, now: SystemTime) -> Option<u64> {
    if now.duration_since(modified).is_ok_and(|age| age < TICK) {
        return None;
    }
    let mut hasher = DefaultHasher::new();
    (size, modified).hash(&mut hasher);
    Some(hasher.finish())
}

/// A path for the operating system, to which the current folder is `.` and not an empty path.
fn named(path: &Path) -> &Path {
    match path.as_os_str().is_empty() {
        true => Path::new("."),
        false => path,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn recently_written_files_have_no_version() {
        let now = SystemTime::now();
        let at = |age| version_of(8, now - age, now);
        assert_eq!(at(Duration::ZERO), None);
        assert_eq!(at(TICK / 2), None);
        assert!(at(TICK).is_some());
        assert_ne!(at(TICK), at(2 * TICK));
        assert_ne!(at(TICK), version_of(9, now - TICK, now));
        assert!(version_of(8, now + TICK, now).is_some());
    }

    #[test]
    fn an_empty_path_is_the_current_folder() {
        assert_eq!(named(Path::new("")), Path::new("."));
        assert_eq!(named(Path::new("a")), Path::new("a"));
    }
}
