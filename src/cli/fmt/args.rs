//! The arguments of `shaderlint fmt`.

use super::super::config::{ConfigArgs, Exclusion, Source};
use crate::engine::config::Selection;
use clap::Parser;
use std::path::PathBuf;

/// Sets the code of shaders in one style. Only white space changes; tokens and comments stay as they
/// are. Three things can be chosen, in `shaderlint.toml` or `.editorconfig`: `format.indent`,
/// `format.width` and `format.brace`.
#[derive(Parser, Debug)]
#[command(after_help = "\
Exit codes: 0 all is formatted, 1 with --check where something is not, 2 wrong use, unreadable input
or brackets that do not match")]
pub struct FormatArgs {
    /// Files and folders to format; `-` is standard input, no path the current folder
    #[arg(value_name = "PATH")]
    pub paths: Vec<PathBuf>,
    /// Write nothing; name the files that are not formatted, with the first line that differs
    #[arg(long)]
    pub check: bool,
    /// Write nothing; print what would change
    #[arg(long)]
    pub diff: bool,
    /// The configuration, in place of the nearest shaderlint.toml above each file
    #[arg(long, value_name = "FILE", conflicts_with = "no_config")]
    pub config: Option<PathBuf>,
    /// Take no configuration but .editorconfig
    #[arg(long)]
    pub no_config: bool,
    /// Leave out what the configuration excludes even where it is named, as hooks name files
    #[arg(long)]
    pub force_exclude: bool,
    /// Name of standard input; its ending tells what it is, its folder how it is set
    #[arg(long, value_name = "NAME")]
    pub stdin_filename: Option<String>,
    /// Say nothing but what is wrong
    #[arg(short, long)]
    pub quiet: bool,
}

impl FormatArgs {
    /// What is said of configurations.
    pub fn asked(&self) -> ConfigArgs {
        ConfigArgs {
            given: Selection::default(),
            source: match &self.config {
                Some(file) => Source::File(file.clone()),
                None if self.no_config => Source::Nowhere,
                None => Source::Nearest,
            },
            exclusion: match self.force_exclude {
                true => Exclusion::Named,
                false => Exclusion::Found,
            },
            paths: self.paths(),
        }
    }

    /// The paths to format.
    pub fn paths(&self) -> Vec<PathBuf> {
        match self.paths.as_slice() {
            [] => vec![PathBuf::from(".")],
            paths => paths.to_vec(),
        }
    }
}
