//! `shaderport`.

use clap::Parser;

/// Turns ShaderToy code into WebGL2.
#[derive(Parser, Debug)]
#[command(name = "shaderport", version, about, max_term_width = 100)]
pub struct Args {}

/// Runs the converter and gives the exit code.
pub fn run(_args: &Args) -> u8 {
    super::CLEAN
}
