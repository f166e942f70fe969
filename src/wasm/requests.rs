//! The requests, as JSON objects with `method` and `params`.

use lsp_server::Message;
use serde::Deserialize;
use shaderlint_commands::{CheckRequest, FormatRequest};
use shaderlint_report::Format;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// What a host can ask.
#[derive(Deserialize)]
#[serde(tag = "method", content = "params", rename_all = "camelCase")]
pub enum ModuleRequest {
    /// Checks a text.
    Check(CheckParams),
    /// Applies fixes to a text.
    Fix(FixRequest),
    /// Formats a text.
    Format(FormatParams),
    /// Draws a shader.
    #[cfg(feature = "port")]
    Run(Box<super::run::RunParams>),
    /// Returns the page of a rule, compile error or host.
    Explain {
        /// Its name, or words that the page contains.
        name: String,
    },
    /// Lists all rules and compile errors.
    Rules,
    /// Passes a message to the language server. The answer lists its messages.
    Lsp(Message),
    /// Runs the shaders of documents that changed, for the language server.
    RunChanged,
    /// Passes a message to the debugger. The answer lists its messages.
    #[cfg(feature = "port")]
    Debug(serde_json::Value),
    /// Counts the pixels that hit new breakpoints, for the debugger.
    #[cfg(feature = "port")]
    DebugIdle,
    /// Ports a shader.
    #[cfg(feature = "port")]
    Port(super::port::PortParams),
    /// Returns the data of a shader for the page that plays it.
    #[cfg(feature = "port")]
    PlayerData(super::project::ShaderText),
    /// Returns the page that plays shaders.
    #[cfg(feature = "port")]
    PlayerPage,
}

/// A text with the options of its check.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct TextInput {
    /// Name of the file; its extension selects the kind of file.
    pub name: String,
    /// Contents of the file.
    pub text: String,
    /// Other files, by path, for includes.
    #[serde(default)]
    pub files: BTreeMap<PathBuf, String>,
    /// How it is checked.
    #[serde(flatten)]
    pub request: CheckRequest,
}

/// The request `check`.
#[derive(Deserialize)]
pub struct CheckParams {
    /// The text.
    #[serde(flatten)]
    pub input: TextInput,
    /// The output format.
    #[serde(default = "json")]
    pub format: Format,
}

/// What programs read.
fn json() -> Format {
    Format::Json
}

/// The request `fix`.
#[derive(Deserialize)]
pub struct FixRequest {
    /// The text.
    #[serde(flatten)]
    pub input: TextInput,
    /// Whether fixes are applied that may change the image.
    #[serde(default, rename = "unsafe")]
    pub is_unsafe: bool,
}

/// The request `format`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FormatParams {
    /// Name of the file; its extension selects the kind of file.
    pub name: String,
    /// Contents of the file.
    pub text: String,
    /// The style.
    #[serde(flatten)]
    pub request: FormatRequest,
}
