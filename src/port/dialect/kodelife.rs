//! KodeLife, a live coding tool.
//!
//! Source: its templates, as projects of its users hold them. Desktop texts are `#version 150` and take
//! the block `VertexData` from the vertex shader; `spectrum` tells how loud low, middle and high sounds
//! are; `prevFrame` is the last picture.

use super::complete::completions_of;
use super::feed::{COMMON, Feed, OWN, TextureFeed, USUAL, feed, texture, varying};
use super::{Clues, DialectFacts, Plan, Sign};

pub(super) static FACTS: DialectFacts = DialectFacts {
    name: "kodelife",
    title: "KodeLife",
    feeds: &[
        feed("time", &["float"], Feed::Time, COMMON),
        feed("resolution", &["vec2"], Feed::Resolution, COMMON),
        feed("mouse", &["vec2"], Feed::PointerUnit, COMMON),
        feed("spectrum", &["vec3"], Feed::Spectrum, OWN),
    ],
    textures: &[
        texture("texture#", TextureFeed::File, "linear", "repeat", USUAL),
        texture("prevFrame", TextureFeed::LastFrame, "linear", "clamp", OWN),
        texture("prevPass", TextureFeed::File, "linear", "clamp", USUAL),
    ],
    varyings: &[
        varying("v_position", "vec4", "vec4(port_pos, 0.0, 1.0)", USUAL),
        varying("v_normal", "vec3", "vec3(0.0, 0.0, 1.0)", USUAL),
        varying("v_texcoord", "vec2", "port_place", USUAL),
    ],
    declares: false,
    signs: |clues| match clues.has_word("VertexData") && clues.has_word("inData") {
        true => vec![Sign::new("`inData`", OWN)],
        false => Vec::new(),
    },
    plan: Some(plan),
};

fn plan(clues: &Clues) -> Plan {
    Plan::picture(completions_of(clues))
}
