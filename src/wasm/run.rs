//! The request `run`: draws a frame, traces a pixel or compares two shaders, as `shaderlint run` does.

use super::project::{ShaderText, valid};
use super::result::RequestResult;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use serde::Deserialize;
use serde_json::json;
use shaderlint_commands::run::{RunFront, RunRequest, answer};

/// A shader, and what is drawn of it.
#[derive(Deserialize)]
pub struct RunParams {
    #[serde(flatten)]
    shader: ShaderText,
    #[serde(flatten)]
    request: RunRequest,
    /// Another version of the shader.
    compare: Option<ShaderText>,
}

/// What every run in the module has: images are drawn on one thread.
const FRONT: RunFront<'static> = RunFront {
    size: [320, 180],
    max_pixels: 1 << 22,
    threads: 1,
    decode: None,
    uniforms: None,
};

/// `run`: facts as the command line prints them, as JSON and as text, and the image: three bytes per pixel
/// in base64, top row first.
pub fn run(params: &RunParams) -> RequestResult {
    let loaded = valid(&params.shader)?;
    let other = params.compare.as_ref().map(valid).transpose()?;
    let both = (&loaded, other.as_ref());
    let made = answer(&params.request, both, &FRONT, &mut |_| {})?;
    let image = made.image.as_ref();
    let image = image
        .map(|image| json!({ "size": image.size, "rgb": BASE64_STANDARD.encode(&image.bytes) }));
    Ok(json!({ "facts": made.facts, "text": made.facts.text(), "image": image }))
}
