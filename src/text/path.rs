//! Paths as text, without access to files.

use std::path::{Component, Path, PathBuf};

/// A path with forward slashes, as every message and every file name in a report has them.
pub fn slashed(path: impl AsRef<Path>) -> String {
    path.as_ref().to_string_lossy().replace('\\', "/")
}

/// Resolves `.` and `..` in an absolute path.
pub fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir => {
                plain.pop();
            }
            part => plain.push(part),
        }
    }
    plain
}

/// Resolves `.` and, as far as possible, `..` in a relative path.
pub fn tidy(path: &Path) -> PathBuf {
    let mut tidied = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir
                if matches!(tidied.components().next_back(), Some(Component::Normal(_))) =>
            {
                tidied.pop();
            }
            part => tidied.push(part),
        }
    }
    tidied
}

/// The path from a folder to a file; `None` if both are the same.
pub fn relative(folder: &Path, file: &Path) -> Option<String> {
    let same = folder.components().zip(file.components());
    let common = same.take_while(|(a, b)| a == b).count();
    let up = folder.components().skip(common);
    let up = up.map(|_| Component::ParentDir);
    let path: PathBuf = up.chain(file.components().skip(common)).collect();
    let path = slashed(path);
    (!path.is_empty()).then_some(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_resolved_without_files() {
        let all = ["a/../b", "../a/./b", "a/../../b"].map(Path::new);
        assert_eq!(all.map(|p| slashed(tidy(p))), ["b", "../a/b", "../b"]);
        assert_eq!(slashed(plain(Path::new("/a/./b/../c"))), "/a/c");
        assert_eq!(slashed("a\\b"), "a/b");
    }

    #[test]
    fn relative_paths_lead_from_a_folder_to_a_file() {
        let from = |folder: &str, file: &str| relative(Path::new(folder), Path::new(file));
        assert_eq!(from("/a/b", "/a/c/d.glsl").as_deref(), Some("../c/d.glsl"));
        assert_eq!(from("/a", "/a/b.glsl").as_deref(), Some("b.glsl"));
        assert_eq!(from("/a", "/a"), None);
    }
}
