//! Output paths, and the files that must not be overwritten.

use super::read::plain_error;
use crate::cli::output::{Overwrite, write};
use crate::port::{Destination, File, Target};
use std::fs;
use std::path::{Path, PathBuf};

/// The output path of the command line, as a file or a folder.
pub(super) enum OutputPlace {
    Standard,
    /// One file; further files are written next to it.
    File(PathBuf),
    /// A folder, for shaders with generated names.
    Folder(PathBuf),
}

impl OutputPlace {
    /// The output place of a project with this title. A folder is an existing folder or a path that
    /// ends in a slash; for shaders also a new path without an extension.
    pub(super) fn of(path: Option<&Path>, target: Target, title: &str) -> OutputPlace {
        let Some(path) = path.filter(|p| p.as_os_str() != "-") else {
            return OutputPlace::Standard;
        };
        let is_folder = path.is_dir() || path.to_string_lossy().ends_with(['/', '\\']);
        let may_be_folder = path.extension().is_none() && !path.exists();
        match target.is_shaders() {
            true if is_folder || may_be_folder => OutputPlace::Folder(path.to_path_buf()),
            false if is_folder => {
                let name = format!("{}.{}", file_name(title), target.extension());
                OutputPlace::File(path.join(name))
            }
            _ => OutputPlace::File(path.to_path_buf()),
        }
    }

    /// The destination for the build.
    pub(super) fn output(&self) -> Destination<'_> {
        match self {
            OutputPlace::Standard => Destination::Standard,
            OutputPlace::File(path) => Destination::File(path),
            OutputPlace::Folder(path) => Destination::Folder(path),
        }
    }
}

/// A title as a file name.
pub(super) fn file_name(title: &str) -> String {
    let kept = |c: char| c.is_alphanumeric() || c == '-';
    let words = title.split(|c| !kept(c)).filter(|w| !w.is_empty());
    let name: String = words.collect::<Vec<_>>().join("_");
    match name.chars().take(60).collect::<String>() {
        name if name.is_empty() => "shader".to_string(),
        name => name,
    }
}

/// Writes all files, or none if one of them cannot be written. Files that were `read` are never
/// overwritten.
pub(in crate::cli) fn save(
    files: &[File],
    overwrite: Overwrite,
    read: &[PathBuf],
) -> Result<(), String> {
    for (i, File { path, .. }) in files.iter().enumerate() {
        let shown = path.display();
        if files.iter().take(i).any(|f| f.path == *path) {
            return Err(format!(
                "two files would be written to {shown}; use a name such as `a.frag`, and the other \
                 is written next to it"
            ));
        }
        let Ok(there) = path.symlink_metadata() else {
            match path.ancestors().skip(1).find(|p| p.exists()) {
                Some(above) if !above.is_dir() => {
                    return Err(format!("{} is not a folder", above.display()));
                }
                _ => continue,
            }
        };
        if read.iter().any(|r| is_same(r, path)) {
            return Err(format!("{shown} is an input file; choose another output"));
        }
        if !there.is_file() {
            let kind = match there.file_type() {
                kind if kind.is_dir() => "a folder",
                kind if kind.is_symlink() => "a symbolic link",
                _ => "a device",
            };
            return Err(format!(
                "cannot overwrite {shown}: it is {kind}, not a regular file; omit `-o` to write to \
                 standard output"
            ));
        }
        if overwrite == Overwrite::Never {
            return Err(already_exists(path));
        }
    }
    for File { path, content } in files {
        let wrong = |e| format!("{}: {}", path.display(), plain_error(&e));
        write(path, content, overwrite).map_err(wrong)?;
    }
    Ok(())
}

/// The message about a file that would be overwritten.
pub(super) fn already_exists(path: &Path) -> String {
    let shown = path.display();
    format!("{shown} already exists; use --force to overwrite it")
}

/// Whether two paths refer to the same file, including hard links.
#[cfg(unix)]
fn is_same(a: &Path, b: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let id = |path: &Path| fs::metadata(path).map(|m| (m.dev(), m.ino())).ok();
    id(a).is_some_and(|own| id(b) == Some(own))
}

#[cfg(not(unix))]
fn is_same(a: &Path, b: &Path) -> bool {
    let real = |path: &Path| fs::canonicalize(path).ok();
    real(a).is_some_and(|own| real(b) == Some(own))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_outputs_with_the_same_path_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.wgsl");
        let file = |content: &str| File {
            path: path.clone(),
            content: content.as_bytes().to_vec(),
        };
        let result = save(&[file("one"), file("two")], Overwrite::Allowed, &[]);
        assert!(
            result
                .unwrap_err()
                .starts_with("two files would be written")
        );
        assert!(!path.exists());
    }

    #[test]
    fn titles_become_valid_file_names() {
        assert_eq!(file_name("Sea, deep/../blue"), "Sea_deep_blue");
        assert_eq!(file_name("../"), "shader");
        assert_eq!(file_name(&"a".repeat(99)).len(), 60);
    }
}
