//! Exit codes of all commands, and messages on standard error.

use std::io::{self, Write};

/// Success: nothing at or above the threshold.
pub const CLEAN: u8 = 0;
/// Findings at or above the threshold.
pub const FINDINGS: u8 = 1;
/// Wrong usage, or a file that cannot be read or written.
pub const FAILED: u8 = 2;

/// Prints a message on standard error.
pub fn complain(message: &str) {
    let _ = writeln!(io::stderr(), "shaderlint: {message}");
}
