//! `check`.

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
    /// A file or folder: GLSL, exports of ShaderToy, pages and scripts with shaders in them
    path: Option<String>,
    /// The text of a shader, instead of `path`
    code: Option<String>,
    /// File name of `code`; its ending tells what it is, like `a.frag`, `b.vert`, `page.html`
    name: Option<String>,
    /// What the shader is written for, where that cannot be seen
    #[schemars(schema_with = "one_of::<DialectChoice>")]
    #[serde(default)]
    dialect: Option<String>,
    /// Report these rules, groups and compile errors alone
    #[serde(default)]
    only: Vec<String>,
}

impl Tool for CheckTool {
    const NAME: &str = "check";
    const TITLE: &str = "Check shaders";
    const ABOUT: &str = "Checks GLSL for WebGL2 and ShaderToy. One line a finding: place, \
        severity, rule, message, and the edit that mends it. An error means that the browser \
        refuses the shader.";
    const WRITES: ToolWrites = ToolWrites::Nothing;

    async fn answer(self, program: &OwnProgram) -> Result<ToolAnswer, String> {
        let input = ToolInput::of(self.path.as_ref(), self.code.as_ref())?;
        let mut args = Args::of(&["--format=agent"]);
        args.option("--stdin-filename", self.name);
        args.option("--dialect", self.dialect);
        args.options("--only", &self.only);
        args.0.extend(input.args());
        let done = program.run(args.0, input.text()).await?;
        if done.code == i32::from(FAILED) && done.out.is_empty() {
            return Err(done.err);
        }
        Ok(ToolAnswer::of_outcome(&done, "nothing is wrong"))
    }
}
