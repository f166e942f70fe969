//! `-v` of checks: how each file was interpreted, with which configuration, and what was skipped.

use super::super::command::complain;
use super::super::disk::Disk;
use super::super::evidence;
use super::super::input::{InputFile, PassedOver};
use crate::commands::{Recognition, reading};
use crate::diagnostic::count;
use crate::engine::Report;
use crate::engine::config::Configs;
use crate::lint::Proof;
use std::path::Path;

/// Reports how a file was interpreted, with its configuration file, and what was opened with it.
pub fn read(input: &InputFile, report: &Report, configs: &Configs) {
    let here = std::env::current_dir().unwrap_or_default();
    let config = match configs.file_of(Path::new(&input.name)) {
        Some(file) => format!("{}", file.strip_prefix(&here).unwrap_or(&file).display()),
        None => "no configuration".to_string(),
    };
    let options = configs.options(Path::new(&input.name)).unwrap_or_default();
    let recognition = match configs.names_host() {
        true => Recognition::Never,
        false => Recognition::Always,
    };
    let disk = &Disk::new();
    let read_as = reading(&input.name, report, (&options, disk), recognition).read_as;
    complain(&format!("{}: checked as {read_as}; {config}", input.name));
    let file = report.file.and_then(|id| report.sources.file(id));
    if let Some(file) = file {
        evidence::file(&input.name, &file.text, configs);
    }
}

/// How fixes were verified to keep the image; `None` if nothing was fixed.
pub fn proofs(proofs: &[Proof]) -> Option<String> {
    let ways = [
        (Proof::SameCode, "with identical code"),
        (Proof::SameBits, "with identical sampled pixels"),
        (Proof::Unknown, "not compared"),
    ];
    let counts = ways.map(|(way, words)| (proofs.iter().filter(|p| **p == way).count(), words));
    let text = counts.iter().filter(|(count, _)| *count > 0);
    let text = text.map(|(count, words)| format!("{count} {words}"));
    (!proofs.is_empty()).then(|| format!("fixed: {}", text.collect::<Vec<_>>().join(", ")))
}

/// Reports the files and folders that were skipped.
pub fn passed_over(passed: &PassedOver) {
    for path in &passed.excluded {
        complain(&format!("{path}: skipped: excluded by the configuration"));
    }
    for path in &passed.folders {
        complain(&format!("{path}: skipped: dependencies or build output"));
    }
    for (path, reason) in &passed.made {
        complain(&format!("{path}: skipped: {reason}"));
    }
    if passed.others > 0 {
        let extensions: Vec<&str> = passed.extensions.iter().map(String::as_str).collect();
        complain(&format!(
            "{} skipped because of the extension ({}); files in .gitignore are not counted",
            count(passed.others, "file"),
            extensions.join(", ")
        ));
    }
}
