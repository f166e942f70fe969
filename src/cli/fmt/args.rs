//! The arguments of `shaderlint fmt`.

use crate::commands::FormatRequest;
use crate::engine::config::{ConfigArgs, Exclusion};
use clap::Parser;
use std::path::PathBuf;

/// Format shaders; only white space changes.
///
/// Tokens and comments are never changed. Three settings in `shaderlint.toml` (`format.indent`,
/// `format.width`, `format.brace`), their equivalents in `.editorconfig` or the options here control the
/// style.
#[derive(Parser, Debug)]
#[command(after_help = "\
Exit codes:
  0  All files are formatted
  1  With --check: some files are not formatted
  2  Wrong usage, unreadable input or unmatched brackets")]
pub struct FormatArgs {
    /// Files or folders to format, or `-` for standard input [default: the current folder]
    #[arg(value_name = "PATH", default_value = ".", hide_default_value = true)]
    pub paths: Vec<PathBuf>,
    /// List the files that are not formatted, without writing them
    #[arg(long, help_heading = "Output")]
    pub check: bool,
    /// Show the changes as a diff without writing files
    #[arg(long, help_heading = "Output")]
    pub diff: bool,
    /// The style
    #[command(flatten)]
    pub request: FormatRequest,
    /// Apply the `exclude` setting to files named on the command line too
    #[arg(long, help_heading = "Files")]
    pub force_exclude: bool,
    /// File name to use for standard input; selects the kind of file and the configuration
    #[arg(long, value_name = "NAME", help_heading = "Files")]
    pub stdin_filename: Option<String>,
}

impl FormatArgs {
    /// The options that concern configuration files.
    pub fn asked(&self) -> ConfigArgs {
        ConfigArgs {
            exclusion: match self.force_exclude {
                true => Exclusion::Named,
                false => Exclusion::Found,
            },
            paths: self.paths.clone(),
            ..ConfigArgs::default()
        }
    }
}
