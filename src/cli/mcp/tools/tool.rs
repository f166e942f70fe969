//! What a tool is, and how it makes the arguments of a command.

use super::super::answer::ToolAnswer;
use super::super::command::OwnProgram;
use clap::ValueEnum;
use schemars::{JsonSchema, Schema, json_schema};
use serde::de::DeserializeOwned;
use std::any::Any;
use std::ffi::OsString;

/// A tool.
pub trait Tool: DeserializeOwned + JsonSchema + Any {
    /// Its name.
    const NAME: &str;
    /// Its name for people.
    const TITLE: &str;
    /// What it does, for those who choose.
    const ABOUT: &str;
    /// What it writes.
    const WRITES: ToolWrites;

    /// Does what it is for. An error is told to the client as the answer.
    async fn answer(self, program: &OwnProgram) -> Result<ToolAnswer, String>;
}

/// What a tool writes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ToolWrites {
    /// Nothing.
    Nothing,
    /// Files that are named, and in the place of others where that is asked for.
    Files,
}

/// The arguments of a command.
#[derive(Default)]
pub struct Args(pub Vec<OsString>);

impl Args {
    /// Those that name a command.
    pub fn of(words: &[&str]) -> Args {
        Args(words.iter().map(OsString::from).collect())
    }

    /// A switch.
    pub fn switch(&mut self, option: &str, is_on: bool) {
        if is_on {
            self.0.push(option.into());
        }
    }

    /// An option with a value. The value may begin as an option does.
    pub fn option(&mut self, option: &str, value: Option<impl AsRef<str>>) {
        if let Some(value) = value {
            self.0.push(format!("{option}={}", value.as_ref()).into());
        }
    }

    /// An option that may be said several times.
    pub fn options<T: AsRef<str>>(&mut self, option: &str, values: &[T]) {
        values
            .iter()
            .for_each(|value| self.option(option, Some(value)));
    }
}

/// The schema of a text that the command line knows.
pub fn one_of<T: ValueEnum>(_: &mut schemars::SchemaGenerator) -> Schema {
    let values = T::value_variants().iter();
    let names = values.filter_map(|v| Some(v.to_possible_value()?.get_name().to_string()));
    json_schema!({ "type": "string", "enum": names.collect::<Vec<_>>() })
}
