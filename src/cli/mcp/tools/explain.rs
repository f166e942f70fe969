//! The tool `explain`.

use super::super::answer::ToolAnswer;
use super::super::command::OwnProgram;
use super::tool::{Args, Tool, ToolWrites};
use crate::cli::command::CLEAN;
use schemars::JsonSchema;
use serde::Deserialize;

/// The arguments of `explain`.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ExplainTool {
    /// Name of a rule, compile error or host; without a name all rules are listed
    name: Option<String>,
}

impl Tool for ExplainTool {
    const NAME: &str = "explain";
    const TITLE: &str = "Explain a rule";
    const ABOUT: &str = "Explains what a rule or compile error means, why it matters and how to fix \
        it, with examples. Without a name, lists all rules.";
    const WRITES: ToolWrites = ToolWrites::Nothing;

    async fn answer(self, program: &OwnProgram) -> Result<ToolAnswer, String> {
        let mut args = match self.name {
            None => Args::of(&["rules"]),
            Some(_) => Args::of(&["explain", "--"]),
        };
        args.0.extend(self.name.map(Into::into));
        let done = program.run(args.0, "").await?;
        match done.code == i32::from(CLEAN) {
            true => Ok(ToolAnswer::of(&done.out, "the documentation is empty")),
            false => Err(done.err),
        }
    }
}
