//! The commands: arguments, files, exit codes; and the language server. The only place that touches
//! the outside.
#![expect(
    clippy::disallowed_methods,
    reason = "what the rest of the house may not touch is touched here"
)]

mod config;
mod disk;
mod fmt;
mod input;
mod lint;
#[cfg(feature = "lsp")]
mod lsp;
#[cfg(feature = "mcp")]
mod mcp;
mod output;
mod parallel;
mod port;
mod run;
mod test;
mod watch;

use clap::Parser;
use std::process::ExitCode;

/// Everything is well, or only below the threshold.
const CLEAN: u8 = 0;
/// There are findings at or above the threshold.
const FINDINGS: u8 = 1;
/// The command was used wrongly, or something could not be read or written.
const FAILED: u8 = 2;

/// Stack of a thread that reads shaders, in bytes. What nests is bounded, so that this is enough in
/// debug builds too; what a system gives by itself differs, down to 1 MB.
pub const STACK: usize = 16 << 20;

/// Runs `shaderlint` with the arguments of the process.
pub fn shaderlint() -> ExitCode {
    with_stack(|| lint::run(&lint::LintArgs::parse()))
}

/// Runs `shaderport` with the arguments of the process.
pub fn shaderport() -> ExitCode {
    with_stack(|| port::run(&port::PortArgs::parse()))
}

/// Runs a program on a thread with [`STACK`].
fn with_stack(program: fn() -> u8) -> ExitCode {
    let thread = std::thread::Builder::new().stack_size(STACK).spawn(program);
    match thread.map(std::thread::JoinHandle::join) {
        Ok(Ok(code)) => ExitCode::from(code),
        Ok(Err(_)) => ExitCode::from(FAILED),
        Err(error) => {
            eprintln!("error: no thread can be started: {error}");
            ExitCode::from(FAILED)
        }
    }
}
