//! ShaderToy: its player completes the text; [`compose`](super::super::compose) does the same.

use super::complete::{best, completions_of, declarations, modern};
use super::{Clues, Completion, HostCode, Sign};
use shaderlint_host::{OWN, shadertoy};
use shaderlint_semantic::{GuessedKind, Pass};

/// The completed text of an Image or buffer that brings a frame of its own: a `main`, or uniforms
/// that ShaderToy's player does not set, which is completed with the declarations of the player,
/// `common`, and a `main`. `None` for a text that the player runs.
pub fn framed(text: &str, common: &str) -> Option<Completion> {
    let host = shadertoy()?;
    let has_main = text.contains("main(") || text.contains("main (");
    if !has_main && !text.contains("uniform") {
        return None;
    }
    let clues = Clues::of(text);
    if clues.guess.has_main {
        return best(completions_of(&clues));
    }
    let player = Pass::Image.host();
    let is_own = clues
        .uniforms
        .iter()
        .any(|uniform| !player.sets(&uniform.name, &uniform.ty));
    if !is_own || !matches!(clues.guess.kind, Some(GuessedKind::ShaderToy(Pass::Image))) {
        return None;
    }
    let before = modern(&clues) + &declarations(host, &clues, false) + common;
    Some(Completion::after(before, text).calling_image())
}

pub(super) static CODE: HostCode = HostCode {
    host: "shadertoy",
    signs: |clues| match clues.guess.is_shadertoy() {
        true => vec![Sign::new("`mainImage`", OWN)],
        false => Vec::new(),
    },
    plan: None,
    declare: None,
};
