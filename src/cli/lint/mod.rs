//! `shaderlint` without a command, which checks files once or on each change, and the commands
//! about rules and shaders.

mod args;
mod baseline;
mod cache;
mod check;
mod fix;
pub mod init;
mod inputs;
pub mod ir;
pub mod reduce;
mod verbose;
mod watch;

pub use args::{CheckArgs, Command, LintArgs, ProgramName};

use super::command::{FAILED, complain};
use std::io;

/// Checks what the arguments name, and gives the exit code.
pub fn run(args: &CheckArgs) -> io::Result<u8> {
    match &args.clone().completed() {
        Ok(args) if args.watch => watch::run(args),
        Ok(args) => check::check(args),
        Err(message) => {
            complain(message);
            Ok(FAILED)
        }
    }
}
