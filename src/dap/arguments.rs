//! The arguments of requests that this adapter reads.

use serde::Deserialize;
use serde_json::Value;
use shaderlint_engine::inputs::{Button, Moment, Mouse};
use std::collections::BTreeMap;

/// The arguments of `launch`.
#[derive(Clone, Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Launch {
    /// The shader, export or folder of passes.
    pub program: String,
    /// Its text, if it is not read from a file.
    pub text: Option<String>,
    /// The texts of the passes of a folder by file name, if they are not read from files.
    pub passes: BTreeMap<String, String>,
    /// The pixel, from the lower left corner; the centre by default.
    pub pixel: Option<[u32; 2]>,
    /// Width and height of the image in pixels.
    pub size: Option<[u32; 2]>,
    /// Time in seconds.
    pub time: Option<f64>,
    /// Frame number.
    pub frame: Option<u32>,
    /// The pass; the image by default.
    pub pass: Option<String>,
    /// The mouse: its position, and whether the button is down.
    pub mouse: Option<MousePosition>,
    /// The host of the shader.
    pub host: Option<String>,
    /// The inputs of channels, as after `--channel`.
    pub channels: Vec<String>,
    /// Values of uniforms by name.
    pub uniforms: Option<Value>,
    /// Whether to stop before the first statement.
    pub stop_on_entry: Option<bool>,
}

/// The arguments of `restart` and `shaderlint/reload`: texts that have changed since `launch`.
#[derive(Default, Deserialize)]
#[serde(default)]
pub struct Reload {
    pub text: Option<String>,
    pub passes: Option<BTreeMap<String, String>>,
    pub channels: Option<Vec<String>>,
}

/// The mouse, in pixels from the lower left corner.
#[derive(Clone, Copy, Deserialize)]
pub struct MousePosition {
    pub x: f64,
    pub y: f64,
    #[serde(default)]
    pub down: bool,
}

/// Default size in pixels.
const SIZE: [u32; 2] = [320, 180];
/// Maximum number of pixels.
const MAX_PIXELS: u64 = 1 << 24;

impl Launch {
    /// Width and height of the image.
    ///
    /// # Errors
    /// A message about a size that cannot be drawn.
    pub fn size(&self) -> Result<[u32; 2], String> {
        let [width, height] = self.size.unwrap_or(SIZE);
        match u64::from(width) * u64::from(height) {
            1..=MAX_PIXELS => Ok([width, height]),
            _ => Err(format!(
                "`size` has at least 1 and at most {MAX_PIXELS} pixels"
            )),
        }
    }

    /// The frame.
    pub fn moment(&self) -> Moment {
        let mouse = self.mouse.map(|mouse| Mouse {
            at: [mouse.x, mouse.y],
            button: if mouse.down { Button::Down } else { Button::Up },
        });
        let time = self.time.filter(|time| time.is_finite() && *time >= 0.0);
        Moment::given(time, self.frame, mouse)
    }

    /// The pixel.
    ///
    /// # Errors
    /// A message about a pixel outside the image.
    pub fn pixel(&self) -> Result<[u32; 2], String> {
        let [width, height] = self.size()?;
        let [x, y] = self.pixel.unwrap_or([width / 2, height / 2]);
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
