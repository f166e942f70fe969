//! The uniforms of ShaderToy's player.

use super::moment::Moment;
use shaderlint_exec::{Bytecode, Draw};
use shaderlint_host::{Feed, shadertoy};

/// The uniforms that the player sets in every project, by name.
fn given() -> impl Iterator<Item = (&'static str, Feed)> {
    let rows = shadertoy().map_or(&[][..], |p| &p.meanings.feeds);
    let is_given = |feed| !matches!(feed, Feed::ChannelTime | Feed::ChannelResolution);
    let own = rows.iter().filter(|row| row.is_declared);
    own.map(|row| (row.name.as_str(), row.feed))
        .filter(move |(_, feed)| is_given(*feed))
}

/// A draw of a pass that the player completes, with everything set except its channels.
pub fn player_draw<'c>(code: &'c Bytecode, size: [u32; 2], moment: &Moment) -> Draw<'c> {
    let mut draw = Draw::new(code, size);
    for (name, feed) in given() {
        let mut lanes = moment.lanes(feed, size);
        if feed == Feed::Resolution {
            lanes.truncate(3);
        }
        draw.set(name, &lanes);
    }
    draw
}

/// Whether the player sets a uniform of this name in every project.
pub fn player_gives(name: &str) -> bool {
    given().any(|(given, _)| given == name)
}
