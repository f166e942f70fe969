//! ShaderToy: its player completes the text; [`compose`](super::super::compose) does the same.

use super::{HostCode, Sign};
use shaderlint_host::OWN;

pub(super) static CODE: HostCode = HostCode {
    host: "shadertoy",
    signs: |clues| match clues.guess.is_shadertoy() {
        true => vec![Sign::new("`mainImage`", OWN)],
        false => Vec::new(),
    },
    plan: None,
    declare: None,
};
