//! The Book of Shaders: GlslCanvas and its kin (glslViewer, the extension glsl-canvas of VS Code).
//!
//! Source: glslCanvas, `src/GlslCanvas.js`; the pages on uniforms and defines of glslViewer's wiki.
//! The text is compiled as it stands, and once more for each `BUFFER_0` that it asks after, with that
//! defined; what that draws is `u_buffer0`. The mouse is in pixels from below.

use super::complete::{Completion, completions_of};
use super::feed::{COMMON, Feed, OWN, TextureFeed, USUAL, feed, texture, varying};
use super::{Clues, DialectFacts, Plan, PlannedPass, Sign};
use crate::OutputId;
use shaderlint_semantic::Pass;
use std::sync::Arc;

pub(super) static FACTS: DialectFacts = DialectFacts {
    name: "book-of-shaders",
    title: "The Book of Shaders",
    feeds: &[
        feed("u_time", &["float"], Feed::Time, USUAL),
        feed("u_resolution", &["vec2"], Feed::Resolution, USUAL),
        feed("u_mouse", &["vec2"], Feed::Pointer, USUAL),
        feed("u_delta", &["float"], Feed::Delta, USUAL),
        feed("u_date", &["vec4"], Feed::Date, USUAL),
        feed("u_frame", &["int", "float"], Feed::Frame, USUAL),
        feed("u_camera", &["vec3"], Feed::Camera, USUAL),
        feed("u_tex#Resolution", &["vec2"], Feed::TextureSize, USUAL),
        feed("u_trails", &["vec2[10]"], Feed::Nothing, USUAL),
    ],
    textures: &[
        texture("u_tex#", TextureFeed::File, "linear", "repeat", USUAL),
        texture("u_texture_#", TextureFeed::File, "linear", "repeat", USUAL),
        texture("u_buffer#", TextureFeed::Buffer, "linear", "clamp", USUAL),
        texture(
            "u_doubleBuffer#",
            TextureFeed::Buffer,
            "linear",
            "clamp",
            OWN,
        ),
    ],
    varyings: &[
        varying("v_texcoord", "vec2", "port_place", COMMON),
        varying("v_position", "vec4", "vec4(port_pos, 0.0, 1.0)", COMMON),
    ],
    declares: false,
    signs: |clues| match buffers(clues).is_empty() {
        true => Vec::new(),
        false => vec![Sign::new("`BUFFER_0`", USUAL)],
    },
    plan: Some(plan),
};

/// The macros for which the text is compiled once more, with the samplers that read what it draws.
fn buffers(clues: &Clues) -> Vec<(String, String)> {
    let all = (0..8).flat_map(|n| {
        [
            (format!("BUFFER_{n}"), format!("u_buffer{n}")),
            (format!("DOUBLE_BUFFER_{n}"), format!("u_doubleBuffer{n}")),
        ]
    });
    all.filter(|(name, _)| clues.has_word(name)).collect()
}

fn plan(clues: &Clues) -> Plan {
    let picture = Plan::picture(completions_of(clues));
    let buffers = buffers(clues);
    if buffers.is_empty() {
        return picture;
    }
    // The branches of a buffer may need what the picture does not: all are judged alike.
    let candidates = || completions_of(clues).into_iter();
    let passes = buffers.into_iter().map(|(name, sampler)| PlannedPass {
        kind: Pass::Buffer,
        name: sampler.clone(),
        output: OutputId::of_dialect(&sampler),
        candidates: candidates()
            .filter_map(|c| defining(&c, clues, &name))
            .collect(),
        inputs: Vec::new(),
    });
    let mut all: Vec<PlannedPass> = passes.collect();
    all.extend(picture.passes);
    Plan {
        passes: all,
        ..Plan::default()
    }
}

/// A candidate with a macro before it.
fn defining(candidate: &Completion, clues: &Clues, name: &str) -> Option<Completion> {
    let define = format!("#define {name}\n");
    match candidate.before.is_empty() {
        // What stands as it is has no place for it, but for GLSL ES 1.00 without a version.
        true => {
            let first = clues.text.trim_start().starts_with("#version");
            (!first).then(|| Completion {
                before: Arc::from(define),
                ..candidate.clone()
            })
        }
        false => Some(Completion {
            before: Arc::from(format!("{}{define}", candidate.before)),
            ..candidate.clone()
        }),
    }
}
