//! twigl: shaders as short as a message, in modes of which each leaves more away.
//!
//! Source: `src/fragmen.js` of doxas/twigl. `classic` is like GLSL Sandbox; `geek` calls the uniforms
//! `r`, `m`, `t`, `f`, `s` and `b`; `geeker` has them declared; `geekest` has `FC` for `gl_FragCoord`,
//! noise and turns (`twigl.glsl`, with the names and parameters of the site's own), and may leave
//! `main` away. Those of GLSL ES 3.00 write to `o`, those with several targets to `o0` and `o1`, of which
//! the first is shown; `b0` and `b1` are the targets a frame ago. The frame counts from 1; the mouse is
//! in the corner at first.

use super::complete::{Completion, completions_of, defaults};
use super::feed::{COMMON, Feed, OWN, TextureFeed, feed, texture};
use super::{Clues, DialectFacts, Plan, Sign};
use shaderlint_syntax::Version;

pub(super) static FACTS: DialectFacts = DialectFacts {
    name: "twigl",
    title: "twigl",
    feeds: &[
        feed("r", &["vec2"], Feed::Resolution, COMMON),
        feed("m", &["vec2"], Feed::PointerUnitZero, COMMON),
        feed("t", &["float"], Feed::Time, COMMON),
        feed("f", &["float"], Feed::FrameFromOne, COMMON),
        feed("s", &["float"], Feed::Volume, COMMON),
        feed("frame", &["float"], Feed::FrameFromOne, COMMON),
        feed("sound", &["float"], Feed::Volume, COMMON),
        feed("mouse", &["vec2"], Feed::PointerUnitZero, COMMON),
    ],
    textures: &[
        texture("b", TextureFeed::LastFrame, "linear", "clamp", COMMON),
        texture("b#", TextureFeed::LastFrame, "linear", "clamp", COMMON),
        texture(
            "backbuffer",
            TextureFeed::LastFrame,
            "linear",
            "clamp",
            COMMON,
        ),
        texture(
            "backbuffer#",
            TextureFeed::LastFrame,
            "linear",
            "clamp",
            COMMON,
        ),
    ],
    varyings: &[],
    declares: true,
    signs,
    plan: Some(plan),
};

/// What the site declares.
const UNIFORMS: [(&str, &str); 5] = [
    ("r", "vec2"),
    ("m", "vec2"),
    ("t", "float"),
    ("f", "float"),
    ("s", "float"),
];

const HELPERS: &str = include_str!("twigl.glsl");

fn signs(clues: &Clues) -> Vec<Sign> {
    let mut found = Vec::new();
    let declared = UNIFORMS
        .iter()
        .filter(|(n, ty)| clues.has_uniform(n, &[*ty]));
    let free = UNIFORMS.iter().filter(|(n, _)| clues.is_free(n));
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
    let has_resolution = clues.is_free("r") && free.len() > 1;
    if has_resolution && is_drawn && !clues.guess.is_shadertoy() {
        found.push(Sign::new("`r` undeclared", OWN));
    }
    found
}

fn plan(clues: &Clues) -> Plan {
    // `o` is what a shader of GLSL ES 3.00 writes to, unless it is a variable of an older one.
    let outputs = ["o", "o0", "o1"].into_iter().filter(|n| clues.is_free(n));
    let outputs: Vec<&str> = outputs.collect();
    let is_old = clues.has_word("gl_FragColor");
    let is_declared = UNIFORMS.iter().any(|(n, ty)| clues.has_uniform(n, &[*ty]));
    if is_declared || clues.has_uniform("resolution", &["vec2"]) {
        return Plan::picture(completions_of(clues));
    }
    let mut host = String::from("#define FC gl_FragCoord\n");
    for (name, ty) in UNIFORMS {
        host.push_str(&format!("uniform {ty} {name};\n"));
    }
    for name in ["b", "b0", "b1"].into_iter().filter(|n| clues.is_free(n)) {
        host.push_str(&format!("uniform sampler2D {name};\n"));
    }
    let helpers = match HELPER_NAMES.iter().any(|n| clues.is_free(n)) {
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
        let behind = Completion::behind(before, clues.text);
        match clues.is_body {
            true => behind.in_main().with_end("\n}\n"),
            false => behind,
        }
    };
    let candidates = match is_old {
        true => vec![around(old), around(new)],
        false => vec![around(new), around(old)],
    };
    Plan::picture(candidates)
}

/// The helpers that only `geekest` has.
const HELPER_NAMES: [&str; 14] = [
    "snoise2D",
    "snoise3D",
    "snoise4D",
    "fsnoise",
    "fsnoiseDigits",
    "hsv",
    "rotate2D",
    "rotate3D",
    "PI",
    "PI2",
    "mod289",
    "permute",
    "taylorInvSqrt",
    "F4",
];
