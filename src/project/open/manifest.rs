//! What files of other tools beside passes say about channels, as orders.

use super::channels::{GivenOrder, placed};
use crate::files::Files;
use crate::files::manifest::Manifest;
use crate::{ChannelName, ChannelOrder, ChannelSource, PassRole};
use shaderlint_text::path::slashed;
use std::path::{Path, PathBuf};

/// What the files of other tools order.
#[derive(Default)]
pub(super) struct ManifestOrders {
    /// What channels read.
    pub orders: Vec<GivenOrder>,
    /// What was read, or was not.
    pub notes: Vec<String>,
    /// The files that were read.
    pub read: Vec<PathBuf>,
}

/// The orders of the first file of another tool in a folder that is understood.
pub(super) fn manifest_orders(folder: &Path, files: &dyn Files) -> ManifestOrders {
    let mut names = files.names(folder);
    names.sort();
    let mut found = ManifestOrders::default();
    for manifest in Manifest::among(&names, folder, files) {
        let name = manifest.path.file_name().unwrap_or_default();
        let name = name.to_string_lossy().into_owned();
        let orders = manifest.channels.iter();
        let orders = orders.filter_map(|channel| order(channel, &manifest.path, files));
        let orders: Vec<(ChannelOrder, String)> = orders.collect();
        if !orders.is_empty() && found.read.is_empty() {
            let shown: Vec<&str> = orders.iter().map(|(_, shown)| &**shown).collect();
            let note = format!("{} (from {name})", shown.join(", "));
            found.notes.push(note);
            let orders = orders.into_iter().map(|(order, _)| GivenOrder {
                by: slashed(&manifest.path),
                order,
            });
            found.orders = orders.collect();
            found.read.push(manifest.path);
        } else if manifest.names_passes {
            let note = format!("{name} names passes, but was not understood");
            found.notes.push(note);
        }
    }
    found
}

/// What a channel reads as an order, and how it is shown.
fn order(
    (pass, number, source): &(PassRole, u8, ChannelSource),
    path: &Path,
    files: &dyn Files,
) -> Option<(ChannelOrder, String)> {
    let shown = match source {
        ChannelSource::Pass(role) => role.name(),
        ChannelSource::File(file) => file,
        _ => return None,
    };
    let shown = format!("{}.{number} = {shown}", pass.name());
    let order = ChannelOrder {
        pass: Some(*pass),
        channel: ChannelName::Number(*number),
        source: source.clone(),
        filter: None,
        wrap: None,
        vflip: None,
    };
    Some((placed(order, path, files).ok()?, shown))
}
