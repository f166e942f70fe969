//! Exit codes of all commands, and messages on standard error.

use super::global::{Talk, given};
use clap::ValueEnum;
use std::io::{self, Write};

/// Success: nothing at or above the threshold.
pub const CLEAN: u8 = 0;
/// Findings at or above the threshold.
pub const FINDINGS: u8 = 1;
/// Wrong usage, or a file that cannot be read or written.
pub const FAILED: u8 = 2;

/// The values of `--format` of commands for people and programs.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, ValueEnum)]
pub enum TextOrJson {
    /// Text
    #[default]
    Human,
    /// One JSON object
    Json,
}

/// Prints a message on standard error, unless `-qq` is given.
pub fn complain(message: &str) {
    if given().talk() > Talk::Nothing {
        let _ = writeln!(io::stderr(), "shaderlint: {message}");
    }
}
