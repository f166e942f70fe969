//! The tools. Each is the form of its arguments, and makes a command of them.

mod check;
mod explain;
mod fix;
mod port;
mod run;

use super::answer::ToolAnswer;
use super::command::OwnProgram;
use check::CheckTool;
use clap::ValueEnum;
use explain::ExplainTool;
use fix::FixTool;
use port::PortTool;
use rmcp::ErrorData;
use rmcp::handler::server::tool::schema_for_input;
use rmcp::model::{JsonObject, ToolAnnotations};
use run::RunTool;
use schemars::{JsonSchema, Schema, json_schema};
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::any::Any;
use std::ffi::OsString;

/// A tool.
trait Tool: DeserializeOwned + JsonSchema + Any {
    /// Its name.
    const NAME: &str;
    /// Its name for people.
    const TITLE: &str;
    /// What it does, for those who choose.
    const ABOUT: &str;
    /// What it writes.
    const WRITES: Writes;

    /// Does what it is for. An error is told to the client as the answer.
    async fn answer(self, program: &OwnProgram) -> Result<ToolAnswer, String>;
}

/// What a tool writes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Writes {
    /// Nothing.
    Nothing,
    /// Files that are named, and in the place of others where that is asked for.
    Files,
}

/// All tools.
///
/// # Errors
/// Where one has no schema.
pub fn all() -> Result<Vec<rmcp::model::Tool>, ErrorData> {
    Ok(vec![
        described::<CheckTool>()?,
        described::<FixTool>()?,
        described::<RunTool>()?,
        described::<ExplainTool>()?,
        described::<PortTool>()?,
    ])
}

/// Calls a tool.
///
/// # Errors
/// Where there is none of that name.
pub async fn call(
    name: &str,
    arguments: JsonObject,
    program: &OwnProgram,
) -> Result<ToolAnswer, ErrorData> {
    Ok(match name {
        CheckTool::NAME => called::<CheckTool>(arguments, program).await,
        FixTool::NAME => called::<FixTool>(arguments, program).await,
        RunTool::NAME => called::<RunTool>(arguments, program).await,
        ExplainTool::NAME => called::<ExplainTool>(arguments, program).await,
        PortTool::NAME => called::<PortTool>(arguments, program).await,
        _ => {
            let message = format!("there is no tool `{name}`");
            return Err(ErrorData::invalid_params(message, None));
        }
    })
}

fn described<T: Tool>() -> Result<rmcp::model::Tool, ErrorData> {
    let schema = schema_for_input::<T>().map_err(|e| ErrorData::internal_error(e, None))?;
    let annotations = ToolAnnotations::with_title(T::TITLE)
        .read_only(T::WRITES == Writes::Nothing)
        .destructive(T::WRITES == Writes::Files)
        .idempotent(true)
        .open_world(false);
    Ok(rmcp::model::Tool::new(T::NAME, T::ABOUT, schema).with_annotations(annotations))
}

/// Wrong arguments are told as the answer, where whoever chose them reads it.
async fn called<T: Tool>(arguments: JsonObject, program: &OwnProgram) -> ToolAnswer {
    let answer = match serde_json::from_value::<T>(Value::Object(arguments)) {
        Ok(tool) => tool.answer(program).await,
        Err(error) => Err(format!("wrong arguments: {error}")),
    };
    answer.unwrap_or_else(|why| ToolAnswer::failed(&why))
}

/// The arguments of a command.
#[derive(Default)]
struct Args(Vec<OsString>);

impl Args {
    /// Those that name a command.
    fn of(words: &[&str]) -> Args {
        Args(words.iter().map(OsString::from).collect())
    }

    /// A switch.
    fn switch(&mut self, option: &str, is_on: bool) {
        if is_on {
            self.0.push(option.into());
        }
    }

    /// An option with a value. The value may begin as an option does.
    fn option(&mut self, option: &str, value: Option<impl AsRef<str>>) {
        if let Some(value) = value {
            self.0.push(format!("{option}={}", value.as_ref()).into());
        }
    }

    /// An option that may be said several times.
    fn options<T: AsRef<str>>(&mut self, option: &str, values: &[T]) {
        values
            .iter()
            .for_each(|value| self.option(option, Some(value)));
    }
}

/// The schema of a text that the command line knows.
fn one_of<T: ValueEnum>(_: &mut schemars::SchemaGenerator) -> Schema {
    let values = T::value_variants().iter();
    let names = values.filter_map(|v| Some(v.to_possible_value()?.get_name().to_string()));
    json_schema!({ "type": "string", "enum": names.collect::<Vec<_>>() })
}
