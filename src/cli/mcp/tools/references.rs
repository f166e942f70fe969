//! The tool `references`.

use super::super::answer::ToolAnswer;
use super::super::command::OwnProgram;
use super::super::input::ToolInput;
use super::tool::{Args, Tool, ToolWrites};
use crate::cli::command::CLEAN;
use schemars::JsonSchema;
use serde::Deserialize;

/// The arguments of `references`.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReferencesTool {
    /// File that uses the name; other files of its project are searched too
    path: String,
    /// Name of a variable, function, struct, member or macro
    name: String,
    /// Only what the name means in this line of the file; otherwise each symbol with this name is listed
    line: Option<u32>,
}

impl Tool for ReferencesTool {
    const NAME: &str = "references";
    const TITLE: &str = "Find references";
    const ABOUT: &str = "Lists where a project uses a name of a shader, in shaders and in scripts: \
        position, kind of use (defined, read, written) and line. Names are resolved, so that other \
        symbols of the same name are separate groups.";
    const WRITES: ToolWrites = ToolWrites::Nothing;

    async fn answer(self, program: &OwnProgram) -> Result<ToolAnswer, String> {
        let input = ToolInput::of(Some(&self.path), None)?;
        let mut args = Args::of(&["references"]);
        args.option("--line", self.line.map(|line| line.to_string()));
        args.0.extend(input.args());
        args.0.push(self.name.into());
        let done = program.run(args.0, "").await?;
        match done.code == i32::from(CLEAN) {
            true => Ok(ToolAnswer::of(&done.out, "no references")),
            false => Err(done.message()),
        }
    }
}
