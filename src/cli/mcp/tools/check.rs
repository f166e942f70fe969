//! The tool `check`.

use super::super::answer::ToolAnswer;
use super::super::command::OwnProgram;
use super::super::input::ToolInput;
use super::tool::{Tool, ToolWrites, asked, ran};
use crate::commands::CheckRequest;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The arguments of `check`.
#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CheckTool {
    /// File or folder to check: GLSL, ShaderToy exports, web pages and scripts that contain shaders
    path: Option<String>,
    /// Text of a shader, instead of `path`
    code: Option<String>,
    /// File name of `code`; its extension selects the kind of file: `a.frag`, `b.vert`, `page.html`
    name: Option<String>,
    #[serde(flatten)]
    request: CheckRequest,
}

impl Tool for CheckTool {
    const NAME: &str = "check";
    const TITLE: &str = "Check shaders";
    const ABOUT: &str = "Checks GLSL shaders for WebGL2 and ShaderToy. Prints one line per \
        finding: position, severity, rule, message and fix. An error means that the browser rejects \
        the shader.";
    const WRITES: ToolWrites = ToolWrites::Nothing;

    async fn answer(self, program: &OwnProgram) -> Result<ToolAnswer, String> {
        let input = ToolInput::of(self.path.as_ref(), self.code.as_ref())?;
        let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
        let mut args = asked(&self, "check", folder.path())?;
        args.option("--format", Some("tool"));
        args.option("--stdin-filename", self.name.as_ref());
        let done = ran(program, args, &input).await?;
        Ok(ToolAnswer::of_outcome(&done, "no findings"))
    }
}
