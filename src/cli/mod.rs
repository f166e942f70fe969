//! The commands: arguments, files, exit codes; and the language server. The only place that touches
//! the outside.
#![expect(
    clippy::disallowed_methods,
    reason = "what the rest of the house may not touch is touched here"
)]

mod color;
mod command;
mod config;
mod disk;
mod dispatch;
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

pub use parallel::STACK;

use clap::Parser;
use command::FAILED;
use std::process::ExitCode;

/// Runs `shaderlint` with the arguments of the process.
pub fn shaderlint() -> ExitCode {
    with_stack(|| dispatch::run(&lint::LintArgs::parse()))
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
