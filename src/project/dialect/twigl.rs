//! twigl: very short shaders, in modes that each allow a shader to omit more.
//!
//! The preset describes the modes. Noise and rotations are defined in `twigl.glsl`, with the names
//! and parameters of the website.

use super::complete::{Completion, completions_of, defaults};
use super::{Clues, HostCode, Plan, Sign, VersionAsked};
use shaderlint_host::{OWN, preset};
use shaderlint_syntax::Version;

pub(super) static CODE: HostCode = HostCode {
    host: "twigl",
    signs,
    plan: Some(plan),
    declare: None,
};

/// The uniforms that the website declares, with their types.
fn uniforms() -> impl Iterator<Item = (&'static str, &'static str)> + Clone {
    let rows = preset("twigl").map_or(&[][..], |p| &p.meanings.feeds);
    let own = rows.iter().filter(|row| row.is_declared);
    own.filter_map(|row| Some((row.name.as_str(), row.types.first()?.as_str())))
}

const HELPERS: &str = include_str!("twigl.glsl");

fn signs(clues: &Clues) -> Vec<Sign> {
    let mut found = Vec::new();
    let declared = uniforms().filter(|(n, ty)| clues.has_uniform(n, &[ty]));
    let free = uniforms().filter(|(n, _)| clues.is_free(n));
    let (declared, free): (Vec<_>, Vec<_>) = (declared.collect(), free.collect());
    let is_drawn = ["gl_FragColor", "o", "o0"]
        .iter()
        .any(|n| clues.has_word(n));
    if let [(first, _), (second, _), ..] = declared[..] {
        found.push(Sign::new(format!("`{first}` and `{second}`"), OWN));
    }
    if clues.is_free("FC") && is_drawn {
        found.push(Sign::new("`FC`", OWN));
    }
    found.extend(classic_signs(clues));
    let has_resolution = clues.is_free("r") && free.len() > 1;
    if has_resolution && is_drawn && !clues.guess.is_shadertoy() {
        found.push(Sign::new("`r` undeclared", OWN));
    }
    found
}

/// What distinguishes `classic` from GLSL Sandbox, which has the same names: the loudness of a sound
/// shader, several targets, and GLSL ES 3.00 without `#version`.
fn classic_signs(clues: &Clues) -> Option<Sign> {
    let has = |name: &str, ty: &str| clues.has_uniform(name, &[ty]);
    if !has("resolution", "vec2") || !has("time", "float") {
        return None;
    }
    let is_new = clues.asked == VersionAsked::Nothing && clues.declares_output();
    let what = match () {
        () if has("sound", "float") => "`sound`",
        () if has("backbuffer0", "sampler2D") || has("backbuffer1", "sampler2D") => "`backbuffer0`",
        () if is_new && has("mouse", "vec2") => "an output without `#version`",
        () => return None,
    };
    Some(Sign::new(what, 8 * OWN))
}

fn plan(clues: &Clues) -> Plan {
    // `o` is the output of a GLSL ES 3.00 shader, unless an older shader declares it as a variable.
    let outputs = ["o", "o0", "o1"].into_iter().filter(|n| clues.is_free(n));
    let outputs: Vec<&str> = outputs.collect();
    let is_old = clues.has_word("gl_FragColor");
    let is_declared = uniforms().any(|(n, ty)| clues.has_uniform(n, &[ty]));
    if is_declared || clues.has_uniform("resolution", &["vec2"]) {
        return Plan::image(completions_of(clues));
    }
    let mut host = String::from("#define FC gl_FragCoord\n");
    for (name, ty) in uniforms() {
        host.push_str(&format!("uniform {ty} {name};\n"));
    }
    for name in ["b", "b0", "b1"].into_iter().filter(|n| clues.is_free(n)) {
        host.push_str(&format!("uniform sampler2D {name};\n"));
    }
    let helpers = match HELPER_NAMES.split(' ').any(|n| clues.is_free(n)) {
        true => HELPERS,
        false => "",
    };
    let mut outs = String::new();
    for (place, name) in outputs.iter().enumerate() {
        outs.push_str(&format!("layout(location = {place}) out vec4 {name};\n"));
    }
    if is_old {
        outs.push_str("out vec4 port_FragColor;\n#define gl_FragColor port_FragColor\n");
    }
    let lookups = match clues.has_word("texture2D") {
        true => "#define texture2D texture\n",
        false => "",
    };
    let new = format!("{}{outs}{lookups}{host}{helpers}", defaults(Version::Es300));
    let old = format!("{}{host}{helpers}", defaults(Version::Es100));
    let around = |before: String| {
        let after = Completion::after(before, clues.text);
        match clues.is_body {
            true => after.in_main().with_end("\n}\n"),
            false => after,
        }
    };
    let candidates = match is_old {
        true => vec![around(old), around(new)],
        false => vec![around(new), around(old)],
    };
    Plan::image(candidates)
}

/// The helper functions that only `geekest` has.
const HELPER_NAMES: &str = "\
    snoise2D snoise3D snoise4D fsnoise fsnoiseDigits hsv rotate2D rotate3D PI PI2 mod289 permute \
    taylorInvSqrt F4";
