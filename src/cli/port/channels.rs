//! Inputs of channels given by the user: `--channel`, and `channels.toml` next to the shader.
//!
//! A key in the file is a channel of the Image, or a pass with a table of its channels. A value has
//! the form of the part of `--channel` after the `=`. Paths are relative to the file's folder and
//! must not leave it, since the user may not have written a downloaded file.

use super::read::read_text;
use super::siblings::folder_of;
use crate::project::{ChannelOrder, ChannelSource, PassRole};
use crate::text::LineIndex;
use crate::text::path::slashed;
use std::fs;
use std::path::{Path, PathBuf};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

const FILE: &str = "channels.toml";

/// A channel order, and its origin as a prefix for error messages.
pub(super) struct GivenOrder {
    pub(super) by: String,
    pub(super) order: ChannelOrder,
}

/// All orders for the channels of an input, followed by those of `--channel`. Later orders win.
pub(super) fn orders(input: Option<&Path>, channels: &[String]) -> Result<Vec<GivenOrder>, String> {
    let mut orders = match file_of(input) {
        Some(path) => of_file(&path)?,
        None => Vec::new(),
    };
    for text in channels {
        let by = "--channel".to_string();
        let order = ChannelOrder::read(text).map_err(|e| format!("{by}: {e}"))?;
        orders.push(GivenOrder { by, order });
    }
    Ok(orders)
}

/// The order file next to the input, if it can have one. For a file `ocean.glsl`, its own
/// `ocean.channels.toml` takes precedence; the other file of a folder of passes is only theirs.
pub(super) fn file_of(input: Option<&Path>) -> Option<PathBuf> {
    let first = input.filter(|p| p.as_os_str() != "-")?;
    if first.is_dir() {
        return Some(first.join(FILE));
    }
    let own = first.with_extension(FILE);
    let is_for_passes = || role(first).is_none() && holds_image(folder_of(first));
    Some(match own.exists() || is_for_passes() {
        true => own,
        false => first.with_file_name(FILE),
    })
}

/// The pass that a file is named after.
fn role(file: &Path) -> Option<PassRole> {
    PassRole::of_name(file.file_stem()?.to_str()?)
}

/// Whether a folder has an Image pass.
fn holds_image(folder: &Path) -> bool {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut names = entries.map(|entry| entry.path());
    names.any(|path| role(&path) == Some(PassRole::Image))
}

fn of_file(path: &Path) -> Result<Vec<GivenOrder>, String> {
    if !path.is_file() {
        return Ok(Vec::new());
    }
    let text = read_text(path)?;
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
        let read = ChannelOrder::read(&text).and_then(|order| placed(order, path));
        match read {
            Ok(order) => Ok(GivenOrder { by, order }),
            Err(e) => Err(format!("{by}: {e}")),
        }
    };
    found.into_iter().map(read).collect()
}

/// The order with the path of its file made relative to the current folder. `by` is the order file.
fn placed(mut order: ChannelOrder, by: &Path) -> Result<ChannelOrder, String> {
    let ChannelSource::File(file) = &order.source else {
        return Ok(order);
    };
    let path = by.with_file_name(file);
    // A missing file is reported when it is read.
    if let (Ok(path), Ok(folder)) = (path.canonicalize(), folder_of(by).canonicalize())
        && !path.starts_with(&folder)
    {
        return Err(format!(
            "`{file}` is outside of the folder; pass it with `--channel`"
        ));
    }
    order.source = ChannelSource::File(slashed(&path));
    Ok(order)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::project::ChannelName;

    /// The orders in a file, or the error without the file name.
    fn read(text: &str) -> Result<Vec<ChannelOrder>, String> {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join(FILE), text).unwrap();
        fs::write(folder.path().join("photo.jpg"), "").unwrap();
        let orders = orders(Some(folder.path()), &[])
            .map_err(|e| e.split_once(FILE).unwrap().1.to_string())?;
        Ok(orders.into_iter().map(|o| o.order).collect())
    }

    #[test]
    fn shaders_in_a_folder_of_passes_have_their_own_channel_files() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let file = |name: &str| file_of(Some(&path(name))).unwrap();
        assert_eq!(file("ocean.glsl"), path(FILE));
        fs::write(path("image.glsl"), "").unwrap();
        assert_eq!(file("ocean.glsl"), path("ocean.channels.toml"));
        assert_eq!(file("buffer_a.glsl"), path(FILE));
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
        let ChannelSource::File(path) = &all[0].source else {
            panic!("{:?}", all[0].source);
        };
        let path = Path::new(path);
        assert!(
            path.is_absolute() && path.ends_with("photo.jpg"),
            "{path:?}"
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
            "0 = '../../../../../../../../../../../etc/passwd'",
            ":1:1: `../../../../../../../../../../../etc/passwd` is outside of the folder",
        );
    }
}
