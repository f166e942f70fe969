//! The arguments of `shaderlint fmt`.

use crate::engine::config::{ConfigArgs, ConfigSource, Exclusion, Selection};
use clap::Parser;
use std::path::PathBuf;

/// Format shaders; only white space changes.
///
/// Tokens and comments are never changed. Three settings in `shaderlint.toml` (`format.indent`,
/// `format.width`, `format.brace`) or their equivalents in `.editorconfig` control the style.
#[derive(Parser, Debug)]
#[command(after_help = "\
Exit codes:
  0  All files are formatted
  1  With --check: some files are not formatted
  2  Wrong usage, unreadable input or unmatched brackets")]
pub struct FormatArgs {
    /// Files or folders to format, or `-` for standard input [default: the current folder]
    #[arg(value_name = "PATH")]
    pub paths: Vec<PathBuf>,
    /// List the files that are not formatted, without writing them
    #[arg(long, help_heading = "Output")]
    pub check: bool,
    /// Show the changes as a diff without writing files
    #[arg(long, help_heading = "Output")]
    pub diff: bool,
    /// Configuration file to use instead of the nearest shaderlint.toml above each file
    #[arg(long, value_name = "FILE", conflicts_with = "no_config")]
    #[arg(help_heading = "Configuration")]
    pub config: Option<PathBuf>,
    /// Ignore all configuration files except .editorconfig
    #[arg(long, help_heading = "Configuration")]
    pub no_config: bool,
    /// Apply the `exclude` setting to files named on the command line too
    #[arg(long, help_heading = "Files")]
    pub force_exclude: bool,
    /// File name to use for standard input; selects the kind of file and the configuration
    #[arg(long, value_name = "NAME", help_heading = "Files")]
    pub stdin_filename: Option<String>,
    /// Print errors only
    #[arg(short, long, help_heading = "Output")]
    pub quiet: bool,
}

impl FormatArgs {
    /// The options that concern configuration files.
    pub fn asked(&self) -> ConfigArgs {
        ConfigArgs {
            given: Selection::default(),
            source: match &self.config {
                Some(file) => ConfigSource::File(file.clone()),
                None if self.no_config => ConfigSource::Nowhere,
                None => ConfigSource::Nearest,
            },
            exclusion: match self.force_exclude {
                true => Exclusion::Named,
                false => Exclusion::Found,
            },
            paths: self.paths(),
        }
    }

    /// The paths to format; the current folder if none are given.
    pub fn paths(&self) -> Vec<PathBuf> {
        match self.paths.as_slice() {
            [] => vec![PathBuf::from(".")],
            paths => paths.to_vec(),
        }
    }
}
