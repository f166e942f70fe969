//! The project that contains a file, which limits what its shaders may include.

use super::load::FILE;
use shaderlint_project::{FileType, Files};
use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard};

/// What limits the files of a project.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ProjectLimit {
    /// Its outermost folder, which is not the home folder of the user.
    Folder {
        /// The home folder, if it is known.
        home: Option<PathBuf>,
    },
    /// Nothing: all files were sent for the project.
    Nothing,
}

/// The folders of a project.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct ProjectFolders {
    /// The outermost folder, without symbolic links; includes may not leave it. Empty for no limit.
    pub root: PathBuf,
    /// Folders that a leading `/` in an include may refer to, nearest first.
    pub tops: Vec<PathBuf>,
}

/// What marks a folder as a project: a package, a configuration, a repository.
const MARKS: [&str; 3] = ["package.json", FILE, ".git"];

/// By mark: the nearest folder that has it.
type MarkedFolders = [Option<PathBuf>; MARKS.len()];

/// Finds the projects around folders. Reads the marks of each folder once.
pub struct ProjectFinder {
    /// The paths on the command line, or the folders of a workspace.
    named: HashSet<PathBuf>,
    limit: ProjectLimit,
    marked: Mutex<HashMap<PathBuf, MarkedFolders>>,
}

impl ProjectFinder {
    /// `named` are the paths on the command line, or the folders of a workspace.
    pub fn new(named: HashSet<PathBuf>, limit: ProjectLimit) -> ProjectFinder {
        ProjectFinder {
            named,
            limit,
            marked: Mutex::default(),
        }
    }

    /// The project around the folder of a file.
    ///
    /// A project is a repository, a folder with a configuration or a package, a folder on the
    /// command line, or the current folder. The outermost one limits what may be read.
    pub fn around(&self, files: &dyn Files, folder: &Path) -> ProjectFolders {
        let mut tops = self.found(files, folder);
        if self.limit == ProjectLimit::Nothing {
            let root = PathBuf::new();
            return ProjectFolders { root, tops };
        }
        if tops.is_empty() {
            tops.push(folder.to_path_buf());
        }
        let root = tops.last().and_then(|root| files.real(root));
        ProjectFolders {
            root: root.unwrap_or_default(),
            tops,
        }
    }

    /// The folders of the project around a folder, nearest first; none if nothing marks a project.
    ///
    /// A repository ends a project: a downloaded one in a folder of another is on its own.
    pub fn found(&self, files: &dyn Files, folder: &Path) -> Vec<PathBuf> {
        let marked = self.marked(files, folder);
        let [.., repository] = &marked;
        let mut tops: Vec<PathBuf> = marked.iter().flatten().cloned().collect();
        if let ProjectLimit::Folder { home } = &self.limit {
            tops.extend(owner(folder));
            tops.push(files.here().to_path_buf());
            // A repository in the home folder or at the root holds settings of the machine, not a
            // project.
            tops.retain(|f| {
                f.parent().is_some() && Some(f) != home.as_ref() && folder.starts_with(f)
            });
        }
        let named = folder.ancestors().filter(|f| self.named.contains(*f));
        let named = named.filter(|f| files.entry(f) == Some(FileType::Folder));
        tops.extend(named.map(Path::to_path_buf));
        if let Some(repository) = repository.as_ref().filter(|f| tops.contains(f)) {
            let repository = repository.clone();
            tops.retain(|f| f.starts_with(&repository));
        }
        tops.sort_by_key(|f| std::cmp::Reverse(f.components().count()));
        tops.dedup();
        tops
    }

    /// The nearest marked folders, of this one and those above.
    fn marked(&self, files: &dyn Files, folder: &Path) -> MarkedFolders {
        if let Some(known) = self.lock().get(folder) {
            return known.clone();
        }
        let above = folder.parent().map(|above| self.marked(files, above));
        let mut marked = above.unwrap_or_default();
        for (slot, mark) in marked.iter_mut().zip(MARKS) {
            if files.entry(&folder.join(mark)).is_some() {
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
