//! The arguments of `shaderlint run`.

use crate::cli::command::TextOrJson;
use crate::cli::image_file::decode;
use crate::commands::run::{FrameView, HeatMap, ObservedRays, ShotSetting, Show, UniformText};
use crate::engine::inputs::{Button, Moment, Mouse};
use crate::exec::Watch;
use clap::ValueEnum;
use std::path::PathBuf;

/// Run a shader on the CPU and show its image and statistics.
///
/// Draws one frame as WebGL2 would, without a GPU.
#[derive(clap::Args, Debug)]
#[command(after_help = EXIT_CODES)]
pub struct RunArgs {
    /// Fragment shader, ShaderToy pass or ShaderToy export (.json); `-` reads standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,

    /// Site or library that the shader is written for: `shadertoy`, `glsl-sandbox`, `isf`
    ///
    /// Also accepts a file that describes a host. Default: the host in the configuration, or detected
    /// from the code. An unknown name lists all hosts.
    #[arg(long, value_name = "NAME", visible_alias = "from", help_heading = INPUT)]
    pub host: Option<String>,
    /// Input of a channel: `0=photo.jpg`, `image.1=keyboard`, `buffer_a.0=buffer_a`
    ///
    /// The channel may be the name of a sampler: `u_tex0=photo.png`. Append the sampler settings:
    /// `0=photo.jpg,nearest,clamp,noflip`.
    #[arg(long, value_name = "[PASS.]N=SOURCE", help_heading = INPUT)]
    pub channel: Vec<String>,
    /// Pass to show: `image`, `buffer_a`
    #[arg(long, value_name = "PASS", help_heading = INPUT)]
    pub pass: Option<String>,
    /// JSON file with an object of uniform values
    ///
    /// Values are numbers, booleans, arrays of these (matrices in column order) and objects for
    /// structs.
    #[arg(long, value_name = "FILE", help_heading = INPUT)]
    pub uniforms: Option<PathBuf>,

    /// Size of the image in pixels
    #[arg(long, value_name = "WxH", default_value = "640x360", value_parser = size_of)]
    #[arg(help_heading = FRAME)]
    pub size: [u32; 2],
    /// Time in seconds since the start; also sets the frame number, at 60 frames per second
    #[arg(long, value_name = "T", value_parser = time_of, help_heading = FRAME)]
    pub time: Option<f64>,
    /// Frame number, starting at 0
    #[arg(long, value_name = "N", help_heading = FRAME)]
    pub frame: Option<u32>,
    /// Last mouse position with the button down, in pixels from the lower left corner
    ///
    /// Append `,down` to hold the button.
    #[arg(long, value_name = "X,Y[,down]", value_parser = mouse_of, help_heading = FRAME)]
    pub mouse: Option<Mouse>,

    /// Draw a heat map of each pixel: steps, cost, divergence, nan, slope
    ///
    /// steps: loop iterations. cost: operations. divergence: percentage of the work of the 8x4
    /// pixel group that a pixel only waits for. nan: pixels with values that are not finite.
    #[arg(long, value_enum, value_name = "WHAT", help_heading = ANALYSIS)]
    #[arg(hide_possible_values = true)]
    pub heatmap: Option<Heat>,
    /// Draw the value of a variable on a line: `d@42`
    ///
    /// If the line runs several times, the last value is drawn.
    #[arg(long, value_name = "NAME@LINE", value_parser = show_of, help_heading = ANALYSIS)]
    #[arg(conflicts_with_all = ["heatmap", "compare"])]
    pub show: Option<Show>,
    /// Trace a pixel: the values of its variables, its loops and its invalid numbers
    ///
    /// X and Y count from the lower left corner, as `gl_FragCoord` does. `--format json` lists every
    /// step.
    #[arg(long, value_name = "X,Y", value_parser = pixel_of, help_heading = ANALYSIS)]
    #[arg(conflicts_with_all = ["heatmap", "show", "compare", "report", "output", "sheet"])]
    pub pixel: Option<[u32; 2]>,
    /// Report loop iterations, the cost of each function and invalid numbers
    #[arg(long, help_heading = ANALYSIS)]
    pub report: bool,
    /// Compare with another shader bit for bit; exit with code 1 if they differ
    #[arg(long, value_name = "OTHER", help_heading = ANALYSIS)]
    #[arg(conflicts_with = "heatmap")]
    pub compare: Option<PathBuf>,

    /// PNG file to write; default: show the image in the terminal
    #[arg(short, long, value_name = "OUT.png", help_heading = OUTPUT)]
    pub output: Option<PathBuf>,
    /// Overwrite existing files
    #[arg(long, help_heading = OUTPUT)]
    pub force: bool,
    /// Draw a contact sheet of N frames, 9 by default, starting at --time
    #[arg(long, value_name = "N", num_args = 0..=1, default_missing_value = "9")]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=100), help_heading = OUTPUT)]
    #[arg(conflicts_with_all = ["heatmap", "compare", "frame"])]
    pub sheet: Option<u32>,
    /// Seconds between the frames of a contact sheet
    #[arg(long, value_name = "T", default_value = "1", value_parser = time_of)]
    #[arg(help_heading = OUTPUT)]
    pub every: f64,
    /// Output format: human, json
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT", help_heading = OUTPUT)]
    #[arg(hide_possible_values = true)]
    pub format: TextOrJson,
    /// Number of threads; default: one per core
    #[arg(long, value_name = "N", help_heading = OUTPUT)]
    #[arg(value_parser = clap::value_parser!(u16).range(1..=256))]
    pub threads: Option<u16>,
}

