//! The request `run`: draws a frame, traces a pixel or compares two shaders, as `shaderlint run` does.

use super::project::{ShaderText, valid};
use super::result::RequestResult;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use serde::Deserialize;
use serde_json::{Value, json};
use shaderlint_commands::run::{
    Bitmap, FrameView, HeatMap, Loaded, ObservedRays, Shot, ShotSetting, Show, UniformText,
    compare, compared_moments, frame, rays, shot, trace,
};
use shaderlint_engine::inputs::{Button, Moment, Mouse};
use shaderlint_exec::Watch;

/// A shader, and what is drawn of it.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct RunRequest {
    #[serde(flatten)]
    shader: ShaderText,
    /// Width and height in pixels.
    size: Option<[u32; 2]>,
    /// Time in seconds.
    time: Option<f64>,
    /// Frame number.
    frame: Option<u32>,
    mouse: Option<RequestMouse>,
    /// The pass to show.
    pass: Option<String>,
    /// Values of uniforms by name.
    uniforms: Option<Value>,
    heatmap: Option<HeatMap>,
    show: Option<Show>,
    /// Whether loops, functions and invalid numbers are reported.
    #[serde(default)]
    report: bool,
    /// The pixel to trace, from the lower left corner.
    pixel: Option<[u32; 2]>,
    /// Another version of the shader.
    compare: Option<ShaderText>,
}

/// The mouse: its position in pixels from the lower left corner.
#[derive(Clone, Copy, Deserialize)]
struct RequestMouse {
    x: f64,
    y: f64,
    #[serde(default)]
    down: bool,
}

/// Default size in pixels.
const SIZE: [u32; 2] = [320, 180];
/// Maximum number of pixels, which are drawn on one thread.
const MAX_PIXELS: u64 = 1 << 22;

impl RunRequest {
    fn size(&self) -> Result<[u32; 2], String> {
        let size = self.size.unwrap_or(SIZE);
        let pixels: u64 = size.iter().map(|side| u64::from(*side)).product();
        match pixels {
            1..=MAX_PIXELS => Ok(size),
            _ => Err(format!(
                "an image has at least 1 and at most {MAX_PIXELS} pixels"
            )),
        }
    }

    fn mouse(&self) -> Option<Mouse> {
        self.mouse.map(|mouse| Mouse {
            at: [mouse.x, mouse.y],
            button: match mouse.down {
                true => Button::Down,
                false => Button::Up,
            },
        })
    }

    /// The frame, by its number, its time or both.
    fn moment(&self) -> Moment {
        Moment::given(self.time, self.frame, self.mouse())
    }

    /// The values of uniforms, as JSON.
    fn uniforms(&self) -> Option<String> {
        self.uniforms.as_ref().map(Value::to_string)
    }

    /// The settings of the draw.
    fn setting<'a>(
        &'a self,
        show: Option<&'a Show>,
        uniforms: Option<&'a str>,
    ) -> Result<ShotSetting<'a>, String> {
        Ok(ShotSetting {
            size: self.size()?,
            threads: 1,
            pass: self.pass.as_deref(),
            show,
            uniforms: uniforms.map(|text| UniformText {
                name: "uniforms",
                text,
            }),
            rays: match self.heatmap {
                Some(HeatMap::Slope) => ObservedRays::Camera,
                _ => ObservedRays::Nothing,
            },
            watch: match self.compare.is_some() {
                true => Watch::Nothing,
                false if self.report || self.pixel.is_some() => Watch::Numbers,
                false => Watch::Flow,
            },
            trace: self.pixel.is_some(),
            decode: None,
        })
    }

    /// A shader, ready to draw.
    fn prepared(&self, shader: &ShaderText, show: Option<&Show>) -> Result<(Loaded, Shot), String> {
        let loaded = valid(shader)?;
        let uniforms = self.uniforms();
        let setting = self.setting(show, uniforms.as_deref())?;
        let shot = shot(&loaded, &setting)?;
        Ok((loaded, shot))
    }
}

/// `run`: facts as the command line prints them, as JSON and as text, and the image.
pub fn run(request: &RunRequest) -> RequestResult {
    let (loaded, mut own) = request.prepared(&request.shader, request.show.as_ref())?;
    let moment = request.moment();
    let mut nobody = |_: u32| {};
    if let Some(pixel) = request.pixel {
        let facts = trace(&loaded, &mut own, &moment, pixel, &mut nobody)?;
        return answer(&facts, facts.text(), None);
    }
    if let Some(other) = &request.compare {
        let (other, mut other_shot) = request.prepared(other, None)?;
        let moments = match request.time.is_some() || request.frame.is_some() {
            true => vec![moment],
            false => compared_moments(request.size()?, request.mouse()),
        };
        let names = [&*loaded.name, &*other.name];
        let size = request.size()?;
        let (facts, image) = compare(
            [&mut own, &mut other_shot],
            names,
            size,
            &moments,
            &mut |_, _| {},
        )?;
        return answer(&facts, facts.text(), image.as_ref());
    }
    let view = FrameView {
        heat: request.heatmap,
        show: request.show.as_ref(),
        report: request.report,
    };
    let mut made = frame(&loaded, &mut own, &moment, view, &mut nobody)?;
    if request.report {
        let uniforms = request.uniforms();
        let setting = request.setting(None, uniforms.as_deref())?;
        made.facts.rays = rays(&loaded, &own, &setting, &moment);
    }
    answer(&made.facts, made.facts.text(), Some(&made.bitmap))
}

/// The answer: the image has three bytes per pixel in base64, top row first.
fn answer<F: serde::Serialize>(facts: &F, text: String, image: Option<&Bitmap>) -> RequestResult {
    let facts = serde_json::to_value(facts).map_err(|e| e.to_string())?;
    let image = image
        .map(|image| json!({ "size": image.size, "rgb": BASE64_STANDARD.encode(&image.bytes) }));
    Ok(json!({ "facts": facts, "text": text, "image": image }))
}
