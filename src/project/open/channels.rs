//! Inputs of channels given by the user: `--channel`, and `channels.toml` next to the shader.
//!
//! A key in the file is a channel of the Image, or a pass with a table of its channels. A value has
//! the form of the part of `--channel` after the `=`. Paths are relative to the file's folder and
//! must not leave it, since the user may not have written a downloaded file.

use crate::files::manifest::CHANNELS;
use crate::files::pass_name::role;
use crate::files::{FileType, Files};
use crate::{ChannelOrder, ChannelSource, InputKind, Media, PassRole, Project, unknown_source};
use shaderlint_text::path::slashed;
use std::path::{Path, PathBuf};

/// A channel order, and its origin as a prefix for error messages.
#[derive(Clone, Debug)]
pub struct GivenOrder {
    /// Where it was given.
    pub by: String,
    /// The order.
    pub order: ChannelOrder,
}

/// Reads the media files of channels.
pub trait MediaFiles {
    /// The file at a path; the six faces of a cube map, if it is for one.
    ///
    /// # Errors
    /// A message if it cannot be read, or is no media file.
    fn media(&mut self, path: &Path, is_cube: bool) -> Result<Media, String>;
}

/// For fronts without media files.
pub struct NoMedia;

impl MediaFiles for NoMedia {
    fn media(&mut self, path: &Path, _: bool) -> Result<Media, String> {
        Err(unknown_source(&slashed(path)))
    }
}

impl Project {
    /// Applies orders, and connects the buffers that nothing was said about. Its channels must have
    /// been resolved.
    ///
    /// # Errors
    /// If an order cannot be carried out.
    pub fn put_all(
        &mut self,
        orders: &[GivenOrder],
        media: &mut dyn MediaFiles,
    ) -> Result<(), String> {
        for GivenOrder { by, order } in orders {
            let found = match &order.source {
                ChannelSource::File(path) => {
                    Some(media.media(Path::new(path), self.is_cube(order)))
                }
                _ => None,
            };
            let put = found.transpose().and_then(|media| self.put(order, media));
            put.map_err(|e| format!("{by}: {e}"))?;
        }
        self.guess_buffers();
        Ok(())
    }

    /// Whether an order is for a channel that reads a cube map.
    fn is_cube(&self, order: &ChannelOrder) -> bool {
        let places = self.places_of(order).unwrap_or_default();
        let is_its = |(pass, channel): &(usize, u8)| {
            let inputs = self.passes.get(*pass).map_or(&[][..], |p| &p.inputs);
            let mut own = inputs.iter().filter(|i| i.channel == *channel);
            own.any(|i| i.kind == InputKind::Cubemap)
        };
        places.iter().any(is_its)
    }
}

/// The file of orders for a shader file or a folder of passes. For a file `ocean.glsl`, its own
/// `ocean.channels.toml` takes precedence; the other file of a folder of passes is only theirs.
pub fn channel_file(place: &Path, files: &dyn Files) -> PathBuf {
    if files.entry(place) == Some(FileType::Folder) {
        return place.join(CHANNELS);
    }
    let (own, shared) = (
        place.with_extension(CHANNELS),
        place.with_file_name(CHANNELS),
    );
    let exists = |path: &Path| files.entry(path).is_some();
    let name = place.file_name().unwrap_or_default().to_string_lossy();
    let has_image = || {
        let mut names = files
            .names(place.parent().unwrap_or(Path::new("")))
            .into_iter();
        names.any(|name| matches!(role(&name), Some((PassRole::Image, _))))
    };
    let is_shared = || role(&name).is_some() || exists(&shared) && !has_image();
    match !exists(&own) && is_shared() {
        true => shared,
        false => own,
    }
}

/// The orders in a file; none if it does not exist.
///
/// # Errors
/// A message with the place of what is wrong in it.
#[cfg(feature = "cli")]
pub(super) fn orders_of(path: &Path, files: &dyn Files) -> Result<Vec<GivenOrder>, String> {
    use shaderlint_text::LineIndex;
    use toml::Spanned;
    use toml::de::{DeTable, DeValue};
    if files.entry(path) != Some(FileType::File) {
        return Ok(Vec::new());
    }
    let text = files
        .load(path)
        .map_err(|e| format!("{}: {e}", slashed(path)))?;
    let at = |start: usize| {
        let position = LineIndex::new(&text).position(&text, start as u32);
        format!("{}:{}:{}", slashed(path), position.line, position.column)
    };
    let table = DeTable::parse(&text).map_err(|e| {
        let message = e.message().lines().collect::<Vec<_>>().join("; ");
        format!("{}: {message}", at(e.span().unwrap_or_default().start))
    })?;
    let mut found: Vec<(usize, String)> = Vec::new();
    let wrong = |value: &Spanned<DeValue>, requested| {
        Err(format!("{}: expected {requested}", at(value.span().start)))
    };
    for (key, value) in table.get_ref() {
        match value.get_ref() {
            DeValue::String(source) => {
                found.push((key.span().start, format!("{}={source}", key.get_ref())));
            }
            DeValue::Table(channels) => {
                for (channel, source) in channels {
                    let DeValue::String(source) = source.get_ref() else {
                        return wrong(source, "a string");
                    };
                    let text = format!("{}.{}={source}", key.get_ref(), channel.get_ref());
                    found.push((channel.span().start, text));
                }
            }
            _ => return wrong(value, "a string or a table of channels"),
        }
    }
    // The parser returns keys in alphabetical order.
    found.sort_by_key(|(start, _)| *start);
    let read = |(start, text): (usize, String)| {
        let by = at(start);
        let read = ChannelOrder::read(&text).and_then(|order| placed(order, path, files));
        match read {
            Ok(order) => Ok(GivenOrder { by, order }),
            Err(e) => Err(format!("{by}: {e}")),
        }
    };
    found.into_iter().map(read).collect()
}

