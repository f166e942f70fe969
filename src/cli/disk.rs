//! The files of the disk, for the engine.

use crate::engine::{FileType, Files, LoadError, MAX_LOADED};
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, SystemTime};

/// How long after a change another one may have the same time. Clocks of file systems tick about every
/// ten milliseconds.
const TICK: Duration = Duration::from_millis(100);

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
        let modified = data.modified().ok()?;
        if let Ok(age) = SystemTime::now().duration_since(modified)
            && age < TICK
        {
            return None;
        }
        let mut hasher = DefaultHasher::new();
        (data.len(), modified).hash(&mut hasher);
        Some(hasher.finish())
    }
}

/// A path as the system knows it: the folder that relative paths count from has no name in them.
fn named(path: &Path) -> &Path {
    match path.as_os_str().is_empty() {
        true => Path::new("."),
        false => path,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs::FileTimes;

    #[test]
    fn what_was_written_just_now_has_no_version() -> io::Result<()> {
        let folder = tempfile::tempdir()?;
        let path = folder.path().join("a.glsl");
        fs::write(&path, "float a;")?;
        let disk = Disk::new();
        assert_eq!(disk.version(&path), None);
        let at = |seconds| SystemTime::now() - Duration::from_secs(seconds);
        let set = |seconds| {
            let times = FileTimes::new().set_modified(at(seconds));
            fs::File::options()
                .write(true)
                .open(&path)?
                .set_times(times)
        };
        set(2)?;
        let before = disk.version(&path);
        set(1)?;
        assert!(before.is_some() && disk.version(&path) != before);
        assert!(disk.version(Path::new("")).is_some());
        Ok(())
    }
}
