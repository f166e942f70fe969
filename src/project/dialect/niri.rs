//! niri: animations of windows.
//!
//! The preset has the names. The compositor calls the function that a shader defines; here, `main`
//! calls it for a window in the middle of the image, in front of a plain background.

use super::complete::{completions_after, declarations};
use super::{Clues, HostCode, Plan};
use shaderlint_host::{Preset, preset};

pub(super) static CODE: HostCode = HostCode {
    host: "niri",
    signs: |_| Vec::new(),
    plan: Some(plan),
    declare: None,
};

fn plan(clues: &Clues) -> Plan {
    let Some(host) = preset("niri") else {
        return Plan::default();
    };
    let all = completions_after(clues, &declarations(host, clues, false), false);
    let entry = entry(host, clues);
    let ended = all
        .into_iter()
        .map(|c| {
            let color = match c.before.starts_with("#version 300") {
                true => "port_Color",
                false => "gl_FragColor",
            };
            let end = main(entry, color);
            c.with_end(&end)
        })
        .collect();
    Plan::image(ended)
}

/// The function that the shader defines.
fn entry<'h>(host: &'h Preset, clues: &Clues) -> &'h str {
    let mut all = host.entries.iter().map(String::as_str);
    let first = all.clone().next().unwrap_or("");
    all.find(|name| clues.declares(name)).unwrap_or(first)
}

/// The `main` that draws a window of two thirds of the image.
fn main(entry: &str, color: &str) -> String {
    let declared = match color {
        "gl_FragColor" => String::new(),
        color => format!("out vec4 {color};\n"),
    };
    format!(
        "\n{declared}void main() {{\n    \
         vec2 port_at = gl_FragCoord.xy / niri_size - 0.5;\n    \
         vec3 port_geo = vec3(1.5 * vec2(port_at.x, -port_at.y) + 0.5, 1.0);\n    \
         vec4 port_window = {entry}(port_geo, vec3(niri_geo_size, 1.0)) * niri_alpha;\n    \
         vec3 port_behind = vec3(0.16, 0.18, 0.24);\n    \
         {color} = vec4(port_window.rgb + (1.0 - port_window.a) * port_behind, 1.0);\n}}\n"
    )
}