/// The module for pages has no reader of TOML.
#[cfg(not(feature = "cli"))]
#[expect(clippy::unnecessary_wraps, reason = "as with the reader")]
pub(super) fn orders_of(_: &Path, _: &dyn Files) -> Result<Vec<GivenOrder>, String> {
    Ok(Vec::new())
}

/// The order with the path of its file made relative to the current folder. `by` is the order file.
pub(super) fn placed(
    mut order: ChannelOrder,
    by: &Path,
    files: &dyn Files,
) -> Result<ChannelOrder, String> {
    let ChannelSource::File(file) = &order.source else {
        return Ok(order);
    };
    let path = by.with_file_name(file);
    let folder = by.parent().unwrap_or(Path::new(""));
    // A missing file is reported when it is read.
    if let (Some(path), Some(folder)) = (files.real(&path), files.real(folder))
        && !path.starts_with(&folder)
    {
        return Err(format!(
            "`{file}` is outside of the folder; pass it with `--channel`"
        ));
    }
    order.source = ChannelSource::File(slashed(&path));
    Ok(order)
}

#[cfg(feature = "cli")]
#[cfg(test)]
mod tests {
    use super::*;
    use crate::ChannelName;
    use std::collections::BTreeMap;
    use std::sync::Arc;

    fn files(texts: &[(&str, &str)]) -> BTreeMap<PathBuf, Arc<str>> {
        let texts = texts.iter();
        texts
            .map(|(path, text)| (PathBuf::from(path), Arc::from(*text)))
            .collect()
    }

    /// The orders in a file, or the error without the file name.
    fn read(text: &str) -> Result<Vec<ChannelOrder>, String> {
        let files = files(&[
            ("/d/channels.toml", text),
            ("/d/photo.jpg", ""),
            ("/secret.jpg", ""),
        ]);
        let orders = orders_of(Path::new("/d/channels.toml"), &files)
            .map_err(|e| e.split_once(CHANNELS).unwrap().1.to_string())?;
        Ok(orders.into_iter().map(|o| o.order).collect())
    }

    #[test]
    fn shaders_in_a_folder_of_passes_have_their_own_channel_files() {
        let file = |name: &str, all: &dyn Files| channel_file(&Path::new("/d").join(name), all);
        let own = PathBuf::from("/d/ocean.channels.toml");
        assert_eq!(file("ocean.glsl", &files(&[("/d/ocean.glsl", "")])), own);
        let shared = files(&[("/d/ocean.glsl", ""), ("/d/channels.toml", "")]);
        assert_eq!(file("ocean.glsl", &shared), Path::new("/d/channels.toml"));
        let passes = files(&[("/d/ocean.glsl", ""), ("/d/image.glsl", "")]);
        assert_eq!(file("ocean.glsl", &passes), own);
        let of_passes = file("buffer_a.glsl", &passes);
        assert_eq!(of_passes, Path::new("/d/channels.toml"));
    }

    #[test]
    fn channels_are_parsed_with_their_pass() {
        let all = read(
            "2 = 'photo.jpg,nearest' # of the Image\n[buffer_a]\n0 = 'buffer_a'\n\
             [image]\n1 = 'keyboard'\n",
        );
        let all = all.unwrap();
        let places: Vec<_> = all.iter().map(|o| (o.pass, o.channel.clone())).collect();
        let (image, buffer) = (Some(PassRole::Image), Some(PassRole::Buffer(0)));
        let requested = [(None, 2), (buffer, 0), (image, 1)];
        assert_eq!(places, requested.map(|(p, n)| (p, ChannelName::Number(n))));
        assert_eq!(all[0].filter, Some("nearest"));
        assert_eq!(
            all[0].source,
            ChannelSource::File("/d/photo.jpg".to_string())
        );
    }

    #[test]
    fn errors_in_a_channel_file_have_a_position() {
        let wrong = |text: &str, message: &str| {
            let found = read(text).unwrap_err();
            assert!(found.contains(message), "{found}");
        };
        wrong("\n99 = 'keyboard'", ":2:1: expected a channel from 0 to 3");
        wrong("[foo]\n0 = 'keyboard'", ":2:1: unknown pass `foo`");
        wrong("0 = 3", ":1:5: expected a string");
        wrong("0 = ", ":1:5: ");
        wrong(
            "0 = '../secret.jpg'",
            ":1:1: `../secret.jpg` is outside of the folder",
        );
    }
}
