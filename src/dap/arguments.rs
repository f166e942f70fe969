//! The arguments of requests that this adapter reads.

use serde::Deserialize;
use shaderlint_commands::run::{InputRequest, RunFront, RunRequest};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// The arguments of `launch`.
#[derive(Clone, Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Launch {
    /// The shader, export or folder of passes.
    pub program: String,
    /// Its text, if it is not read from a file.
    pub text: Option<String>,
    /// The texts of the passes of a folder by file name, if they are not read from files.
    pub passes: BTreeMap<PathBuf, String>,
    /// The texts of other files by path, for includes.
    pub files: BTreeMap<PathBuf, String>,
    /// Whether to stop before the first statement.
    pub stop_on_entry: Option<bool>,
    /// Who completes the shader.
    #[serde(flatten)]
    pub input: InputRequest,
    /// The frame; the pixel is the centre by default.
    #[serde(flatten)]
    pub request: RunRequest,
}

/// The arguments of `restart` and `shaderlint/reload`: texts that have changed since `launch`.
#[derive(Default, Deserialize)]
#[serde(default)]
pub struct Reload {
    pub text: Option<String>,
    pub passes: Option<BTreeMap<PathBuf, String>>,
    pub channels: Option<Vec<String>>,
}

impl Launch {
    /// The pixel.
    ///
    /// # Errors
    /// A message about a pixel outside the image.
    pub fn pixel(&self, front: &RunFront<'_>) -> Result<[u32; 2], String> {
        let [width, height] = self.request.size(front.size, front.max_pixels)?;
        let [x, y] = self.request.pixel.unwrap_or([width / 2, height / 2]);
        match x < width && y < height {
            true => Ok([x, y]),
            false => Err(format!(
                "the pixel {x},{y} is outside the image of {width}x{height}"
            )),
        }
    }
}

/// A source file, by path or by number.
#[derive(Clone, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub struct SourceArgument {
    pub path: Option<String>,
    pub source_reference: Option<u32>,
}

/// The arguments of `setBreakpoints`.
#[derive(Default, Deserialize)]
#[serde(default)]
pub struct SetBreakpoints {
    pub source: SourceArgument,
    pub breakpoints: Vec<BreakpointArgument>,
}

/// A breakpoint.
#[derive(Clone, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub struct BreakpointArgument {
    pub line: u32,
    pub column: Option<u32>,
    pub condition: Option<String>,
    pub hit_condition: Option<String>,
    pub log_message: Option<String>,
}

/// The arguments of requests about a thread, a frame, a value or an expression.
#[derive(Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub struct DebugArguments {
    pub thread_id: u32,
    pub frame_id: Option<u32>,
    pub variables_reference: u32,
    pub start: usize,
    pub count: usize,
    pub start_frame: usize,
    pub levels: usize,
    pub name: String,
    pub expression: String,
    pub granularity: String,
    pub source_reference: u32,
    pub source: SourceArgument,
    pub line: u32,
    pub end_line: Option<u32>,
    pub pixel: Option<[u32; 2]>,
    pub time: Option<f64>,
    pub frame: Option<u32>,
    pub pass: Option<String>,
    pub filters: Vec<String>,
    pub breakpoints: Vec<DataBreakpointArgument>,
}

/// A data breakpoint.
#[derive(Clone, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub struct DataBreakpointArgument {
    pub data_id: String,
}
