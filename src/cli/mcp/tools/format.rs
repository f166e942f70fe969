//! The tool `format`.

use super::super::answer::{MAX_TEXT, ToolAnswer};
use super::super::command::OwnProgram;
use super::super::input::ToolInput;
use super::tool::{Args, Tool, ToolWrites};
use crate::cli::command::FAILED;
use crate::commands::FormatRequest;
use schemars::JsonSchema;
use serde::Deserialize;

/// The arguments of `format`.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FormatTool {
    /// File or folder to format
    path: Option<String>,
    /// Text of a shader, instead of `path`; the answer is the complete formatted text
    code: Option<String>,
    /// File name of `code`; its extension selects the kind of file
    name: Option<String>,
    #[serde(flatten)]
    request: FormatRequest,
    /// Write the formatted files; otherwise the answer is a diff
    #[serde(default)]
    write: bool,
}

impl Tool for FormatTool {
    const NAME: &str = "format";
    const TITLE: &str = "Format shaders";
    const ABOUT: &str = "Formats shaders: only white space changes. Returns a diff or, for `code`, \
        the formatted text.";
    const WRITES: ToolWrites = ToolWrites::Files;

    async fn answer(self, program: &OwnProgram) -> Result<ToolAnswer, String> {
        let input = ToolInput::of(self.path.as_ref(), self.code.as_ref())?;
        let mut args = Args::of(&["fmt"]);
        args.option("--stdin-filename", self.name);
        let FormatRequest {
            indent,
            line_length,
        } = self.request;
        args.option("--indent", indent.map(|n| n.to_string()));
        args.option("--line-length", line_length.map(|n| n.to_string()));
        match (input, self.write) {
            (ToolInput::Code(_), true) => {
                return Err("`write` requires `path`: only files can be written".to_string());
            }
            (ToolInput::Code(_), false) => args.switch("--quiet", true),
            (ToolInput::Path(_), false) => args.switch("--diff", true),
            (ToolInput::Path(_), true) => {}
        }
        args.0.extend(input.args());
        let done = program.run(args.0, input.text()).await?;
        if done.code == i32::from(FAILED) {
            return Err(done.err);
        }
        // A client would save a text that is cut off.
        if matches!(input, ToolInput::Code(_)) && done.out.len() > MAX_TEXT {
            let len = done.out.len();
            return Err(format!(
                "the formatted text has {len} bytes, the limit is {MAX_TEXT}; save it and pass its `path`"
            ));
        }
        Ok(ToolAnswer::of_outcome(&done, "already formatted"))
    }
}
