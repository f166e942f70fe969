//! The arguments of `shaderlint test`.

use super::super::run::{size_of, time_of};
use clap::ValueEnum;
use std::path::PathBuf;

/// Runs the functions `bool test_*()` of shaders and of the files NAME.test.glsl beside them, and
/// compares whole shaders with the pictures that were blessed: FILE.golden.png beside FILE.
#[derive(clap::Args, Debug)]
#[command(after_help = EXIT_CODES)]
pub struct TestArgs {
    /// Files and folders; no path is the current folder
    #[arg(value_name = "PATH")]
    pub paths: Vec<PathBuf>,
    /// Run only the tests with this in their names; `picture` is in those of pictures
    #[arg(long, value_name = "TEXT")]
    pub filter: Option<String>,
    /// human, json
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    #[arg(hide_possible_values = true)]
    pub format: TestFormat,

    /// Write the pictures that are missing or differ
    #[arg(long, help_heading = "Pictures")]
    pub bless: bool,
    /// Size of pictures whose shaders do not say it (`// golden: 320x180 at 0, 2.5`); without it that
    /// of the picture that is there, else 320x180
    #[arg(long, value_name = "WxH", value_parser = size_of, help_heading = "Pictures")]
    pub size: Option<[u32; 2]>,
    /// Seconds since the start of pictures whose shaders do not say it
    #[arg(long, value_name = "T,T", default_value = "0", value_delimiter = ',')]
    #[arg(value_parser = time_of, help_heading = "Pictures")]
    pub times: Vec<f64>,
    /// How many percent of the pixels may visibly differ
    #[arg(long, value_name = "PERCENT", default_value = "0.1", value_parser = percent_of)]
    #[arg(help_heading = "Pictures")]
    pub tolerance: f64,
    /// Draw where pictures differ: FILE.golden.diff.png
    #[arg(long, help_heading = "Pictures")]
    pub diff: bool,
    /// Write over such drawings that are there already
    #[arg(long, requires = "diff", help_heading = "Pictures")]
    pub force: bool,
}

const EXIT_CODES: &str = "\
Exit codes: 0 all pass, 1 some fail, 2 wrong use, unreadable input or nothing to test";

/// The values of `--format`.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, ValueEnum)]
pub enum TestFormat {
    /// A line a test, then what failed
    #[default]
    Human,
    /// One JSON object
    Json,
}

/// A share in percent.
fn percent_of(text: &str) -> Result<f64, String> {
    let share = text.trim_end_matches('%').trim().parse::<f64>().ok();
    let share = share.filter(|p| (0.0..=100.0).contains(p));
    share.ok_or_else(|| "write percent like 0.1".to_string())
}
