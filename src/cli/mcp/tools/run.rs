//! The tool `run`.

use super::super::answer::ToolAnswer;
use super::super::command::OwnProgram;
use super::super::input::ToolInput;
use super::tool::{Args, Tool, ToolWrites, in_parameters, one_of};
use crate::cli::command::CLEAN;
use crate::cli::run::Heat;
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Map, Value};
use std::fs;

/// Maximum number of pixels; a PNG of noise then has about 1.5 MB.
const MAX_PIXELS: u64 = 512 * 1024;
/// Default size in pixels.
const SIZE: (u32, u32) = (480, 270);

/// The options of the command that messages name, with their parameters.
const PARAMETERS: [(&str, &str); 11] = [
    ("--channel", "channels"),
    ("--from", "from"),
    ("--host", "from"),
    ("--pass", "pass"),
    ("--uniforms", "uniforms"),
    ("--time", "time"),
    ("--frame", "frame"),
    ("--mouse", "mouse"),
    ("--show", "show"),
    ("--heatmap", "heatmap"),
    ("--report", "report"),
];

/// The arguments of `run`.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RunTool {
    /// Fragment shader, ShaderToy pass or ShaderToy export (.json)
    path: Option<String>,
    /// Text of a shader, instead of `path`
    code: Option<String>,
    /// Width of the image in pixels; default: 480
    width: Option<u32>,
    /// Height of the image in pixels; default: 270
    height: Option<u32>,
    /// Time in seconds since the start
    time: Option<f64>,
    /// Frame number, from 0
    frame: Option<u32>,
    /// Mouse position in pixels from the lower left corner, such as `320,180`; `320,180,down` holds
    /// the button
    mouse: Option<String>,
    /// Values of uniforms by name: numbers, booleans, arrays of these, objects for structs
    uniforms: Option<Map<String, Value>>,
    /// Inputs of channels, such as `0=photo.jpg` or `buffer_a.0=buffer_a`
    #[serde(default)]
    channels: Vec<String>,
    /// Site or library that the shader is written for, such as `shadertoy`, `glsl-sandbox` or
    /// `isf`; usually detected
    from: Option<String>,
    /// Pass to show, such as `image` or `buffer_a`
    pass: Option<String>,
    /// Draw the value of a variable on a line, such as `d@42`
    show: Option<String>,
    /// Draw a heat map: loop iterations (steps), operations (cost), work of the pixel group that a
    /// pixel only waits for (divergence), values that are not finite (nan), or the slope of the distance
    /// along marching rays (slope)
    #[schemars(schema_with = "one_of::<Heat>")]
    #[serde(default)]
    heatmap: Option<String>,
    /// Trace a pixel instead, such as `320,180` from the lower left corner: the values of its
    /// variables, its loops and its invalid numbers
    pixel: Option<String>,
    /// Draw a contact sheet of this many frames, starting at `time`
    sheet: Option<u32>,
    /// Seconds between the frames of a contact sheet; default: 1
    every: Option<f64>,
    /// Report loop iterations, the cost of each function and invalid numbers
    #[serde(default)]
    report: bool,
}

impl Tool for RunTool {
    const NAME: &str = "run";
    const TITLE: &str = "Draw a shader";
    const ABOUT: &str = "Draws a shader without a GPU, as WebGL2 would. Returns the image and \
        statistics: colours, values that are not finite, cost, loops.";
    const WRITES: ToolWrites = ToolWrites::Nothing;

    async fn answer(self, program: &OwnProgram) -> Result<ToolAnswer, String> {
        let input = ToolInput::of(self.path.as_ref(), self.code.as_ref())?;
        let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
        let image = folder.path().join("picture.png");
        let uniforms = folder.path().join("uniforms.json");
        let mut args = self.args()?;
        if let Some(values) = &self.uniforms {
            let text = serde_json::to_vec(values).map_err(|e| e.to_string())?;
            fs::write(&uniforms, text).map_err(|e| e.to_string())?;
            args.option("--uniforms", Some(uniforms.to_string_lossy()));
        }
        if self.pixel.is_none() {
            args.option("--output", Some(image.to_string_lossy()));
        }
        args.0.extend(input.args());
        let mut done = program.run(args.0, input.text()).await?;
        done.err = in_parameters(&done.err, &PARAMETERS);
        if done.code != i32::from(CLEAN) {
            return Err(done.message());
        }
        if self.pixel.is_some() {
            let mut answer = ToolAnswer::of(&done.out, "the pixel");
            answer.push_any(&done.err);
            return Ok(answer);
        }
        // The temporary path of the image means nothing to the client.
        let lines = done.out.lines();
        let facts: Vec<&str> = lines
            .filter(|l| !l.trim_start().starts_with("written "))
            .collect();
        let png = fs::read(&image).map_err(|e| format!("cannot read the image: {e}"))?;
        let mut answer = ToolAnswer::of(&facts.join("\n"), "the image");
        answer.push_png(&png);
        answer.push_any(&done.err);
        Ok(answer)
    }
}

impl RunTool {
    fn args(&self) -> Result<Args, String> {
        let (width, height) = (self.width.unwrap_or(SIZE.0), self.height.unwrap_or(SIZE.1));
        let pixels = u64::from(width) * u64::from(height) * u64::from(self.sheet.unwrap_or(1));
        if pixels > MAX_PIXELS {
            return Err(format!(
                "the image would have {pixels} pixels; the limit is {MAX_PIXELS}"
            ));
        }
        let mut args = Args::of(&["run"]);
        args.option("--size", Some(format!("{width}x{height}")));
        args.option("--time", self.time.map(|t| t.to_string()));
        args.option("--frame", self.frame.map(|n| n.to_string()));
        args.option("--mouse", self.mouse.as_ref());
        args.options("--channel", &self.channels);
        args.option("--from", self.from.as_ref());
        args.option("--pass", self.pass.as_ref());
        args.option("--show", self.show.as_ref());
        args.option("--heatmap", self.heatmap.as_ref());
        args.option("--pixel", self.pixel.as_ref());
        args.option("--sheet", self.sheet.map(|n| n.to_string()));
        args.option("--every", self.every.map(|t| t.to_string()));
        args.switch("--report", self.report);
        Ok(args)
    }
}
