//! Writes files atomically, without overwriting by default; and renders changes as a diff.

use similar::TextDiff;
use std::fs;
use std::io::{self, Write};
use std::path::Path;

/// Whether an existing file may be replaced.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Overwrite {
    /// An existing file is an error.
    Never,
    /// An existing file is replaced.
    Allowed,
}

impl Overwrite {
    /// What `--force` allows.
    pub fn if_forced(is_forced: bool) -> Overwrite {
        match is_forced {
            true => Overwrite::Allowed,
            false => Overwrite::Never,
        }
    }
}

/// Writes a file atomically, and creates missing folders.
pub fn write(path: &Path, content: &[u8], overwrite: Overwrite) -> io::Result<()> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    fs::create_dir_all(folder)?;
    let mut file = tempfile::Builder::new()
        .prefix(".shaderport")
        .tempfile_in(folder)?;
    file.write_all(content)?;
    readable(file.as_file())?;
    match overwrite {
        Overwrite::Never => file.persist_noclobber(path)?,
        Overwrite::Allowed => file.persist(path)?,
    };
    Ok(())
}

/// Replaces the content of a file, which keeps its permissions and, if allowed, its owner. Fails if
/// the file is read-only or no longer contains `old`. Follows symbolic links.
pub fn replace(path: &Path, old: &[u8], new: &[u8]) -> io::Result<()> {
    let path = fs::canonicalize(path)?;
    let metadata = fs::metadata(&path)?;
    if metadata.permissions().readonly() {
        return Err(io::Error::other("the file is read-only"));
    }
    let folder = path.parent().unwrap_or(Path::new("."));
    let mut file = tempfile::Builder::new()
        .prefix(".shaderlint")
        .tempfile_in(folder)?;
    file.write_all(new)?;
    keep_owner(&metadata, file.path());
    file.as_file().set_permissions(metadata.permissions())?;
    if fs::read(&path)? != old {
        return Err(io::Error::other("the file changed in the meantime"));
    }
    file.persist(&path)?;
    Ok(())
}

/// Copies the owner of a file, if this process may do so.
#[cfg(unix)]
fn keep_owner(of: &fs::Metadata, file: &Path) {
    use std::os::unix::fs::{MetadataExt, chown};
    let _ = chown(file, Some(of.uid()), Some(of.gid()));
}

#[cfg(not(unix))]
fn keep_owner(_of: &fs::Metadata, _file: &Path) {}

/// Makes a file readable for everybody; temporary files are private to their owner.
#[cfg(unix)]
fn readable(file: &fs::File) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    file.set_permissions(fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn readable(_file: &fs::File) -> io::Result<()> {
    Ok(())
}

/// A unified diff, as `diff -u` writes it.
pub fn diff(name: &str, old: &str, new: &str) -> String {
    TextDiff::from_lines(old, new)
        .unified_diff()
        .header(&format!("a/{name}"), &format!("b/{name}"))
        .to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_changed_in_the_meantime_are_not_overwritten() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.glsl");
        fs::write(&path, "new").unwrap();
        let error = replace(&path, b"old", b"fixed").unwrap_err();
        assert_eq!(error.to_string(), "the file changed in the meantime");
        assert_eq!(fs::read(&path).unwrap(), b"new");
        replace(&path, b"new", b"fixed").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"fixed");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }
}
