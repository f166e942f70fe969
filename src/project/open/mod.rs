//! Opens what a user names as a project: a shader with its includes and the passes beside it, a
//! folder of passes, an export. Every command and editor opens projects here.

mod accept;
mod channels;
mod guess;
mod manifest;
mod opened;
mod passes;
mod single;

pub use channels::{GivenOrder, MediaFiles, NoMedia, channel_file};
pub use opened::{OpenedProject, SingleShader};
pub use passes::folder_passes;
pub use single::{open_file, read_siblings};

use crate::PassRole;
use crate::access::FileAccess;
use passes::{found_passes, left_out, loaded, open_found};
use shaderlint_text::path::slashed;
use std::path::PathBuf;

/// Opens files and folders whose names say which passes they are, and files with given passes.
///
/// # Errors
/// A message if they do not form a project.
pub fn open_passes(
    paths: &[PathBuf],
    named: &[(PassRole, PathBuf)],
    access: FileAccess,
) -> Result<OpenedProject, String> {
    let found = found_passes(paths, named, access)?;
    let mut draft = match (&found.files[..], paths) {
        // Alone, the Image may be for another host, which its text shows.
        ([(PassRole::Image, path)], [_]) if named.is_empty() => {
            let mut draft = open_file(&slashed(path), &loaded(path, access)?, None, access)?;
            draft.read.push(path.clone());
            draft.project.info.name = found.title;
            draft
        }
        _ => open_found(found, access)?,
    };
    let left: Vec<String> = paths
        .iter()
        .filter_map(|path| left_out(path, &draft.read, access))
        .collect();
    draft.project.notes.extend(left);
    match paths.first() {
        Some(first) => draft.placed(first, access),
        None => Ok(draft),
    }
}
