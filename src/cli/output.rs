//! Writing files: whole or not at all, and never over another without being told to.

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
