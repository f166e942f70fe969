//! The tool `run`.

use super::super::answer::ToolAnswer;
use super::super::command::OwnProgram;
use super::super::input::ToolInput;
use super::tool::{Tool, ToolWrites, asked, in_parameters};
use crate::cli::command::CLEAN;
use crate::commands::run::{InputRequest, RunRequest};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::fs;

/// Maximum number of pixels; a PNG of noise then has about 1.5 MB.
const MAX_PIXELS: u64 = 512 * 1024;
/// Default size in pixels.
const SIZE: [u32; 2] = [480, 270];

/// The arguments of `run`.
#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RunTool {
    /// Fragment shader, ShaderToy pass or ShaderToy export (.json)
    path: Option<String>,
    /// Text of a shader, instead of `path`
    code: Option<String>,
    #[serde(flatten)]
    input: InputRequest,
    #[serde(flatten)]
    request: RunRequest,
}

impl Tool for RunTool {
    const NAME: &str = "run";
    const TITLE: &str = "Draw a shader";
    const ABOUT: &str = "Draws a shader without a GPU, as WebGL2 would. Returns the image and \
        statistics: colours, values that are not finite, cost, loops.";
    const WRITES: ToolWrites = ToolWrites::Nothing;

    async fn answer(mut self, program: &OwnProgram) -> Result<ToolAnswer, String> {
        let input = ToolInput::of(self.path.as_ref(), self.code.as_ref())?;
        let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
        let image = folder.path().join("picture.png");
        self.request.size = Some(self.request.size(SIZE, MAX_PIXELS)?);
        let mut args = asked(&self, "run", folder.path())?;
        if self.request.pixel.is_none() {
            args.option("--output", Some(image.to_string_lossy()));
        }
        args.0.extend(input.args());
        let mut done = program.run(args.0, input.text()).await?;
        done.err = in_parameters::<RunTool>(&done.err);
        if done.code != i32::from(CLEAN) {
            return Err(done.message());
        }
        if self.request.pixel.is_some() {
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
