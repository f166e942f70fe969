//! The arguments of `shaderlint run`.

use super::super::color::ColorChoice;
use crate::engine::play::{Button, Moment, Mouse};
use crate::exec::Watch;
use clap::ValueEnum;
use std::path::{Path, PathBuf};

/// Draws a shader without a GPU, as WebGL2 would, and says what was seen.
#[derive(clap::Args, Debug)]
pub struct RunArgs {
    /// A fragment shader, a pass of ShaderToy or an export (.json); `-` is standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Size of the picture in pixels
    #[arg(long, value_name = "WxH", default_value = "640x360", value_parser = size_of)]
    #[arg(help_heading = "Moment")]
    pub size: [u32; 2],
    /// Seconds since the start; the frame is the one of that time, at 60 a second
    #[arg(long, value_name = "T", value_parser = time_of, help_heading = "Moment")]
    pub time: Option<f64>,
    /// Number of the frame, from 0
    #[arg(long, value_name = "N", help_heading = "Moment")]
    pub frame: Option<u32>,
    /// Where the mouse was last with its button down, in pixels from the left and from below; `,down`
    /// holds it
    #[arg(long, value_name = "X,Y[,down]", value_parser = mouse_of, help_heading = "Moment")]
    pub mouse: Option<Mouse>,
    /// JSON object of uniforms: numbers, booleans, arrays of them (matrices by columns), objects for
    /// structs
    #[arg(long, value_name = "FILE", help_heading = "Moment")]
    pub uniforms: Option<PathBuf>,
    /// Who runs the code, like `shadertoy`, `glsl-sandbox` or `isf`, or a file that describes one; without
    /// it the configuration or the code tells
    #[arg(
        long,
        value_name = "NAME",
        visible_alias = "from",
        help_heading = "Moment"
    )]
    pub host: Option<String>,
    /// What a channel reads, like `0=photo.jpg`, `image.1=keyboard`, `buffer_a.0=buffer_a` or, by the
    /// name of a sampler, `u_tex0=photo.png`; behind it may stand how, like `,nearest,clamp,noflip`
    #[arg(long, value_name = "[PASS.]N=SOURCE", help_heading = "Moment")]
    pub channel: Vec<String>,
    /// The pass to show, like `image` or `buffer_a`
    #[arg(long, value_name = "PASS", help_heading = "Moment")]
    pub pass: Option<String>,

    /// The PNG to write; without it the picture is drawn in the terminal
    #[arg(short, long, value_name = "OUT.png", help_heading = "Output")]
    pub output: Option<PathBuf>,
    /// Write over a file that is there already
    #[arg(long, help_heading = "Output")]
    pub force: bool,
    /// Draw how much work each pixel is (steps, cost), which share of the work of its 8x4 pixels it
    /// only waits for (overdraw), or where numbers are not finite (nan)
    #[arg(long, value_enum, value_name = "WHAT", help_heading = "Output")]
    #[arg(hide_possible_values = true)]
    pub heatmap: Option<Heat>,
    /// Draw a variable as it is on a line, like `d@42`; the last time that the line is run counts
    #[arg(long, value_name = "NAME@LINE", value_parser = show_of, help_heading = "Output")]
    #[arg(conflicts_with_all = ["heatmap", "compare"])]
    pub show: Option<Show>,
    /// Draw so many pictures on one sheet, from --time on
    #[arg(long, value_name = "N", num_args = 0..=1, default_missing_value = "9")]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=100), help_heading = "Output")]
    #[arg(conflicts_with_all = ["heatmap", "compare", "frame"])]
    pub sheet: Option<u32>,
    /// Seconds between two pictures of a sheet
    #[arg(long, value_name = "T", default_value = "1", value_parser = time_of)]
    #[arg(help_heading = "Output")]
    pub every: f64,
    /// Say of each loop how often it may turn and how often it did, what each function cost, and where
    /// numbers went wrong
    #[arg(long, help_heading = "Output")]
    pub report: bool,
    /// Compare the pictures with those of another shader, bit for bit; exits with 1 where they differ
    #[arg(long, value_name = "OTHER", help_heading = "Output")]
    #[arg(conflicts_with = "heatmap")]
    pub compare: Option<PathBuf>,
    /// human, json
    #[arg(
        long,
        value_enum,
        default_value_t,
        value_name = "FORMAT",
        help_heading = "Output"
    )]
    #[arg(hide_possible_values = true)]
    pub format: RunFormat,
    /// When to print in colour: auto, always, never
    #[arg(
        long,
        value_enum,
        default_value_t,
        value_name = "WHEN",
        help_heading = "Output"
    )]
    #[arg(hide_possible_values = true)]
    pub color: ColorChoice,
    /// How many threads draw; as many as there are cores without it
    #[arg(long, value_name = "N", help_heading = "Output")]
    #[arg(value_parser = clap::value_parser!(u16).range(1..=256))]
    pub threads: Option<u16>,
}

