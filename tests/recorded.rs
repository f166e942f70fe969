//! Files that the tests generate: `INSTA_UPDATE=always cargo test` writes them, as it does snapshots.

use std::fs;
use std::path::Path;

/// Whether generated files are to be written.
pub fn accepts() -> bool {
    std::env::var("INSTA_UPDATE").is_ok_and(|v| v == "always")
}

/// Compares a generated file with its expected content and writes it if asked to. Returns a message
/// with that content if the file differed.
#[must_use]
pub fn stale(path: &Path, expected: &str) -> Option<String> {
    if fs::read_to_string(path).is_ok_and(|now| now == expected) {
        return None;
    }
    if accepts() {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, expected).unwrap();
    }
    Some(format!(
        "{} is out of date; expected\n{expected}",
        path.display()
    ))
}
