//! Tests in a separate file: `noise.test.glsl` is compiled with `noise.glsl` before it.

use super::find::EXTENSIONS;
use crate::FileType;
use crate::access::FileAccess;
use std::path::{Path, PathBuf};

/// The functions that a file of tests may call and GLSL does not have.
const APPROX: &str = include_str!("approx.glsl");

/// What is declared before the text of a file of tests, unless its shader declares it.
pub fn test_prelude(name: &str, text: &str, subject: Option<&str>) -> Option<&'static str> {
    let stem = Path::new(name).file_stem()?.to_str()?;
    let declares = |text: &str| {
        ["bool approx", "float approx"]
            .iter()
            .any(|d| text.contains(d))
    };
    let is_asked = stem.ends_with(".test") && text.contains("approx") && !text.contains("#version");
    let is_free = !declares(text) && !subject.is_some_and(declares);
    (is_asked && is_free).then_some(APPROX)
}

/// The file that a test file tests. A text with `#version` is complete on its own.
pub fn subject_of(name: &str, text: &str, context: FileAccess) -> Option<PathBuf> {
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
