//! Kodi's add-on visualization.shadertoy: early ShaderToy code.
//!
//! Source: the preset `kodi` (`src/host/presets/desktop/kodi.glsl`). Its texts look like
//! ShaderToy's, so only `--host` selects it.

use super::complete::completions_after;
use super::{Clues, Completion, HostCode, Plan};
use shaderlint_host::preset;

pub(super) static CODE: HostCode = HostCode {
    host: "kodi",
    signs: |_| Vec::new(),
    plan: Some(plan),
    declare: None,
};

fn plan(clues: &Clues) -> Plan {
    let host = preset("kodi").map_or(String::new(), |p| p.declarations(false));
    // The extension is part of GLSL ES 3.00, and not available for 1.00 in WebGL2.
    let host: String = host
        .lines()
        .filter(|line| !line.starts_with("#extension"))
        .map(|line| format!("{line}\n"))
        .collect();
    let names = match clues.has_word("iTime") {
        true => "#define iTime iGlobalTime\n",
        false => "",
    };
    let all = completions_after(clues, &format!("{host}{names}"), false);
    let ended = all.into_iter().map(Completion::calling_image);
    Plan::image(ended.collect())
}
