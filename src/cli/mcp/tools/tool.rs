//! The interface of tools, and a builder for command arguments.

use super::super::answer::ToolAnswer;
use super::super::command::{CommandOutcome, OwnProgram};
use super::super::input::ToolInput;
use crate::cli::command::FAILED;
use schemars::JsonSchema;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::any::Any;
use std::ffi::OsString;
use std::fs;
use std::path::Path;

/// A tool of the MCP server.
pub trait Tool: DeserializeOwned + JsonSchema + Any {
    /// Identifier in the protocol.
    const NAME: &str;
    /// Title for people.
    const TITLE: &str;
    /// Description for the model that chooses a tool.
    const ABOUT: &str;
    /// Which files it may write.
    const WRITES: ToolWrites;

    /// Runs the tool. Errors are reported to the client as the answer.
    async fn answer(self, program: &OwnProgram) -> Result<ToolAnswer, String>;
}

/// Which files a tool may write.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ToolWrites {
    /// None.
    Nothing,
    /// Files that the arguments name, and existing files if asked to.
    Files,
}

/// Runs a command on the input of a tool.
///
/// # Errors
/// A message if it has not finished, or if it failed without output.
pub async fn ran(
    program: &OwnProgram,
    mut args: Args,
    input: &ToolInput<'_>,
) -> Result<CommandOutcome, String> {
    args.0.extend(input.args());
    let done = program.run(args.0, input.text()).await?;
    match done.code == i32::from(FAILED) && done.out.is_empty() {
        true => Err(done.err),
        false => Ok(done),
    }
}

/// The arguments of a command that reads the rest from a file, which is written to a folder.
pub fn asked(tool: &impl Serialize, command: &str, folder: &Path) -> Result<Args, String> {
    let path = folder.join("request.json");
    let text = serde_json::to_vec(tool).map_err(|e| e.to_string())?;
    fs::write(&path, text).map_err(|e| e.to_string())?;
    let mut args = Args::of(&[command]);
    args.option("--asked", Some(path.to_string_lossy()));
    Ok(args)
}

/// The arguments of a command.
#[derive(Default)]
pub struct Args(pub Vec<OsString>);

impl Args {
    /// Starts with the name of a command.
    pub fn of(words: &[&str]) -> Args {
        Args(words.iter().map(OsString::from).collect())
    }

    /// Adds a flag.
    pub fn switch(&mut self, option: &str, is_on: bool) {
        if is_on {
            self.0.push(option.into());
        }
    }

    /// Adds an option with a value, which may look like an option.
    pub fn option(&mut self, option: &str, value: Option<impl AsRef<str>>) {
        if let Some(value) = value {
            self.0.push(format!("{option}={}", value.as_ref()).into());
        }
    }
}

/// A message of a command in the words of a tool: options of the command line as parameters of the same
/// name. `--channel 0=FILE` becomes `0=FILE` in `channels`.
pub fn in_parameters<T: JsonSchema>(message: &str) -> String {
    let schema = schemars::schema_for!(T);
    let known = |name: &String| schema.get("properties").and_then(|p| p.get(name)).is_some();
    let parameter = |option: &str| {
        let name = option.strip_prefix("--")?.replace('-', "_");
        [format!("{name}s"), name].into_iter().find(known)
    };
    let quoted = message.split('`').zip((0..).map(|n| n % 2 == 1));
    let parts = quoted.map(|(part, is_quoted)| {
        let (option, value) = part.split_once(' ').unwrap_or((part, ""));
        match parameter(option).filter(|_| is_quoted) {
            None => part.to_string(),
            Some(parameter) if value.is_empty() => parameter,
            Some(parameter) => format!("{value}` in `{parameter}"),
        }
    });
    parts.collect::<Vec<_>>().join("`")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_name_the_parameters_of_the_tool() {
        #[derive(JsonSchema)]
        #[expect(dead_code, reason = "only the schema is read")]
        struct Parameters {
            repair: bool,
            channels: Vec<String>,
        }
        let reported = in_parameters::<Parameters>;
        assert_eq!(
            reported("`--repair` fixes 1 of these errors; `--diff` shows how"),
            "`repair` fixes 1 of these errors; `--diff` shows how"
        );
        assert_eq!(
            reported("use `--channel 0=FILE`, or drop a file"),
            "use `0=FILE` in `channels`, or drop a file"
        );
        assert_eq!(reported("`x` --repair `y"), "`x` --repair `y");
    }
}
