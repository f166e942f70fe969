//! Files in memory, and the options that their configurations give.

use shaderlint_engine::Options;
use shaderlint_engine::config::{ConfigArgs, Configs, ProjectLimit, Selection};
use shaderlint_project::{FileType, Files, LoadError};
use shaderlint_text::path::plain;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard};

/// Files by absolute path. Those of a workspace change while it is used.
#[derive(Default)]
pub struct MemoryFiles {
    texts: Mutex<BTreeMap<PathBuf, Arc<str>>>,
}

impl MemoryFiles {
    /// Files with these contents.
    pub fn new<'a>(texts: impl IntoIterator<Item = (&'a PathBuf, &'a String)>) -> MemoryFiles {
        let texts = texts.into_iter();
        let texts = texts.map(|(path, text)| (absolute(path), Arc::from(text.as_str())));
        MemoryFiles {
            texts: Mutex::new(texts.collect()),
        }
    }

    /// Replaces the text of a file, or removes it. Returns whether there was one.
    pub fn put(&self, path: PathBuf, text: Option<&str>) -> bool {
        let mut texts = self.lock();
        let before = match text {
            Some(text) => texts.insert(absolute(&path), Arc::from(text)),
            None => texts.remove(&absolute(&path)),
        };
        before.is_some()
    }

    /// The files in a folder and in those below.
    pub fn below(&self, folder: &Path) -> Vec<PathBuf> {
        let texts = self.lock();
        let folder = absolute(folder);
        let from = texts.range(folder.clone()..).map(|(path, _)| path);
        from.take_while(|path| path.starts_with(&folder))
            .cloned()
            .collect()
    }

    fn lock(&self) -> MutexGuard<'_, BTreeMap<PathBuf, Arc<str>>> {
        let texts = self.texts.lock();
        texts.unwrap_or_else(|poisoned| poisoned.into_inner())
    }
}

/// A path from the root, which is the current folder.
fn absolute(path: &Path) -> PathBuf {
    plain(&Path::new("/").join(path))
}

/// The options of a file: `given` and those of its configuration.
pub fn options_of(
    files: &Arc<MemoryFiles>,
    name: &str,
    given: Selection,
) -> Result<Options, String> {
    let asked = ConfigArgs {
        given,
        ..ConfigArgs::default()
    };
    let configs = Configs::new(files.clone(), ProjectLimit::Nothing, asked);
    let options = configs.options(Path::new(name));
    options
        .map(|o| Options::clone(&o))
        .map_err(|e| e.to_string())
}

impl Files for MemoryFiles {
    fn load(&self, path: &Path) -> Result<Arc<str>, LoadError> {
        let text = self.lock().get(&absolute(path)).cloned();
        text.ok_or(LoadError::NotFound)
    }

    fn entry(&self, path: &Path) -> Option<FileType> {
        let texts = self.lock();
        let path = &absolute(path);
        let (first, _) = texts.range(path.clone()..).next()?;
        match first {
            first if first == path => Some(FileType::File),
            first => first.starts_with(path).then_some(FileType::Folder),
        }
    }

    fn names(&self, folder: &Path) -> Vec<String> {
        let folder = absolute(folder);
        let inside = self.below(&folder);
        let names = inside.iter().filter_map(|path| {
            let name = path.strip_prefix(&folder).ok()?.components().next()?;
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn in_memory_files_have_folders() {
        let texts = ["/a/b.glsl", "/a-c.glsl", "/a/d/e.glsl"];
        let texts = texts.map(|path| (PathBuf::from(path), String::new()));
        let files = MemoryFiles::new(&BTreeMap::from(texts));
        assert_eq!(files.names(Path::new("/a")), ["b.glsl", "d"]);
        assert_eq!(files.entry(Path::new("/a")), Some(FileType::Folder));
        assert_eq!(files.entry(Path::new("/a/b.glsl")), Some(FileType::File));
        assert_eq!(files.entry(Path::new("/a/b")), None);
        assert!(files.load(Path::new("/a/d/e.glsl")).is_ok());
    }
}
