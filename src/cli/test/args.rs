//! The arguments of `shaderlint test`.

use super::coverage::CoverageFormat;
use crate::commands::run::{size_of, time_of};
use clap::ValueEnum;
use std::path::PathBuf;

/// Run tests written in GLSL and compare shaders with their golden images.
///
/// A test is a function `bool test_*()` in a shader or in NAME.test.glsl next to it. A complete
/// shader FILE is compared with the golden image FILE.golden.png.
#[derive(clap::Args, Debug)]
#[command(after_help = AFTER)]
pub struct TestArgs {
    /// Files or folders to test [default: the current folder]
    #[arg(value_name = "PATH", default_value = ".", hide_default_value = true)]
    pub paths: Vec<PathBuf>,
    /// Run only tests whose name contains TEXT; image comparisons contain `golden`
    #[arg(long, value_name = "TEXT")]
    pub filter: Option<String>,
    /// Number of cases of a test with random values: `// any: x in -10..10`
    #[arg(long, value_name = "N", default_value_t = 1000)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub cases: u32,
    /// Seed of random values
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u32,
    /// Test again what a change touches, until stopped
    #[arg(long)]
    pub watch: bool,
    /// Output format: human, json, junit
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    #[arg(hide_possible_values = true)]
    pub format: TestFormat,

    /// Also run functions `bench_*`, and print the operations of each test
    #[arg(long)]
    pub bench: bool,

    /// Write which lines and branches of the files under test ran
    #[arg(long, value_name = "FILE", help_heading = COVERAGE)]
    pub coverage: Option<PathBuf>,
    /// Format of the coverage: lcov, json; default: by the extension of FILE, or lcov
    #[arg(long, value_enum, value_name = "FORMAT", requires = "coverage")]
    #[arg(hide_possible_values = true, help_heading = COVERAGE)]
    pub coverage_format: Option<CoverageFormat>,

    /// Write golden images that are missing or differ
    #[arg(long, help_heading = GOLDEN)]
    pub bless: bool,
    /// Size of golden images, unless a comment in the shader sets it: `// golden: 320x180 at 0, 2.5`
    ///
    /// Default: the size of the existing golden image, or 320x180.
    #[arg(long, value_name = "WxH", value_parser = size_of, help_heading = GOLDEN)]
    pub size: Option<[u32; 2]>,
    /// Times of golden images in seconds, unless a comment in the shader sets them
    #[arg(long, value_name = "T,T", default_value = "0", value_delimiter = ',')]
    #[arg(value_parser = time_of, help_heading = GOLDEN)]
    pub times: Vec<f64>,
    /// Percentage of pixels that may differ visibly
    #[arg(long, value_name = "PERCENT", default_value = "0.1", value_parser = percent_of)]
    #[arg(help_heading = GOLDEN)]
    pub tolerance: f64,
    /// Write an image of the differences to FILE.golden.diff.png
    #[arg(long, help_heading = GOLDEN)]
    pub diff: bool,
    /// Overwrite existing difference images
    #[arg(long, requires = "diff", help_heading = GOLDEN)]
    pub force: bool,
}

const COVERAGE: &str = "Coverage";
const GOLDEN: &str = "Golden images";

const AFTER: &str = "\
Comments above a test:
  // each: x = 0.0, 0.5      Values of a parameter; each combination is a test
  // any: x in -10..10       Random values of a parameter
  // fails: REASON           The test is expected to fail
  // texture: NAME = FILE    Texture of a sampler: an image, or `buffer_a at frame 3`

Exit codes:
  0  All tests pass
  1  Some tests fail
  2  Wrong usage, unreadable input or no tests found";

/// The values of `--format`.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, ValueEnum)]
pub enum TestFormat {
    /// One line per test, then the failures
    #[default]
    Human,
    /// One JSON object
    Json,
    /// JUnit XML
    Junit,
}

/// Parses a percentage, with or without `%`.
fn percent_of(text: &str) -> Result<f64, String> {
    let share = text.trim_end_matches('%').trim().parse::<f64>().ok();
    let share = share.filter(|p| (0.0..=100.0).contains(p));
    share.ok_or_else(|| "expected a percentage such as 0.1".to_string())
}
