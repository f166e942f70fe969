//! What is asked of a run: the same for the command line, MCP, WebAssembly and the debugger.

use super::setting::{FrameView, HeatMap, ObservedRays, ShotSetting, Show, UniformText};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use shaderlint_engine::inputs::{Button, Moment, Mouse};
use shaderlint_exec::Watch;
use shaderlint_play::Decode;

/// Who completes a shader, and what its channels read.
#[derive(Clone, Default, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "cli", derive(clap::Args, schemars::JsonSchema))]
#[cfg_attr(feature = "cli", command(next_help_heading = "Input"))]
#[serde(default)]
pub struct InputRequest {
    /// Site or library that the shader is written for: `shadertoy`, `glsl-sandbox`, `isf`
    ///
    /// Also accepts a file that describes a host. Default: the host in the configuration, or detected
    /// from the code. An unknown name lists all hosts.
    #[cfg_attr(
        feature = "cli",
        arg(long, value_name = "NAME", visible_alias = "from")
    )]
    #[serde(alias = "from")]
    pub host: Option<String>,
    /// Input of a channel: `0=photo.jpg`, `image.1=keyboard`, `buffer_a.0=buffer_a`, `0=self`
    ///
    /// The channel may be the name of a sampler: `u_tex0=photo.png`. Append the sampler settings:
    /// `0=photo.jpg,nearest,clamp,noflip`.
    #[cfg_attr(feature = "cli", arg(long = "channel", value_name = "[PASS.]N=SOURCE"))]
    pub channels: Vec<String>,
}

/// The frame of a shader, and what is shown of it.
#[derive(Clone, Default, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "cli", derive(clap::Args, schemars::JsonSchema))]
#[cfg_attr(feature = "cli", command(next_help_heading = "Frame"))]
#[serde(default)]
pub struct RunRequest {
    /// Pass to show: `image`, `buffer_a`
    #[cfg_attr(feature = "cli", arg(long, value_name = "PASS"))]
    pub pass: Option<String>,
    /// Values of uniforms by name: numbers, booleans, arrays of these, objects for structs
    #[cfg_attr(feature = "cli", arg(skip))]
    pub uniforms: Option<Map<String, Value>>,
    /// Width and height of the image in pixels
    #[cfg_attr(feature = "cli", arg(long, value_name = "WxH", value_parser = size_of))]
    #[cfg_attr(feature = "cli", arg(default_value = "640x360"))]
    pub size: Option<[u32; 2]>,
    /// Time in seconds since the start; also sets the frame number, at 60 frames per second
    #[cfg_attr(feature = "cli", arg(long, value_name = "T", value_parser = time_of))]
    pub time: Option<f64>,
    /// Frame number, starting at 0
    #[cfg_attr(feature = "cli", arg(long, value_name = "N"))]
    pub frame: Option<u32>,
    /// Last mouse position with the button down, in pixels from the lower left corner
    ///
    /// `down` holds the button.
    #[cfg_attr(feature = "cli", arg(long, value_name = "X,Y[,down]", value_parser = mouse_of))]
    pub mouse: Option<MouseRequest>,

    /// Draw a heat map of each pixel: steps, cost, divergence, nan, slope
    ///
    /// steps: loop iterations. cost: operations. divergence: percentage of the work of the 8x4
    /// pixel group that a pixel only waits for. nan: pixels with values that are not finite. slope:
    /// the largest slope of the scene's distance along the ray.
    #[cfg_attr(feature = "cli", arg(long, value_enum, value_name = "WHAT"))]
    #[cfg_attr(feature = "cli", arg(hide_possible_values = true, help_heading = ANALYSIS))]
    pub heatmap: Option<HeatMap>,
    /// Draw the value of a variable on a line
    ///
    /// If the line runs several times, the last value is drawn.
    #[cfg_attr(feature = "cli", arg(long, value_name = "NAME@LINE", value_parser = show_of))]
    #[cfg_attr(feature = "cli", arg(conflicts_with = "heatmap", help_heading = ANALYSIS))]
    pub show: Option<Show>,
    /// Trace a pixel: the values of its variables, its loops and its invalid numbers
    ///
    /// X and Y count from the lower left corner, as `gl_FragCoord` does. The JSON output lists every
    /// step.
    #[cfg_attr(feature = "cli", arg(long, value_name = "X,Y", value_parser = pixel_of))]
    #[cfg_attr(feature = "cli", arg(conflicts_with_all = ["heatmap", "show", "report", "sheet"]))]
    #[cfg_attr(feature = "cli", arg(help_heading = ANALYSIS))]
    pub pixel: Option<[u32; 2]>,
    /// Report loop iterations, the cost of each function and invalid numbers
    #[cfg_attr(feature = "cli", arg(long, help_heading = ANALYSIS))]
    pub report: bool,
    /// Draw a contact sheet of N frames, such as 9, starting at the time
    #[cfg_attr(feature = "cli", arg(long, value_name = "N", num_args = 0..=1))]
    #[cfg_attr(feature = "cli", arg(default_missing_value = "9", help_heading = OUTPUT))]
    #[cfg_attr(feature = "cli", arg(conflicts_with_all = ["heatmap", "frame"]))]
    pub sheet: Option<u32>,
    /// Seconds between the frames of a contact sheet; default: 1
    #[cfg_attr(feature = "cli", arg(long, value_name = "T", value_parser = time_of))]
    #[cfg_attr(feature = "cli", arg(help_heading = OUTPUT))]
    pub every: Option<f64>,
}

