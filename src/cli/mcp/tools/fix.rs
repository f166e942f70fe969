//! The tool `fix`.

use super::super::answer::{MAX_TEXT, ToolAnswer};
use super::super::command::{CommandOutcome, OwnProgram};
use super::super::input::ToolInput;
use super::tool::{Tool, ToolWrites, asked, ran};
use crate::commands::CheckRequest;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The arguments of `fix`.
#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FixTool {
    /// File or folder to fix
    path: Option<String>,
    /// Text of a shader, instead of `path`; the answer is the complete fixed text
    code: Option<String>,
    /// File name of `code`; its extension selects the kind of file
    name: Option<String>,
    #[serde(flatten)]
    request: CheckRequest,
    /// Also apply unsafe fixes, which may change the image
    #[serde(default)]
    unsafe_fixes: bool,
    /// Write the fixed files; otherwise the answer is a diff
    #[serde(default)]
    write: bool,
}

impl Tool for FixTool {
    const NAME: &str = "fix";
    const TITLE: &str = "Fix shaders";
    const ABOUT: &str = "Fixes what `check` reports, by default only where the image stays the \
        same. Returns a diff or, for `code`, the fixed text, followed by the remaining findings.";
    const WRITES: ToolWrites = ToolWrites::Files;

    async fn answer(self, program: &OwnProgram) -> Result<ToolAnswer, String> {
        let input = ToolInput::of(self.path.as_ref(), self.code.as_ref())?;
        let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
        let mut args = asked(&self, "check", folder.path())?;
        args.option("--format", Some("tool"));
        args.option("--stdin-filename", self.name.as_ref());
        args.switch("--unsafe-fixes", self.unsafe_fixes);
        match (input, self.write) {
            (ToolInput::Code(_), true) => {
                return Err("`write` requires `path`: only files can be written".to_string());
            }
            (ToolInput::Code(_), false) | (ToolInput::Path(_), true) => args.switch("--fix", true),
            (ToolInput::Path(_), false) => args.switch("--diff", true),
        }
        let done = ran(program, args, &input).await?;
        match input {
            ToolInput::Code(code) => fixed(code, done),
            ToolInput::Path(_) if self.write => Ok(ToolAnswer::of_outcome(&done, "no findings")),
            ToolInput::Path(_) => Ok(ToolAnswer::of_outcome(&done, "no fixes available")),
        }
    }
}

/// The fixed text. It is never truncated, because the client would save it.
fn fixed(code: &str, mut done: CommandOutcome) -> Result<ToolAnswer, String> {
    if done.out == code {
        done.out = "no fixes available; the text is unchanged".to_string();
    } else if done.out.len() > MAX_TEXT {
        let len = done.out.len();
        return Err(format!(
            "the fixed text has {len} bytes, the limit is {MAX_TEXT}; save it and pass its `path`"
        ));
    }
    Ok(ToolAnswer::of_outcome(&done, "the text is empty"))
}
