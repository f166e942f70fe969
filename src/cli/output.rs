//! Writing files: whole or not at all, and never over another without being told to; and what would
//! be written, as a diff.

use similar::TextDiff;
use std::fs;
use std::io::{self, Write};
use std::path::Path;

/// Whether a file may take the place of another.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Overwrite {
    /// No.
    Never,
    /// Yes.
    Allowed,
}

/// Writes a file. The folder is made where it is missing.
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

/// Puts new content in the place of a file, which keeps its permissions. Nothing is written where the
/// file does not hold `old` any more. A link stays a link: the file that it leads to is replaced.
pub fn replace(path: &Path, old: &[u8], new: &[u8]) -> io::Result<()> {
    let path = fs::canonicalize(path)?;
    let folder = path.parent().unwrap_or(Path::new("."));
    let mut file = tempfile::Builder::new()
        .prefix(".shaderlint")
        .tempfile_in(folder)?;
    file.write_all(new)?;
    file.as_file()
        .set_permissions(fs::metadata(&path)?.permissions())?;
    if fs::read(&path)? != old {
        return Err(io::Error::other("the file has changed meanwhile"));
    }
    file.persist(&path)?;
    Ok(())
}

/// Temporary files are for their owner alone; what is written is for everybody to read.
#[cfg(unix)]
fn readable(file: &fs::File) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    file.set_permissions(fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn readable(_file: &fs::File) -> io::Result<()> {
    Ok(())
}

/// The way from an old text to a new one, as `diff -u` writes it.
pub fn diff(name: &str, old: &str, new: &str) -> String {
    TextDiff::from_lines(old, new)
        .unified_diff()
        .header(&format!("a/{name}"), &format!("b/{name}"))
        .to_string()
}