#[cfg(feature = "cli")]
const ANALYSIS: &str = "Analysis";
#[cfg(feature = "cli")]
const OUTPUT: &str = "Output";

/// The mouse: its position in pixels from the lower left corner.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
pub struct MouseRequest {
    /// From the left.
    pub x: f64,
    /// From below.
    pub y: f64,
    /// Whether the button is held.
    #[serde(default)]
    pub down: bool,
}

/// What a front gives all its runs.
#[derive(Clone, Copy)]
pub struct RunFront<'a> {
    /// The size if none is asked for.
    pub size: [u32; 2],
    /// The largest number of pixels of all images of a run.
    pub max_pixels: u64,
    /// Number of threads.
    pub threads: usize,
    /// Decoder for embedded images.
    pub decode: Option<Decode>,
    /// The values of uniforms from a file.
    pub uniforms: Option<UniformText<'a>>,
}

/// The largest number of frames of a contact sheet.
const MAX_SHEET: u32 = 100;

impl RunRequest {
    /// Width and height of the image, or of each image of a contact sheet.
    ///
    /// # Errors
    /// A message about a size that cannot be drawn.
    pub fn size(&self, usual: [u32; 2], max_pixels: u64) -> Result<[u32; 2], String> {
        let size = self.size.unwrap_or(usual);
        let count = self.sheet.unwrap_or(1);
        if !(1..=MAX_SHEET).contains(&count) {
            return Err(format!("a contact sheet has 1 to {MAX_SHEET} frames"));
        }
        let pixels = size.iter().map(|side| u64::from(*side)).product::<u64>();
        match pixels * u64::from(count) {
            pixels if (1..=max_pixels).contains(&pixels) => Ok(size),
            pixels => Err(format!(
                "an image has at least 1 and at most {max_pixels} pixels, not {pixels}"
            )),
        }
    }

    /// The mouse.
    pub fn mouse(&self) -> Option<Mouse> {
        let button = |down| if down { Button::Down } else { Button::Up };
        self.mouse.map(|mouse| Mouse {
            at: [mouse.x, mouse.y],
            button: button(mouse.down),
        })
    }

    /// The frame, by its number, its time or both.
    pub fn moment(&self) -> Moment {
        let time = self.time.filter(|time| time.is_finite() && *time >= 0.0);
        Moment::given(time, self.frame, self.mouse())
    }

    /// What is shown of a frame.
    pub fn view(&self) -> FrameView<'_> {
        FrameView {
            heat: self.heatmap,
            show: self.show.as_ref(),
            report: self.report,
        }
    }

    /// The values of uniforms, as JSON.
    pub fn uniforms(&self) -> Option<String> {
        let values = self.uniforms.as_ref();
        values.map(|values| serde_json::to_string(values).unwrap_or_default())
    }

    /// The settings of the draw. `uniforms` are those of the request.
    ///
    /// # Errors
    /// A message about a size that cannot be drawn.
    pub fn setting<'a>(
        &'a self,
        front: &RunFront<'a>,
        uniforms: Option<&'a str>,
    ) -> Result<ShotSetting<'a>, String> {
        let name = "uniforms";
        Ok(ShotSetting {
            size: self.size(front.size, front.max_pixels)?,
            threads: front.threads,
            pass: self.pass.as_deref(),
            show: self.show.as_ref(),
            uniforms: uniforms
                .map(|text| UniformText { name, text })
                .or(front.uniforms),
            rays: match self.heatmap {
                Some(HeatMap::Slope) => ObservedRays::Camera,
                _ => ObservedRays::Nothing,
            },
            watch: match self.report || self.pixel.is_some() {
                true => Watch::Numbers,
                false => Watch::Flow,
            },
            trace: self.pixel.is_some(),
            decode: front.decode,
        })
    }
}

