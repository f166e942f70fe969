//! The arguments of `shaderlint run`.

use crate::cli::command::TextOrJson;
use crate::cli::image_file::decode;
use crate::cli::input::requests;
use crate::commands::run::{InputRequest, MAX_PIXELS, RunFront, RunRequest, UniformText};
use std::path::PathBuf;

/// Run a shader on the CPU and show its image and statistics.
///
/// Draws one frame as WebGL2 would, without a GPU.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = EXIT_CODES)]
pub struct RunArgs {
    /// Fragment shader, ShaderToy pass or ShaderToy export (.json); `-` reads standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Who completes the shader
    #[command(flatten)]
    pub input: InputRequest,
    /// JSON file with an object of uniform values
    ///
    /// Values are numbers, booleans, arrays of these (matrices in column order) and objects for
    /// structs.
    #[arg(long, value_name = "FILE", help_heading = "Input")]
    pub uniforms: Option<PathBuf>,
    /// What is drawn
    #[command(flatten)]
    pub request: RunRequest,
    /// JSON file with both, as the MCP server writes it
    #[arg(long, value_name = "FILE", hide = true)]
    pub asked: Option<PathBuf>,

    /// Compare with another shader bit for bit; exit with code 1 if they differ
    #[arg(long, value_name = "OTHER", help_heading = "Analysis")]
    #[arg(conflicts_with_all = ["heatmap", "show", "pixel", "sheet"])]
    pub compare: Option<PathBuf>,

    /// PNG file to write; default: show the image in the terminal
    #[arg(short, long, value_name = "OUT.png", help_heading = OUTPUT)]
    #[arg(conflicts_with = "pixel")]
    pub output: Option<PathBuf>,
    /// Overwrite existing files
    #[arg(long, help_heading = OUTPUT)]
    pub force: bool,
    /// Output format: human, json
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    #[arg(help_heading = OUTPUT, hide_possible_values = true)]
    pub format: TextOrJson,
    /// Number of threads; default: one per core
    #[arg(long, value_name = "N", help_heading = OUTPUT)]
    #[arg(value_parser = clap::value_parser!(u16).range(1..=256))]
    pub threads: Option<u16>,
}

const OUTPUT: &str = "Output";

const EXIT_CODES: &str = "\
Exit codes:
  0  The shader was drawn
  1  The shader has errors, or --compare found a difference
  2  Wrong usage, or a file cannot be read or written";

impl RunArgs {
    /// The arguments with the request of a file, if one is named.
    pub fn completed(mut self) -> Result<RunArgs, String> {
        if let Some(path) = &self.asked {
            (self.input, self.request) = requests(path)?;
        }
        Ok(self)
    }

    /// What every run on the command line has. `uniforms` is the text of the file of uniforms.
    pub fn front<'a>(&self, uniforms: Option<UniformText<'a>>) -> RunFront<'a> {
        let cores = || std::thread::available_parallelism().map_or(1, usize::from);
        RunFront {
            size: [640, 360],
            max_pixels: 100 * MAX_PIXELS,
            threads: self.threads.map_or_else(cores, usize::from),
            decode: Some(decode),
            uniforms,
        }
    }
}
