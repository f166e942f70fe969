//! The command-line programs and the language server: arguments, files, exit codes. The only module
//! that accesses the file system, the environment and the standard streams.
#![expect(
    clippy::disallowed_methods,
    reason = "this module implements file access for the others"
)]

mod color;
mod command;
mod config;
#[cfg(feature = "dap")]
mod dap;
mod disk;
mod dispatch;
mod evidence;
mod fmt;
#[cfg(any(feature = "dap", feature = "lsp"))]
mod framing;
mod global;
mod image_file;
mod inflate;
mod input;
mod lint;
#[cfg(feature = "lsp")]
mod lsp;
#[cfg(feature = "mcp")]
mod mcp;
mod output;
mod parallel;
mod port;
mod progress;
mod run;
mod test;
mod types;
mod usage;
mod watch;

pub use dispatch::described;
pub use lint::ProgramName;
pub use parallel::STACK;

use clap::Parser;
use command::FAILED;
use std::process::ExitCode;

/// Runs `shaderlint` with the arguments of the process.
pub fn shaderlint() -> ExitCode {
    with_stack(|args: lint::LintArgs| dispatch::run(&args))
}

/// Runs `shaderport` with the arguments of the process.
pub fn shaderport() -> ExitCode {
    with_stack(|args: port::PortArgs| port::run(&args))
}

/// Runs a program with its arguments on a thread with [`STACK`].
fn with_stack<P: Parser + 'static>(program: fn(P) -> u8) -> ExitCode {
    let whole = move || usage::read(std::env::args_os()).map_or_else(|code| code, program);
    let thread = std::thread::Builder::new().stack_size(STACK).spawn(whole);
    match thread.map(std::thread::JoinHandle::join) {
        Ok(Ok(code)) => ExitCode::from(code),
        Ok(Err(_)) => ExitCode::from(FAILED),
        Err(error) => {
            eprintln!("error: cannot start a thread: {error}");
            ExitCode::from(FAILED)
        }
    }
}
