//! Fragment shaders for the ShaderMaterial of three.js.
//!
//! Source: the preset `three` (`src/host/presets/three.glsl`), which is what three.js puts before them.
//! The varyings are those that people write in their vertex shaders, `vUv` and its kin: they hold what
//! a plane before the camera would give.

use super::complete::{Completion, completions_of, defaults};
use super::feed::{COMMON, Feed, OWN, USUAL, feed, varying};
use super::{Clues, DialectFacts, Plan, Sign};
use crate::host::preset;
use crate::syntax::Version;

const MATRIX: &[&str] = &["mat4", "mat3"];

pub(super) static FACTS: DialectFacts = DialectFacts {
    name: "three",
    title: "a ShaderMaterial of three.js",
    feeds: &[
        feed("cameraPosition", &["vec3"], Feed::Camera, OWN),
        feed("viewMatrix", &["mat4"], Feed::Identity, USUAL),
        feed("isOrthographic", &["bool"], Feed::Nothing, OWN),
        feed("modelMatrix", &["mat4"], Feed::Identity, USUAL),
        feed("modelViewMatrix", &["mat4"], Feed::Identity, USUAL),
        feed("projectionMatrix", &["mat4"], Feed::Identity, USUAL),
        feed("normalMatrix", MATRIX, Feed::Identity, USUAL),
        feed("uTime", &["float"], Feed::Time, USUAL),
        feed("uMouse", &["vec2"], Feed::PointerUnit, COMMON),
        feed("uResolution", &["vec2"], Feed::Resolution, COMMON),
    ],
    textures: &[],
    varyings: &[
        varying("vUv", "vec2", "port_place", USUAL),
        varying("vNormal", "vec3", "vec3(0.0, 0.0, 1.0)", USUAL),
        varying("vWorldNormal", "vec3", "vec3(0.0, 0.0, 1.0)", USUAL),
        varying("vPosition", "vec3", "vec3(port_pos, 0.0)", USUAL),
        varying("vWorldPosition", "vec3", "vec3(port_pos, 0.0)", USUAL),
        varying("vViewPosition", "vec3", "vec3(-port_pos, 1.0)", USUAL),
        varying(
            "vElevation",
            "float",
            "0.5 * sin(6.0 * port_place.x)",
            USUAL,
        ),
    ],
    declares: true,
    signs: |clues| match clues.has_include() {
        true => vec![Sign::new("`#include <...>`", OWN)],
        false => Vec::new(),
    },
    plan: Some(plan),
};

/// What chunks of three.js declare and texts use most.
const COMMON_CHUNK: &str = "#define PI 3.141592653589793\n#define PI2 6.283185307179586\n\
    #define saturate(a) clamp(a, 0.0, 1.0)\n";

fn plan(clues: &Clues) -> Plan {
    let host = preset("three").map_or(String::new(), |p| p.declarations(false));
    let output = match clues.declares_output() {
        true => "#define OWN_OUTPUT 1\n",
        false => "",
    };
    // Chunks are not at hand: what is told of them most often stands for them.
    let chunk = match clues.has_include() && !clues.declares("PI") {
        true => COMMON_CHUNK,
        false => "",
    };
    let before = format!("{}{output}{host}{chunk}", defaults(Version::Es300));
    let own = Completion::behind(before, clues.text);
    let own = match clues.has_include() {
        true => own.told("chunks of three.js are not put in"),
        false => own,
    };
    // A RawShaderMaterial declares all itself.
    let raw = completions_of(clues).into_iter();
    Plan::picture(std::iter::once(own).chain(raw).collect())
}
