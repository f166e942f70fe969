//! The interface of tools, and a builder for command arguments.

use super::super::answer::ToolAnswer;
use super::super::command::OwnProgram;
use clap::ValueEnum;
use schemars::{JsonSchema, Schema, json_schema};
use serde::de::DeserializeOwned;
use std::any::Any;
use std::ffi::OsString;

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

    /// Adds an option once for each value.
    pub fn options<T: AsRef<str>>(&mut self, option: &str, values: &[T]) {
        values
            .iter()
            .for_each(|value| self.option(option, Some(value)));
    }
}

/// The schema of a string with the values that a command-line option accepts.
pub fn one_of<T: ValueEnum>(_: &mut schemars::SchemaGenerator) -> Schema {
    let values = T::value_variants().iter();
    let names = values.filter_map(|v| Some(v.to_possible_value()?.get_name().to_string()));
    json_schema!({ "type": "string", "enum": names.collect::<Vec<_>>() })
}
