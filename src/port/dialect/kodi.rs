//! Kodi's add-on visualization.shadertoy: ShaderToy code as it was in its first years.
//!
//! Source: the preset `kodi` (`src/host/presets/kodi.glsl`). Its texts look like ShaderToy's, so only
//! `--host` tells them.

use super::complete::completions_behind;
use super::{Clues, Completion, HostCode, Plan};
use shaderlint_host::preset;

pub(super) static CODE: HostCode = HostCode {
    host: "kodi",
    signs: |_| Vec::new(),
    plan: Some(plan),
};

fn plan(clues: &Clues) -> Plan {
    let host = preset("kodi").map_or(String::new(), |p| p.declarations(false));
    // The extension is there in GLSL ES 3.00, and not to be had in 1.00 on a WebGL2 page.
    let host: String = host
        .lines()
        .filter(|line| !line.starts_with("#extension"))
        .map(|line| format!("{line}\n"))
        .collect();
    let names = match clues.has_word("iTime") {
        true => "#define iTime iGlobalTime\n",
        false => "",
    };
    let all = completions_behind(clues, &format!("{host}{names}"), false);
    let ended = all.into_iter().map(Completion::calling_image);
    Plan::picture(ended.collect())
}
