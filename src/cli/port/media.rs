//! The files that go onto channels, and into the output.

use super::read::{plain_error, read_media, shown, size_words};
use crate::port::{
    ChannelOrder, InputKind, Media, OutputId, Project, kind_of_bytes, kind_of_name, why_not,
};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use std::path::{Path, PathBuf};

/// What is put into the output.
pub(super) struct Carried {
    /// Largest file, in bytes.
    limit: u64,
    /// How it can be larger, behind what is said of one that is.
    advice: &'static str,
    /// The files, with how many bytes each adds.
    files: Vec<(PathBuf, u64)>,
    /// What there is to say of them.
    notes: Vec<String>,
}

impl Carried {
    /// Nothing yet.
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

    /// What there is to say of the files.
    pub(super) fn remarks(&self) -> &[String] {
        &self.notes
    }

    /// What there is to say of the files, and how much they add.
    pub(super) fn notes(&self) -> Vec<String> {
        let mut notes = self.notes.clone();
        let total: u64 = self.files.iter().map(|(_, size)| size).sum();
        match &self.files[..] {
            [] => {}
            [(path, size)] => notes.push(format!("{} adds {}", shown(path), size_words(*size))),
            all => notes.push(format!("{} files add {}", all.len(), size_words(total))),
        }
        notes
    }

    /// Reads a file that goes onto a channel. The faces of a cube map lie in `NAME`, `NAME_1` to
    /// `NAME_5`; where only the first is there, it is all of them.
    pub(super) fn read(&mut self, path: &Path, is_cube: bool) -> Result<Media, String> {
        let (kind, first) = self.face(path)?;
        let mut urls = vec![first.clone()];
        if is_cube {
            let ending = path.extension().and_then(|e| e.to_str()).unwrap_or("");
            let stem = path.file_stem().unwrap_or_default().to_string_lossy();
            for face in 1..6 {
                let path = path.with_file_name(format!("{stem}_{face}.{ending}"));
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

    /// What a file is, and what it holds as a `data:` address.
    fn face(&mut self, path: &Path) -> Result<(InputKind, String), String> {
        let name = shown(path);
        let bytes = read_media(path, self.limit, self.advice)?;
        let (kind, media_type) =
            kind_of_bytes(&bytes).ok_or_else(|| format!("{name}: {}", why_not(&bytes)))?;
        if kind_of_name(&name).is_some_and(|told| told != media_type) {
            let note =
                format!("{name} holds {media_type} whatever its name says, and is taken as that");
            self.notes.push(note);
        }
        let url = format!("data:{media_type};base64,{}", BASE64_STANDARD.encode(bytes));
        self.files.push((path.to_path_buf(), url.len() as u64));
        Ok((kind, url))
    }

    /// Takes what the export's channels read from a copy of the site's files. Nothing outside the
    /// folder is read, whatever the export says.
    pub(super) fn find(&mut self, project: &mut Project, folder: &Path) -> Result<(), String> {
        let wrong = |e| format!("{}: {}", shown(folder), plain_error(&e));
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
                return Err(format!("`{}` leads out of {}", input.src, shown(folder)));
            }
            if !path.is_file() {
                continue;
            }
            let is_cube = input.kind == InputKind::Cubemap;
            let found = match self.read(&path, is_cube) {
                Ok(found) => found,
                Err(message) => {
                    self.notes.push(format!("{message}; it is left out"));
                    continue;
                }
            };
            if input.kind.takes(found.kind) {
                (input.name, input.urls) = (found.name, found.urls);
            } else {
                let (kind, wanted) = (found.kind.word(), input.kind.word());
                let name = shown(&path);
                self.notes.push(format!(
                    "{name}: this is a {kind} and no {wanted}; it is left out"
                ));
            }
        }
        Ok(())
    }
}

/// Whether an order is for a channel that reads a cube map.
pub(super) fn is_cube(project: &Project, order: &ChannelOrder) -> bool {
    let places = project.places_of(order).unwrap_or_default();
    let is_its = |(pass, channel): &(usize, u8)| {
        let inputs = project.passes.get(*pass).map_or(&[][..], |p| &p.inputs);
        let mut own = inputs.iter().filter(|i| i.channel == *channel);
        own.any(|i| i.kind == InputKind::Cubemap)
    };
    places.iter().any(is_its)
}
