//! `run`.

use super::super::answer::ToolAnswer;
use super::super::command::OwnProgram;
use super::super::input::ToolInput;
use super::tool::{Args, Tool, ToolWrites, one_of};
use crate::cli::command::CLEAN;
use crate::cli::run::Heat;
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Map, Value};
use std::fs;

/// Most pixels of a picture: a PNG of noise is then about 1.5 MB.
const MAX_PIXELS: u64 = 512 * 1024;
/// Size of a picture where nothing is said, in pixels.
const SIZE: (u32, u32) = (480, 270);

/// The arguments of `run`.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RunTool {
    /// A fragment shader, a pass of ShaderToy or an export (.json)
    path: Option<String>,
    /// The text of a shader, instead of `path`
    code: Option<String>,
    /// Width of the picture in pixels; 480 if missing
    width: Option<u32>,
    /// Height of the picture in pixels; 270 if missing
    height: Option<u32>,
    /// Seconds since the start
    time: Option<f64>,
    /// Number of the frame, from 0
    frame: Option<u32>,
    /// Where the mouse is, like `320,180` in pixels from the left and from below; `320,180,down` holds
    /// its button
    mouse: Option<String>,
    /// Values of uniforms by name: numbers, booleans, arrays of them, objects for structs
    uniforms: Option<Map<String, Value>>,
    /// What channels read, like `0=photo.jpg` or `buffer_a.0=buffer_a`
    #[serde(default)]
    channels: Vec<String>,
    /// What the code is written in, like `shadertoy`, `glsl-sandbox` or `isf`; the code tells mostly
    from: Option<String>,
    /// The pass to show, like `image` or `buffer_a`
    pass: Option<String>,
    /// Draw a variable as it is on a line, like `d@42`
    show: Option<String>,
    /// Draw the work of each pixel (steps, cost, overdraw), or where numbers are not finite (nan)
    #[schemars(schema_with = "one_of::<Heat>")]
    #[serde(default)]
    heatmap: Option<String>,
    /// Draw so many pictures on one sheet, from `time` on
    sheet: Option<u32>,
    /// Seconds between two pictures of a sheet; 1 if missing
    every: Option<f64>,
    /// Say of each loop how often it turned, what each function cost, and where numbers went wrong
    #[serde(default)]
    report: bool,
}

impl Tool for RunTool {
    const NAME: &str = "run";
    const TITLE: &str = "Draw a shader";
    const ABOUT: &str = "Draws a shader without a GPU, as WebGL2 would. Answers with the picture, \
        and with what was seen: colours, numbers that are not finite, cost, loops.";
    const WRITES: ToolWrites = ToolWrites::Nothing;

    async fn answer(self, program: &OwnProgram) -> Result<ToolAnswer, String> {
        let input = ToolInput::of(self.path.as_ref(), self.code.as_ref())?;
        let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
        let picture = folder.path().join("picture.png");
        let uniforms = folder.path().join("uniforms.json");
        let mut args = self.args()?;
        if let Some(values) = &self.uniforms {
            let text = serde_json::to_vec(values).map_err(|e| e.to_string())?;
            fs::write(&uniforms, text).map_err(|e| e.to_string())?;
            args.option("--uniforms", Some(uniforms.to_string_lossy()));
        }
        args.option("--output", Some(picture.to_string_lossy()));
        args.0.extend(input.args());
        let done = program.run(args.0, input.text()).await?;
        if done.code != i32::from(CLEAN) {
            return Err(done.said());
        }
        // Where the picture was written is nothing to the client.
        let lines = done.out.lines();
        let facts: Vec<&str> = lines
            .filter(|l| !l.trim_start().starts_with("written "))
            .collect();
        let png = fs::read(&picture).map_err(|e| format!("there is no picture: {e}"))?;
        let mut answer = ToolAnswer::of(&facts.join("\n"), "the picture");
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
                "the picture would have {pixels} pixels, {MAX_PIXELS} are allowed"
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
        args.option("--sheet", self.sheet.map(|n| n.to_string()));
        args.option("--every", self.every.map(|t| t.to_string()));
        args.switch("--report", self.report);
        Ok(args)
    }
}
