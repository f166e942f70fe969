//! What the user puts onto channels: `--channel`, and `channels.toml` beside the code.
//!
//! In the file a key is a channel of the Image, or a pass with a table of its channels; a value is
//! what stands behind the `=` of `--channel`. Paths start at the file's folder and stay in it, since
//! whoever ports a stranger's shader did not write them.

use super::beside::folder_of;
use super::read::{read_text, shown};
use crate::port::{ChannelOrder, ChannelSource};
use crate::text::LineIndex;
use std::path::{Path, PathBuf};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The name of the file.
const FILE: &str = "channels.toml";

/// An order, and who gave it, as messages begin.
pub(super) struct GivenOrder {
    pub(super) by: String,
    pub(super) order: ChannelOrder,
}

/// All orders for the channels of an input, those of `--channel` included; the later ones win.
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

/// The file beside the code, where there may be one: for a file `ocean.glsl` its own
/// `ocean.channels.toml` comes first.
pub(super) fn file_of(input: Option<&Path>) -> Option<PathBuf> {
    let first = input.filter(|p| p.as_os_str() != "-")?;
    if first.is_dir() {
        return Some(first.join(FILE));
    }
    let own = first.with_extension(FILE);
    Some(match own.exists() {
        true => own,
        false => first.with_file_name(FILE),
    })
}

fn of_file(path: &Path) -> Result<Vec<GivenOrder>, String> {
    if !path.is_file() {
        return Ok(Vec::new());
    }
    let text = read_text(path)?;
    let at = |start: usize| {
        let position = LineIndex::new(&text).position(&text, start as u32);
        format!("{}:{}:{}", shown(path), position.line, position.column)
    };
    let table = DeTable::parse(&text).map_err(|e| {
        let message = e.message().lines().collect::<Vec<_>>().join("; ");
        format!("{}: {message}", at(e.span().unwrap_or_default().start))
    })?;
    let mut found: Vec<(usize, String)> = Vec::new();
    let wrong = |value: &Spanned<DeValue>, wanted| {
        Err(format!("{}: this must be {wanted}", at(value.span().start)))
    };
    for (key, value) in table.get_ref() {
        match value.get_ref() {
            DeValue::String(source) => {
                found.push((key.span().start, format!("{}={source}", key.get_ref())));
            }
            DeValue::Table(channels) => {
                for (channel, source) in channels {
                    let DeValue::String(source) = source.get_ref() else {
                        return wrong(source, "a text in quotes");
                    };
                    let text = format!("{}.{}={source}", key.get_ref(), channel.get_ref());
                    found.push((channel.span().start, text));
                }
            }
            _ => return wrong(value, "a text in quotes, or a table of channels"),
        }
    }
    // Keys were sorted by their letters.
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

/// The order with its file's path as it is from here; `by` is the file that gives it.
fn placed(mut order: ChannelOrder, by: &Path) -> Result<ChannelOrder, String> {
    let ChannelSource::File(file) = &order.source else {
        return Ok(order);
    };
    let path = by.with_file_name(file);
    // What does not exist is told of where it is read.
    if let (Ok(path), Ok(folder)) = (path.canonicalize(), folder_of(by).canonicalize())
        && !path.starts_with(&folder)
    {
        return Err(format!(
            "`{file}` leads out of the folder; give it with `--channel`"
        ));
    }
    order.source = ChannelSource::File(shown(&path));
    Ok(order)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::port::{ChannelName, PassRole};
    use std::fs;

    /// The orders that a file gives, or what is wrong with it, behind the file's name.
    fn read(text: &str) -> Result<Vec<ChannelOrder>, String> {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join(FILE), text).unwrap();
        fs::write(folder.path().join("photo.jpg"), "").unwrap();
        let orders = orders(Some(folder.path()), &[])
            .map_err(|e| e.split_once(FILE).unwrap().1.to_string())?;
        Ok(orders.into_iter().map(|o| o.order).collect())
    }

    #[test]
    fn channels_are_read_from_the_file_beside_the_code() {
        let all = read(
            "2 = 'photo.jpg,nearest' # of the Image\n[buffer_a]\n0 = 'buffer_a'\n\
             [image]\n1 = 'keyboard'\n",
        );
        let all = all.unwrap();
        let places: Vec<_> = all.iter().map(|o| (o.pass, o.channel.clone())).collect();
        let (image, buffer) = (Some(PassRole::Image), Some(PassRole::Buffer(0)));
        let wanted = [(None, 2), (buffer, 0), (image, 1)];
        assert_eq!(places, wanted.map(|(p, n)| (p, ChannelName::Number(n))));
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
    fn mistakes_in_the_file_have_a_place() {
        let wrong = |text: &str, message: &str| {
            let found = read(text).unwrap_err();
            assert!(found.contains(message), "{found}");
        };
        wrong(
            "\n99 = 'keyboard'",
            ":2:1: a channel is a number from 0 to 3",
        );
        wrong("[foo]\n0 = 'keyboard'", ":2:1: `foo` is no pass");
        wrong("0 = 3", ":1:5: this must be a text in quotes");
        wrong("0 = ", ":1:5: ");
        wrong(
            "0 = '../../../../../../../../../../../etc/passwd'",
            ":1:1: `../../../../../../../../../../../etc/passwd` leads out of the folder",
        );
    }
}
