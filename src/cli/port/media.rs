//! Media files for channels, embedded in the output.

use super::read::{plain_error, read_media, size_words};
use crate::project::{
    InputKind, Media, MediaFiles, OutputId, Project, kind_of_bytes, kind_of_name, unknown_source,
    why_not,
};
use crate::text::path::slashed;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use std::path::{Path, PathBuf};

/// The embedded media files.
pub(super) struct Carried {
    /// Largest file, in bytes.
    limit: u64,
    /// Appended to the error for a file that is too large: how to raise the limit.
    advice: &'static str,
    /// The files, with the number of bytes that each adds to the output.
    files: Vec<(PathBuf, u64)>,
    /// Notes about the files.
    notes: Vec<String>,
}

impl Carried {
    /// An empty set of files.
    pub(super) fn new(limit: u64, advice: &'static str) -> Carried {
        Carried {
            limit,
            advice,
            files: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// The files that were read.
    pub(super) fn paths(&self) -> impl Iterator<Item = &PathBuf> {
        self.files.iter().map(|(path, _)| path)
    }

    /// Notes about the files.
    pub(super) fn remarks(&self) -> &[String] {
        &self.notes
    }

    /// Notes about the files, and their total size.
    pub(super) fn notes(&self) -> Vec<String> {
        let mut notes = self.notes.clone();
        let total: u64 = self.files.iter().map(|(_, size)| size).sum();
        match &self.files[..] {
            [] => {}
            [(path, size)] => notes.push(format!(
                "embedded {} ({})",
                slashed(path),
                size_words(*size)
            )),
            all => notes.push(format!(
                "embedded {} files ({})",
                all.len(),
                size_words(total)
            )),
        }
        notes
    }

    /// Reads a file for a channel. The faces of a cube map are `NAME`, `NAME_1` to `NAME_5`; a
    /// missing face is replaced by the first.
    fn read(&mut self, path: &Path, is_cube: bool) -> Result<Media, String> {
        let (kind, first) = self.face(path)?;
        let mut urls = vec![first.clone()];
        if is_cube {
            let extension = path.extension().and_then(|e| e.to_str()).unwrap_or("");
            let stem = path.file_stem().unwrap_or_default().to_string_lossy();
            for face in 1..6 {
                let path = path.with_file_name(format!("{stem}_{face}.{extension}"));
                urls.push(match path.is_file() {
                    true => self.face(&path)?.1,
                    false => first.clone(),
                });
            }
        }
        let name = path.file_name().unwrap_or_default();
        Ok(Media {
            name: name.to_string_lossy().into_owned(),
            kind,
            urls,
        })
    }

    /// The kind of a file, and its content as a `data:` URL.
    fn face(&mut self, path: &Path) -> Result<(InputKind, String), String> {
        let name = slashed(path);
        let bytes = read_media(path, self.limit, self.advice)?;
        let (kind, media_type) =
            kind_of_bytes(&bytes).ok_or_else(|| format!("{name}: {}", why_not(&bytes)))?;
        if kind_of_name(&name).is_some_and(|by_name| by_name != media_type) {
            let note = format!("{name} contains {media_type}, despite its extension");
            self.notes.push(note);
        }
        let url = format!("data:{media_type};base64,{}", BASE64_STANDARD.encode(bytes));
        self.files.push((path.to_path_buf(), url.len() as u64));
        Ok((kind, url))
    }

    /// Finds the media files of an export in a copy of ShaderToy's files. Files outside of the
    /// folder are rejected.
    pub(super) fn find(&mut self, project: &mut Project, folder: &Path) -> Result<(), String> {
        let wrong = |e| format!("{}: {}", slashed(folder), plain_error(&e));
        let root = folder.canonicalize().map_err(wrong)?;
        for input in project.passes.iter_mut().flat_map(|p| &mut p.inputs) {
            let is_drawn = input.kind == InputKind::Buffer || input.id == OutputId::CUBE;
            if !input.urls.is_empty() || input.src.is_empty() || is_drawn {
                continue;
            }
            let inside = input.src.trim_start_matches('/');
            let last = inside.rsplit('/').next().unwrap_or(inside);
            let candidates = [root.join(inside), root.join(last)];
            let Some(path) = candidates.iter().find_map(|p| p.canonicalize().ok()) else {
                continue;
            };
            if !path.starts_with(&root) {
                return Err(format!("`{}` is outside of {}", input.src, slashed(folder)));
            }
            if !path.is_file() {
                continue;
            }
            let is_cube = input.kind == InputKind::Cubemap;
            let found = match self.read(&path, is_cube) {
                Ok(found) => found,
                Err(message) => {
                    self.notes.push(format!("{message}; skipped"));
                    continue;
                }
            };
            if input.kind.takes(found.kind) {
                (input.name, input.urls) = (found.name, found.urls);
            } else {
                let (kind, expected) = (found.kind.word(), input.kind.word());
                let name = slashed(&path);
                self.notes.push(format!(
                    "{name}: expected {expected}, found {kind}; skipped"
                ));
            }
        }
        Ok(())
    }
}

impl MediaFiles for Carried {
    fn media(&mut self, path: &Path, is_cube: bool) -> Result<Media, String> {
        match path.exists() {
            true => self.read(path, is_cube),
            false => Err(unknown_source(&slashed(path))),
        }
    }
}

/// The folder of a file.
pub(super) fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}
