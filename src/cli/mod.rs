//! The commands: arguments, files, exit codes. Together with `lsp` the only place that touches the
//! outside.

pub mod config;
pub mod document;
pub mod input;
mod lint;
mod output;
mod port;

use clap::Parser;
use std::process::ExitCode;

/// Everything is well, or only below the threshold.
const CLEAN: u8 = 0;
/// There are findings at or above the threshold.
const FINDINGS: u8 = 1;
/// The command was used wrongly, or something could not be read or written.
const FAILED: u8 = 2;

/// Runs `shaderlint` with the arguments of the process.
pub fn shaderlint() -> ExitCode {
    ExitCode::from(lint::run(&lint::Args::parse()))
}

/// Runs `shaderport` with the arguments of the process.
pub fn shaderport() -> ExitCode {
    ExitCode::from(port::run(&port::Args::parse()))
}
