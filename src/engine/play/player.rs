//! What the uniforms of ShaderToy's player are given.

use super::moment::Moment;
use shaderlint_exec::{Code, Draw};
use shaderlint_port::Feed;

/// What the uniforms of ShaderToy's player are given.
const PLAYER: [(&str, Feed); 8] = [
    ("iResolution", Feed::Resolution),
    ("iTime", Feed::Time),
    ("iTimeDelta", Feed::Delta),
    ("iFrameRate", Feed::FrameRate),
    ("iFrame", Feed::Frame),
    ("iMouse", Feed::Mouse),
    ("iDate", Feed::Date),
    ("iSampleRate", Feed::SampleRate),
];

/// A draw of a pass that the player completes, all set but what its channels read.
pub fn player_draw<'c>(code: &'c Code, size: [u32; 2], moment: &Moment) -> Draw<'c> {
    let mut draw = Draw::new(code, size);
    for (name, feed) in PLAYER {
        let mut lanes = moment.lanes(feed, size);
        if feed == Feed::Resolution {
            lanes.truncate(3);
        }
        draw.set(name, &lanes);
    }
    draw
}

/// Whether the player gives a uniform of this name the same whatever the project is like.
pub fn player_gives(name: &str) -> bool {
    PLAYER.iter().any(|(given, _)| *given == name)
}