/// Longest side of an image in pixels.
const MAX_SIDE: u32 = 16_384;
/// Maximum number of pixels of an image.
pub const MAX_PIXELS: u64 = 1 << 26;

/// Parses a size such as `640x360`.
///
/// # Errors
/// A message for the user.
pub fn size_of(text: &str) -> Result<[u32; 2], String> {
    let side = |text: &str| text.trim().parse::<u32>().ok().filter(|n| *n > 0);
    let (width, height) = text.split_once(['x', 'X']).ok_or(SIZE)?;
    let (width, height) = (side(width).ok_or(SIZE)?, side(height).ok_or(SIZE)?);
    let pixels = u64::from(width) * u64::from(height);
    if width.max(height) > MAX_SIDE || pixels > MAX_PIXELS {
        return Err(format!(
            "at most {MAX_SIDE} pixels per side and {MAX_PIXELS} in total"
        ));
    }
    Ok([width, height])
}

const SIZE: &str = "expected a size such as 640x360";

/// Parses a time in seconds.
///
/// # Errors
/// A message for the user.
pub fn time_of(text: &str) -> Result<f64, String> {
    let time = text.parse::<f64>().ok();
    let time = time.filter(|t| t.is_finite() && (0.0..1e9).contains(t));
    time.ok_or_else(|| "expected a time in seconds such as 2.5".to_string())
}

/// Parses a mouse position such as `320,180` or `320,180,down`.
#[cfg(feature = "cli")]
fn mouse_of(text: &str) -> Result<MouseRequest, String> {
    let wrong = || "expected a position such as 320,180 or 320,180,down".to_string();
    let parts: Vec<&str> = text.split(',').map(str::trim).collect();
    let (x, y, down) = match parts[..] {
        [x, y] => (x, y, false),
        [x, y, "down"] => (x, y, true),
        _ => return Err(wrong()),
    };
    let lane = |text: &str| text.parse::<f64>().ok().filter(|n| n.is_finite());
    let (x, y) = (lane(x).ok_or_else(wrong)?, lane(y).ok_or_else(wrong)?);
    Ok(MouseRequest { x, y, down })
}

#[cfg(feature = "cli")]
/// Parses a pixel such as `320,180`.
fn pixel_of(text: &str) -> Result<[u32; 2], String> {
    let side = |text: &str| text.trim().parse::<u32>().ok();
    let parts = text.split_once(',');
    let pixel = parts.and_then(|(x, y)| Some([side(x)?, side(y)?]));
    pixel.ok_or_else(|| "expected a pixel such as 320,180".to_string())
}

#[cfg(feature = "cli")]
/// Parses a variable such as `d@42`.
fn show_of(text: &str) -> Result<Show, String> {
    let parts = text.rsplit_once('@');
    let show = parts.and_then(|(name, line)| {
        let line = line.trim().parse().ok().filter(|line| *line > 0)?;
        let name = name.trim().to_string();
        (!name.is_empty()).then_some(Show { name, line })
    });
    show.ok_or_else(|| "expected a name and a line such as d@42".to_string())
}

#[cfg(test)]
#[cfg(feature = "cli")]
mod tests {
    use super::*;

    #[test]
    fn invalid_sizes_positions_and_times_are_refused() {
        assert_eq!(size_of("640x360"), Ok([640, 360]));
        assert!(size_of("0x3").is_err() && size_of("640").is_err());
        assert!(size_of("16384x16384").is_err() && size_of("99999x1").is_err());
        assert_eq!(time_of("2.5"), Ok(2.5));
        assert!(time_of("-1").is_err() && time_of("nan").is_err());
        let mouse = mouse_of("3, 4.5,down").unwrap();
        assert_eq!((mouse.x, mouse.y, mouse.down), (3.0, 4.5, true));
        assert!(mouse_of("3").is_err() && mouse_of("3,4,up").is_err());
        let show = show_of("d@42").map(|s| (s.name, s.line));
        assert_eq!(show, Ok(("d".to_string(), 42)));
        assert!(show_of("d").is_err() && show_of("@4").is_err() && show_of("d@0").is_err());
    }
}
