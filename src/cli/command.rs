//! What every command has in common: its exit codes, and how it says what went wrong.

use std::io::{self, Write};

/// Everything is well, or only below the threshold.
pub const CLEAN: u8 = 0;
/// There are findings at or above the threshold.
pub const FINDINGS: u8 = 1;
/// The command was used wrongly, or something could not be read or written.
pub const FAILED: u8 = 2;

/// Says something to whoever started `shaderlint`, beside what it prints.
pub fn complain(message: &str) {
    let _ = writeln!(io::stderr(), "shaderlint: {message}");
}
