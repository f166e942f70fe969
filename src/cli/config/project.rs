//! The project that contains a file, which limits what its shaders may include.

use crate::text::path::plain;
use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard};

/// Name of the configuration file.
pub const FILE: &str = "shaderlint.toml";

/// The folders of a project.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct ProjectFolders {
    /// The outermost folder; includes may not leave it.
    pub root: PathBuf,
    /// Folders that a leading `/` in an include may refer to, nearest first; the last is the root.
    pub tops: Vec<PathBuf>,
}

/// What marks a folder as a project: a package, a configuration, a repository.
const MARKS: [&str; 3] = ["package.json", FILE, ".git"];

/// By mark: the nearest folder that has it.
type MarkedFolders = [Option<PathBuf>; MARKS.len()];

/// Finds the projects around folders. Reads the marks of each folder once.
pub struct ProjectFinder {
    /// The paths on the command line.
    named: HashSet<PathBuf>,
    here: Option<PathBuf>,
    home: Option<PathBuf>,
    marked: Mutex<HashMap<PathBuf, MarkedFolders>>,
}

impl ProjectFinder {
    /// `named` are the paths on the command line.
    pub fn new(named: &[PathBuf]) -> ProjectFinder {
        ProjectFinder {
            named: named.iter().map(|p| absolute(p)).collect(),
            here: std::env::current_dir().ok(),
            home: std::env::var_os("HOME").map(PathBuf::from),
            marked: Mutex::default(),
        }
    }

    /// The project around the folder of a file.
    ///
    /// A project is a repository, a folder with a configuration or a package, a folder on the
    /// command line, or the current folder. The outermost one limits what may be read.
    pub fn around(&self, folder: &Path) -> ProjectFolders {
        let mut tops = self.found(folder);
        if tops.is_empty() {
            tops.push(folder.to_path_buf());
        }
        ProjectFolders {
            root: tops.last().cloned().unwrap_or_default(),
            tops,
        }
    }

    /// The folders of the project around a folder, nearest first; none if nothing marks a project.
    pub fn found(&self, folder: &Path) -> Vec<PathBuf> {
        // A repository in the home folder or at the root holds settings of the machine, not a
        // project.
        let is_narrow = |f: &PathBuf| {
            f.parent().is_some() && Some(f) != self.home.as_ref() && folder.starts_with(f)
        };
        let marked = self.marked(folder).into_iter().flatten();
        let mut tops: Vec<PathBuf> = marked.filter(is_narrow).collect();
        tops.extend(owner(folder).filter(is_narrow));
        tops.extend(self.here.clone().filter(is_narrow));
        let named = folder.ancestors().filter(|f| self.named.contains(*f));
        tops.extend(named.filter(|f| f.is_dir()).map(Path::to_path_buf));
        tops.sort_by_key(|f| std::cmp::Reverse(f.components().count()));
        tops.dedup();
        tops
    }

    /// The nearest marked folders, of this one and those above.
    fn marked(&self, folder: &Path) -> MarkedFolders {
        if let Some(known) = self.lock().get(folder) {
            return known.clone();
        }
        let above = folder.parent().map(|above| self.marked(above));
        let mut marked = above.unwrap_or_default();
        for (slot, mark) in marked.iter_mut().zip(MARKS) {
            if folder.join(mark).exists() {
                *slot = Some(folder.to_path_buf());
            }
        }
        self.lock().insert(folder.to_path_buf(), marked.clone());
        marked
    }

    fn lock(&self) -> MutexGuard<'_, HashMap<PathBuf, MarkedFolders>> {
        self.marked
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner())
    }
}

/// The folder that contains `node_modules`: packages may include files of each other.
fn owner(folder: &Path) -> Option<PathBuf> {
    let mut inside = folder.ancestors();
    let packages = inside
        .by_ref()
        .filter(|f| f.ends_with("node_modules"))
        .last();
    Some(packages?.parent()?.to_path_buf())
}

/// An absolute path without `..`, resolved lexically.
pub fn absolute(path: &Path) -> PathBuf {
    let path = std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf());
    plain(&path)
}
