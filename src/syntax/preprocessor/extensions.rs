//! The extensions of GLSL ES in WebGL.

use crate::names::Version;

/// Extensions that are predefined in a WebGL2 context, measured in Chromium.
pub(super) const KNOWN_EXTENSIONS: [&str; 2] = [
    "GL_OES_EGL_image_external",
    "GL_OES_EGL_image_external_essl3",
];

/// Extensions of WebGL1 that became part of GLSL ES 3.00.
pub(super) const CORE_EXTENSIONS: [&str; 4] = [
    "GL_OES_standard_derivatives",
    "GL_EXT_shader_texture_lod",
    "GL_EXT_frag_depth",
    "GL_EXT_draw_buffers",
];

/// The extensions that a shader of a version can enable.
pub fn extensions(version: Version) -> impl Iterator<Item = &'static str> {
    let [both, only_300] = KNOWN_EXTENSIONS;
    let (own, core): (_, &[&str]) = match version {
        Version::Es100 => (both, &CORE_EXTENSIONS),
        Version::Es300 => (only_300, &[]),
    };
    core.iter().copied().chain([own])
}

/// What an `#extension` directive may ask for.
pub const EXTENSION_BEHAVIORS: [&str; 4] = ["enable", "require", "warn", "disable"];
