//! Bonzomatic, the live coding tool of demo parties.
//!
//! Source: the default shader of Gargaj/Bonzomatic and its README. Texts are `#version 410 core` and
//! declare all that they use; the spectra are textures of one dimension, which WebGL has not: they are
//! lines of textures of two. `texFFTIntegrated` grows with what is heard, here and there at other rates.

use super::complete::{completions_behind, has_images};
use super::feed::{COMMON, Feed, OWN, TextureFeed, USUAL, feed, texture};
use super::{Clues, DialectFacts, Plan};

pub(super) static FACTS: DialectFacts = DialectFacts {
    name: "bonzomatic",
    title: "Bonzomatic",
    feeds: &[
        feed("fGlobalTime", &["float"], Feed::Time, OWN),
        feed("v2Resolution", &["vec2"], Feed::Resolution, OWN),
        feed("fFrameTime", &["float"], Feed::Delta, OWN),
        feed("iFrameIndex", &["int", "float"], Feed::Frame, USUAL),
    ],
    textures: &[
        texture("texFFT", TextureFeed::Music, "linear", "clamp", OWN),
        texture("texFFTSmoothed", TextureFeed::Music, "linear", "clamp", OWN),
        texture(
            "texFFTIntegrated",
            TextureFeed::MusicSum,
            "linear",
            "clamp",
            OWN,
        ),
        texture(
            "texPreviousFrame",
            TextureFeed::LastFrame,
            "linear",
            "clamp",
            OWN,
        ),
        texture("texChecker", TextureFeed::File, "mipmap", "repeat", USUAL),
        texture("texNoise", TextureFeed::File, "mipmap", "repeat", USUAL),
        texture("texRevision", TextureFeed::File, "mipmap", "repeat", USUAL),
        texture("texTex#", TextureFeed::File, "mipmap", "repeat", COMMON),
    ],
    varyings: &[],
    declares: false,
    signs: |_| Vec::new(),
    plan: Some(plan),
};

fn plan(clues: &Clues) -> Plan {
    let mut plan = Plan::picture(completions_behind(clues, "", true));
    if has_images(clues) {
        let note = "WebGL has no images that shaders write to: what is read of them is 0";
        plan.notes.push(note.to_string());
    }
    plan
}
