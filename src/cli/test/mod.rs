//! `shaderlint test`: runs tests written in GLSL, and compares shaders with their golden images.

mod args;
mod coverage;
mod difference;
mod file;
mod functions;
mod golden;
mod inputs;
mod junit;
mod outcome;
mod session;
mod shared;
mod textures;
mod watch;

pub use args::TestArgs;

use session::TestSession;
use std::io;

/// Runs the command and gives the exit code.
pub fn run(args: &TestArgs) -> io::Result<u8> {
    match args.watch {
        true => watch::run(args),
        false => TestSession::default().run(args),
    }
}
