//! The project that contains a file, which limits what its shaders may include.

use crate::engine::path::plain;
use std::path::{Path, PathBuf};

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

impl ProjectFolders {
    /// The project around the folder of a file. `named` are the paths on the command line.
    ///
    /// A project is a repository, a folder with a configuration or a package, a folder on the
    /// command line, or the current folder. The outermost one limits what may be read.
    pub fn around(folder: &Path, named: &[PathBuf]) -> ProjectFolders {
        let nearest = |name: &str| {
            let mut above = folder.ancestors();
            above.find(|f| f.join(name).exists()).map(Path::to_path_buf)
        };
        let home = std::env::var_os("HOME").map(PathBuf::from);
        // A repository in the home folder or at the root holds settings of the machine, not a
        // project.
        let is_narrow =
            |f: &PathBuf| f.parent().is_some() && Some(f) != home.as_ref() && folder.starts_with(f);
        let marked = ["package.json", FILE, ".git"].into_iter();
        let marked = marked.filter_map(nearest).filter(is_narrow);
        let mut tops: Vec<PathBuf> = marked.collect();
        tops.extend(owner(folder).filter(is_narrow));
        tops.extend(std::env::current_dir().ok().filter(is_narrow));
        let named = named.iter().map(|p| absolute(p));
        tops.extend(named.filter(|p| folder.starts_with(p) && p.is_dir()));
        tops.sort_by_key(|f| std::cmp::Reverse(f.components().count()));
        tops.dedup();
        if tops.is_empty() {
            tops.push(folder.to_path_buf());
        }
        ProjectFolders {
            root: tops.last().cloned().unwrap_or_default(),
            tops,
        }
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