/// A variable, and a line.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Show {
    /// Its name.
    pub name: String,
    /// The line, from 1.
    pub line: u32,
}

/// What a heat map shows of each pixel.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum Heat {
    /// Turns of loops
    Steps,
    /// Operations
    Cost,
    /// The share of the work of its group of pixels that it has no part in
    Overdraw,
    /// Numbers that are not finite
    Nan,
}

/// The values of `--format`.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, ValueEnum)]
pub enum RunFormat {
    /// For people
    #[default]
    Human,
    /// One JSON object
    Json,
}

impl RunArgs {
    /// The moment that is asked for.
    pub fn moment(&self) -> Moment {
        let moment = match (self.time, self.frame) {
            (Some(time), None) => Moment::at(time),
            (None, frame) => Moment::of_frame(frame.unwrap_or(0)),
            (Some(time), Some(frame)) => Moment {
                frame,
                ..Moment::at(time)
            },
        };
        Moment {
            mouse: self.mouse,
            ..moment
        }
    }

    /// What is drawn, and how.
    pub fn setting(&self) -> ShotSetting<'_> {
        let cores = || std::thread::available_parallelism().map_or(1, usize::from);
        ShotSetting {
            size: self.size,
            threads: self.threads.map_or_else(cores, usize::from),
            pass: self.pass.as_deref(),
            show: self.show.as_ref(),
            uniforms: self.uniforms.as_deref(),
            // Nobody asks for the cost of pictures that are only compared, or put on a sheet.
            watch: match self.compare.is_some() || self.sheet.is_some() {
                true => Watch::Nothing,
                false if self.report => Watch::Numbers,
                false => Watch::Flow,
            },
        }
    }
}

/// What is drawn of a shader, and how.
pub struct ShotSetting<'a> {
    /// Size of the picture in pixels.
    pub size: [u32; 2],
    /// How many threads draw.
    pub threads: usize,
    /// The pass to show; without it the picture.
    pub pass: Option<&'a str>,
    /// A variable of a line.
    pub show: Option<&'a Show>,
    /// A file with what uniforms are set to.
    pub uniforms: Option<&'a Path>,
    /// What is watched.
    pub watch: Watch,
}

/// Longest side of a picture.
const MAX_SIDE: u32 = 16_384;
/// Most pixels of a picture.
pub const MAX_PIXELS: u64 = 1 << 26;

/// A size like `640x360`.
pub fn size_of(text: &str) -> Result<[u32; 2], String> {
    let side = |text: &str| text.trim().parse::<u32>().ok().filter(|n| *n > 0);
    let (width, height) = text.split_once(['x', 'X']).ok_or(SIZE)?;
    let (width, height) = (side(width).ok_or(SIZE)?, side(height).ok_or(SIZE)?);
    let pixels = u64::from(width) * u64::from(height);
    if width.max(height) > MAX_SIDE || pixels > MAX_PIXELS {
        return Err(format!(
            "at most {MAX_SIDE} pixels a side and {MAX_PIXELS} in all"
        ));
    }
    Ok([width, height])
}

const SIZE: &str = "write a size like 640x360";

/// Seconds.
pub fn time_of(text: &str) -> Result<f64, String> {
    let time = text.parse::<f64>().ok();
    let time = time.filter(|t| t.is_finite() && (0.0..1e9).contains(t));
    time.ok_or_else(|| "write seconds like 2.5".to_string())
}

/// A place like `320,180` or `320,180,down`.
fn mouse_of(text: &str) -> Result<Mouse, String> {
    let wrong = || "write a place like 320,180 or 320,180,down".to_string();
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

/// A variable like `d@42`.
fn show_of(text: &str) -> Result<Show, String> {
    let parts = text.rsplit_once('@');
    let show = parts.and_then(|(name, line)| {
        let line = line.trim().parse().ok().filter(|line| *line > 0)?;
        let name = name.trim().to_string();
        (!name.is_empty()).then_some(Show { name, line })
    });
    show.ok_or_else(|| "write a name and a line like d@42".to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_places_and_times() {
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
