//! `shaderlint` without a command, which checks files once or on each change, and the commands
//! about rules and shaders.

mod args;
mod baseline;
mod check;
pub mod explain;
mod fix;
mod inputs;
pub mod ir;
pub mod reduce;
mod verbose;
mod watch;

pub use args::{Command, LintArgs};

use std::io;

/// Checks what the arguments name, and gives the exit code.
pub fn run(args: &LintArgs) -> io::Result<u8> {
    match args.watch {
        true => watch::run(args),
        false => check::check(args),
    }
}
