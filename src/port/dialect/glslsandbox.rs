//! GLSL Sandbox (glslsandbox.com, once glsl.heroku.com).
//!
//! Source: `static/index.html` of mrdoob/glsl-sandbox. The text is compiled as it stands, as GLSL ES
//! 1.00 with derivatives. The mouse goes from 0 to 1 from below and is in the middle at first;
//! `surfacePosition` is the place on a surface that is one high, with the middle at (0, 0);
//! `backbuffer` is the last frame, of bytes, nearest and clamped.

use super::complete::completions_of;
use super::feed::{Feed, OWN, TextureFeed, USUAL, feed, texture, varying};
use super::{Clues, DialectFacts, Plan};

pub(super) static FACTS: DialectFacts = DialectFacts {
    name: "glsl-sandbox",
    title: "GLSL Sandbox",
    feeds: &[
        feed("time", &["float"], Feed::Time, USUAL),
        feed("mouse", &["vec2"], Feed::PointerUnit, USUAL),
        feed("resolution", &["vec2"], Feed::Resolution, USUAL),
        feed("surfaceSize", &["vec2"], Feed::SurfaceSize, OWN),
    ],
    textures: &[
        texture(
            "backbuffer",
            TextureFeed::LastFrame,
            "nearest",
            "clamp",
            USUAL,
        ),
        texture("bb", TextureFeed::LastFrame, "nearest", "clamp", USUAL),
    ],
    varyings: &[varying(
        "surfacePosition",
        "vec2",
        "0.5 * port_pos * vec2(port_size.x / port_size.y, 1.0)",
        OWN,
    )],
    declares: false,
    signs: |_| Vec::new(),
    plan: Some(plan),
};

fn plan(clues: &Clues) -> Plan {
    Plan::picture(completions_of(clues))
}
