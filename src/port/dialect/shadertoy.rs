//! ShaderToy: its player completes the text, and [`compose`](super::super::compose) does as it does.

use super::{HostCode, Sign};
use shaderlint_host::OWN;

pub(super) static CODE: HostCode = HostCode {
    host: "shadertoy",
    signs: |clues| match clues.guess.is_shadertoy() {
        true => vec![Sign::new("`mainImage`", OWN)],
        false => Vec::new(),
    },
    plan: None,
};
