//! `fix`.

use super::super::answer::{MAX_TEXT, ToolAnswer};
use super::super::command::{CommandOutcome, OwnProgram};
use super::super::input::ToolInput;
use super::tool::{Args, Tool, ToolWrites};
use crate::cli::command::FAILED;
use schemars::JsonSchema;
use serde::Deserialize;

/// The arguments of `fix`.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FixTool {
    /// A file or folder
    path: Option<String>,
    /// The text of a shader, instead of `path`; the answer is the whole text
    code: Option<String>,
    /// File name of `code`; its ending tells what it is
    name: Option<String>,
    /// Apply fixes too that may change the picture
    #[serde(default)]
    unsafe_fixes: bool,
    /// Write the fixes into the files; without it the answer is a diff
    #[serde(default)]
    write: bool,
}

impl Tool for FixTool {
    const NAME: &str = "fix";
    const TITLE: &str = "Fix shaders";
    const ABOUT: &str = "Mends what `check` reports: fixes that keep the picture, and on demand \
        others. Answers with a diff or, for `code`, with the text; then what is left to be done by \
        hand.";
    const WRITES: ToolWrites = ToolWrites::Files;

    async fn answer(self, program: &OwnProgram) -> Result<ToolAnswer, String> {
        let input = ToolInput::of(self.path.as_ref(), self.code.as_ref())?;
        let mut args = Args::of(&["--format=agent"]);
        args.option("--stdin-filename", self.name);
        args.switch("--unsafe-fixes", self.unsafe_fixes);
        match (input, self.write) {
            (ToolInput::Code(_), true) => return Err("only files can be written".to_string()),
            (ToolInput::Code(_), false) | (ToolInput::Path(_), true) => args.switch("--fix", true),
            (ToolInput::Path(_), false) => args.switch("--diff", true),
        }
        args.0.extend(input.args());
        let done = program.run(args.0, input.text()).await?;
        if done.code == i32::from(FAILED) && done.out.is_empty() {
            return Err(done.err);
        }
        match input {
            ToolInput::Code(code) => mended(code, done),
            ToolInput::Path(_) if self.write => {
                Ok(ToolAnswer::of_outcome(&done, "nothing is wrong"))
            }
            ToolInput::Path(_) => Ok(ToolAnswer::of_outcome(&done, "nothing can be fixed")),
        }
    }
}

/// A text that was mended. Half of a text would be taken for the whole.
fn mended(code: &str, mut done: CommandOutcome) -> Result<ToolAnswer, String> {
    if done.out == code {
        done.out = "nothing can be fixed: the text stays as it is".to_string();
    } else if done.out.len() > MAX_TEXT {
        let len = done.out.len();
        return Err(format!(
            "the text has {len} bytes, {MAX_TEXT} can be answered: save it, and give its `path`"
        ));
    }
    Ok(ToolAnswer::of_outcome(&done, "the text is empty"))
}
