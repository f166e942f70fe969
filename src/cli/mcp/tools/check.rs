//! The tool `check`.

use super::super::answer::ToolAnswer;
use super::super::command::OwnProgram;
use super::super::input::ToolInput;
use super::tool::{Args, Tool, ToolWrites, one_of};
use crate::cli::command::FAILED;
use crate::engine::DialectChoice;
use schemars::JsonSchema;
use serde::Deserialize;

/// The arguments of `check`.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CheckTool {
    /// File or folder to check: GLSL, ShaderToy exports, web pages and scripts that contain shaders
    path: Option<String>,
    /// Text of a shader, instead of `path`
    code: Option<String>,
    /// File name of `code`; its extension selects the kind of file: `a.frag`, `b.vert`, `page.html`
    name: Option<String>,
    /// Dialect of the shader, if it cannot be detected
    #[schemars(schema_with = "one_of::<DialectChoice>")]
    #[serde(default)]
    dialect: Option<String>,
    /// Report only these rules, groups and compile errors
    #[serde(default)]
    only: Vec<String>,
    /// Also report infos; by default they are only counted
    #[serde(default)]
    info: bool,
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
        let mut args = Args::of(&["--format=tool"]);
        args.option("--stdin-filename", self.name);
        args.option("--dialect", self.dialect);
        args.options("--only", &self.only);
        if self.info {
            args.0.push("--info".into());
        }
        args.0.extend(input.args());
        let done = program.run(args.0, input.text()).await?;
        if done.code == i32::from(FAILED) && done.out.is_empty() {
            return Err(done.err);
        }
        Ok(ToolAnswer::of_outcome(&done, "no findings"))
    }
}
