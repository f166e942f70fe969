//! `shaderlint test`: runs tests written in GLSL, and compares shaders with their golden images.

mod args;
mod baseline;
mod coverage;
mod difference;
mod file;
mod functions;
mod golden;
mod inputs;
mod junit;
mod outcome;
mod session;
mod tap;
mod textures;
mod watch;

pub use args::TestArgs;

use session::Session;
use std::io::{self, Write};

/// Suffix of the name of a file that tests another: `NAME.test.glsl`.
const TESTS: &str = ".test";

/// Runs the command and gives the exit code.
pub fn run(args: &TestArgs) -> io::Result<u8> {
    match args.watch {
        true => watch::run(args),
        false => Session::default().run(args),
    }
}

fn complain(message: &str) {
    print_message(&format!("shaderlint: {message}"));
}

fn print_message(message: &str) {
    let _ = writeln!(io::stderr(), "{message}");
}
