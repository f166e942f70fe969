//! ShaderToy: its player completes the text, and [`compose`](super::super::compose) does as it does.

use super::feed::OWN;
use super::{DialectFacts, Sign};

pub(super) static FACTS: DialectFacts = DialectFacts {
    name: "shadertoy",
    title: "ShaderToy",
    feeds: &[],
    textures: &[],
    varyings: &[],
    declares: false,
    signs: |clues| match clues.guess.is_shadertoy() {
        true => vec![Sign::new("`mainImage`", OWN)],
        false => Vec::new(),
    },
    plan: None,
};
