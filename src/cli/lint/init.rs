//! `init`: writes a configuration to start from.

use super::super::command::{CLEAN, FAILED, complain};
use crate::engine::config::FILE;
use std::fs::OpenOptions;
use std::io::{self, Write};

/// The configuration, which changes nothing until it is edited.
const TEXT: &str = include_str!("init.toml");

/// Writes the configuration to the current folder, and returns the exit code. An existing file is kept.
///
/// # Errors
/// If the file cannot be written.
pub fn run() -> io::Result<u8> {
    let file = OpenOptions::new().write(true).create_new(true).open(FILE);
    match file {
        Ok(mut file) => file.write_all(TEXT.as_bytes())?,
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
            complain(&format!("{FILE} exists already; it was not changed"));
            return Ok(FAILED);
        }
        Err(error) => return Err(io::Error::new(error.kind(), format!("{FILE}: {error}"))),
    }
    writeln!(io::stdout().lock(), "Created {FILE}")?;
    Ok(CLEAN)
}

#[cfg(test)]
mod tests {
    use super::TEXT;
    use crate::engine::config::parse;

    #[test]
    fn the_generated_configuration_is_valid() {
        assert!(parse(TEXT).is_ok());
    }
}
