//! The options of all commands of `shaderlint`.

use super::color::ColorChoice;
use crate::engine::config::ConfigSource;
use clap::{ArgAction, Args};
use std::path::PathBuf;
use std::sync::OnceLock;

/// The options of all commands, before or after their names.
#[derive(Args, Clone, Default, Debug)]
#[command(next_help_heading = "Global options")]
pub struct GlobalArgs {
    /// Show how each file was interpreted and what was skipped
    #[arg(short, long, global = true, conflicts_with = "quiet")]
    pub verbose: bool,
    /// Print findings without a summary; -qq prints nothing
    #[arg(short, long, global = true, action = ArgAction::Count)]
    pub quiet: u8,
    /// When to use colours: auto, always, never
    #[arg(long, global = true, value_enum, default_value_t, value_name = "WHEN")]
    #[arg(hide_possible_values = true)]
    pub color: ColorChoice,
    /// Configuration file to use instead of the nearest shaderlint.toml above each file
    #[arg(long, global = true, value_name = "FILE", conflicts_with = "no_config")]
    pub config: Option<PathBuf>,
    /// Ignore all configuration files
    #[arg(long, global = true)]
    pub no_config: bool,
}

/// Verbosity of the output.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Talk {
    /// `-qq`: the exit code only.
    Nothing,
    /// `-q`: findings without a summary.
    Findings,
    /// Findings and a summary.
    Normal,
    /// `-v`: also how each file was interpreted and what was skipped.
    Verbose,
}

/// Set once, when the arguments have been read. Configurations are looked up far from them.
static GIVEN: OnceLock<GlobalArgs> = OnceLock::new();

/// The options of this process.
pub fn given() -> &'static GlobalArgs {
    GIVEN.get_or_init(GlobalArgs::default)
}

impl GlobalArgs {
    /// Makes these the options of this process.
    pub fn apply(&self) {
        GIVEN.get_or_init(|| self.clone());
    }

    /// The verbosity that `-v` and `-q` select.
    pub fn talk(&self) -> Talk {
        match (self.verbose, self.quiet) {
            (true, _) => Talk::Verbose,
            (false, 0) => Talk::Normal,
            (false, 1) => Talk::Findings,
            (false, _) => Talk::Nothing,
        }
    }

    /// Where configurations are read from.
    pub fn source(&self) -> ConfigSource {
        match &self.config {
            Some(file) => ConfigSource::File(file.clone()),
            None if self.no_config => ConfigSource::Nowhere,
            None => ConfigSource::Nearest,
        }
    }
}
