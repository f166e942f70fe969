//! `-v` of all commands: what was opened for a file, and why.

use super::disk::Disk;
use super::global::{Talk, given};
use crate::engine::config::Configs;
use crate::project::{NoMedia, OpenedProject, open_file};
use std::collections::BTreeSet;
use std::io::{self, Write};
use std::path::Path;
use std::sync::{Mutex, PoisonError};

/// What has been reported: a command may open a file several times.
static REPORTED: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());

/// With `-v`, reports what was opened of a file or folder with this name. Commands that open projects
/// always print the guesses.
pub fn opened(name: &str, opened: &OpenedProject) {
    report(name, opened.evidence());
}

/// With `-v`, reports what belongs to a file, and what was guessed, for other commands.
pub fn file(name: &str, text: &str, configs: &Configs) {
    if given().talk() < Talk::Verbose {
        return;
    }
    let disk = Disk::new();
    let Ok(options) = configs.options(Path::new(name)) else {
        return;
    };
    let access = options.file_access(&disk);
    if let Ok(mut found) = open_file(name, text, options.host.preset, access) {
        // Channels are guessed last, where the orders leave them free.
        let _ = found.project.resolve(name);
        let _ = found.project.put_all(&found.orders, &mut NoMedia);
        report(name, [&found.project.notes[..], &found.evidence()].concat());
    }
}

fn report(name: &str, lines: Vec<String>) {
    if given().talk() < Talk::Verbose {
        return;
    }
    for line in lines {
        let line = format!("{name}: {line}");
        let mut reported = REPORTED.lock().unwrap_or_else(PoisonError::into_inner);
        if reported.insert(line.clone()) {
            let _ = writeln!(io::stderr(), "note: {line}");
        }
    }
}
