//! The project that a file belongs to: what its shaders may include.

use crate::engine::path::plain;
use std::path::{Path, PathBuf};

/// Name of the file.
pub const FILE: &str = "shaderlint.toml";

/// A project.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct ProjectFolders {
    /// The folder that no include may leave.
    pub root: PathBuf,
    /// What a leading `/` in a path may mean, the nearest first; the last is the root.
    pub tops: Vec<PathBuf>,
}

impl ProjectFolders {
    /// The project around a folder of files. `named` are the paths that the user gave.
    ///
    /// A repository, a configuration, a package, the folder that the user named and the one that the
    /// program runs in each hold a project; the outermost is what may be read.
    pub fn around(folder: &Path, named: &[PathBuf]) -> ProjectFolders {
        let nearest = |name: &str| {
            let mut above = folder.ancestors();
            above.find(|f| f.join(name).exists()).map(Path::to_path_buf)
        };
        let home = std::env::var_os("HOME").map(PathBuf::from);
        // Who keeps the settings of a whole machine in a repository has no project in mind.
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

/// The folder that a package's files are installed for: packages name each other.
fn owner(folder: &Path) -> Option<PathBuf> {
    let mut inside = folder.ancestors();
    let packages = inside
        .by_ref()
        .filter(|f| f.ends_with("node_modules"))
        .last();
    Some(packages?.parent()?.to_path_buf())
}

/// A path from the root of the file system without `..`, as far as that can be told without asking it.
pub fn absolute(path: &Path) -> PathBuf {
    let path = std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf());
    plain(&path)
}
