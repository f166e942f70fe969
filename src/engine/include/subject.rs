//! Tests in a separate file: `noise.test.glsl` is compiled with `noise.glsl` before it.

use super::super::check_context::CheckContext;
use super::find::EXTENSIONS;
use crate::FileType;
use std::path::{Path, PathBuf};

/// The file that a test file tests. A text with `#version` is complete on its own.
pub fn subject_of(name: &str, text: &str, context: CheckContext) -> Option<PathBuf> {
    let path = Path::new(name);
    let extension = path.extension()?.to_str()?;
    let file = path.file_name()?.to_str()?;
    let stem = file.strip_suffix(extension)?.strip_suffix(".test.")?;
    if stem.is_empty() || text.contains("#version") {
        return None;
    }
    let extensions = std::iter::once(extension).chain(EXTENSIONS);
    let mut all = extensions.map(|e| path.with_file_name(format!("{stem}.{e}")));
    all.find(|path| context.files.entry(path) == Some(FileType::File))
}
