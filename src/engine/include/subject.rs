//! Tests in a separate file: `noise.test.glsl` is compiled with `noise.glsl` before it.

use super::super::world::World;
use super::find::ENDINGS;
use crate::FileType;
use std::path::{Path, PathBuf};

/// The file that a test file tests. A text with `#version` is complete on its own.
pub fn subject_of(name: &str, text: &str, world: World) -> Option<PathBuf> {
    let path = Path::new(name);
    let ending = path.extension()?.to_str()?;
    let file = path.file_name()?.to_str()?;
    let stem = file.strip_suffix(ending)?.strip_suffix(".test.")?;
    if stem.is_empty() || text.contains("#version") {
        return None;
    }
    let endings = std::iter::once(ending).chain(ENDINGS);
    let mut all = endings.map(|e| path.with_file_name(format!("{stem}.{e}")));
    all.find(|path| world.files.entry(path) == Some(FileType::File))
}