const INPUT: &str = "Input";
const FRAME: &str = "Frame";
const ANALYSIS: &str = "Analysis";
const OUTPUT: &str = "Output";

const EXIT_CODES: &str = "\
Exit codes:
  0  The shader was drawn
  1  The shader has errors, or --compare found a difference
  2  Wrong usage, or a file cannot be read or written";

/// What a heat map shows of each pixel.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum Heat {
    /// Loop iterations
    Steps,
    /// Operations
    Cost,
    /// Percentage of the work of its 8x4 pixel group that the pixel only waits for
    #[value(alias = "overdraw")]
    Divergence,
    /// Values that are not finite
    Nan,
    /// The largest slope of the scene's distance along the ray
    Slope,
}

impl Heat {
    fn map(self) -> HeatMap {
        match self {
            Heat::Steps => HeatMap::Steps,
            Heat::Cost => HeatMap::Cost,
            Heat::Divergence => HeatMap::Divergence,
            Heat::Nan => HeatMap::Nan,
            Heat::Slope => HeatMap::Slope,
        }
    }
}

impl RunArgs {
    /// What is shown of the frame.
    pub fn view(&self) -> FrameView<'_> {
        FrameView {
            heat: self.heatmap.map(Heat::map),
            show: self.show.as_ref(),
            report: self.report,
        }
    }

    /// The time, frame and mouse to draw.
    pub fn moment(&self) -> Moment {
        Moment::given(self.time, self.frame, self.mouse)
    }

    /// The settings of the draw. `uniforms` is the text of the file of uniforms.
    pub fn setting<'a>(&'a self, uniforms: Option<UniformText<'a>>) -> ShotSetting<'a> {
        let cores = || std::thread::available_parallelism().map_or(1, usize::from);
        ShotSetting {
            size: self.size,
            threads: self.threads.map_or_else(cores, usize::from),
            pass: self.pass.as_deref(),
            show: self.show.as_ref(),
            uniforms,
            rays: match self.heatmap {
                Some(Heat::Slope) => ObservedRays::Camera,
                _ => ObservedRays::Nothing,
            },
            // Comparisons do not print the cost.
            watch: match self.compare.is_some() {
                true => Watch::Nothing,
                false if self.report || self.pixel.is_some() => Watch::Numbers,
                false => Watch::Flow,
            },
            trace: self.pixel.is_some(),
            decode: Some(decode),
        }
    }
}

/// Longest side of an image in pixels.
const MAX_SIDE: u32 = 16_384;
/// Maximum number of pixels of an image.
pub const MAX_PIXELS: u64 = 1 << 26;

/// Parses a size such as `640x360`.
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
pub fn time_of(text: &str) -> Result<f64, String> {
    let time = text.parse::<f64>().ok();
    let time = time.filter(|t| t.is_finite() && (0.0..1e9).contains(t));
    time.ok_or_else(|| "expected a time in seconds such as 2.5".to_string())
}

/// Parses a mouse position such as `320,180` or `320,180,down`.
fn mouse_of(text: &str) -> Result<Mouse, String> {
    let wrong = || "expected a position such as 320,180 or 320,180,down".to_string();
    let parts: Vec<&str> = text.split(',').map(str::trim).collect();
    let (x, y, button) = match parts[..] {
        [x, y] => (x, y, Button::Up),
        [x, y, "down"] => (x, y, Button::Down),
        _ => return Err(wrong()),
    };
    let lane = |text: &str| text.parse::<f64>().ok().filter(|n| n.is_finite());
    let at = [lane(x).ok_or_else(wrong)?, lane(y).ok_or_else(wrong)?];
    Ok(Mouse { at, button })
}

/// Parses a pixel such as `320,180`.
fn pixel_of(text: &str) -> Result<[u32; 2], String> {
    let side = |text: &str| text.trim().parse::<u32>().ok();
    let parts = text.split_once(',');
    let pixel = parts.and_then(|(x, y)| Some([side(x)?, side(y)?]));
    pixel.ok_or_else(|| "expected a pixel such as 320,180".to_string())
}

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
        assert_eq!((mouse.at, mouse.button), ([3.0, 4.5], Button::Down));
        assert!(mouse_of("3").is_err() && mouse_of("3,4,up").is_err());
        let show = show_of("d@42").map(|s| (s.name, s.line));
        assert_eq!(show, Ok(("d".to_string(), 42)));
        assert!(show_of("d").is_err() && show_of("@4").is_err() && show_of("d@0").is_err());
    }
}
