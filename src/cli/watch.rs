//! Waits until files change.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, IsTerminal, Write};
use std::path::PathBuf;
use std::thread::sleep;
use std::time::{Duration, SystemTime};

/// Polling interval. Polling works on every file system; network and container mounts do not
/// deliver change events.
const PAUSE: Duration = Duration::from_millis(300);

/// Sizes and modification times of files, to detect changes.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Stamp(BTreeMap<PathBuf, (u64, Option<SystemTime>)>);

impl Stamp {
    /// The current state of some files; missing files are left out.
    pub fn of(files: impl IntoIterator<Item = PathBuf>) -> Stamp {
        let seen = files.into_iter().filter_map(|path| {
            let data = fs::metadata(&path).ok()?;
            Some((path, (data.len(), data.modified().ok())))
        });
        Stamp(seen.collect())
    }

    /// Adds the current state of files that are not included yet.
    pub fn with(mut self, files: impl IntoIterator<Item = PathBuf>) -> Stamp {
        self.add(&Stamp::of(files));
        self
    }

    /// Adds the files that are not included yet.
    pub fn add(&mut self, other: &Stamp) {
        for (path, seen) in &other.0 {
            self.0.entry(path.clone()).or_insert(*seen);
        }
    }
}

/// Clears the terminal and moves the cursor to the top.
pub fn clear_screen() -> io::Result<()> {
    match io::stdout().is_terminal() {
        true => write!(io::stdout(), "\x1b[2J\x1b[H"),
        false => Ok(()),
    }
}

/// Returns when the files differ from `before` and have stopped changing, because editors write in
/// several steps.
pub fn wait(mut before: Stamp, look: impl Fn() -> Stamp) {
    while look() == before {
        sleep(PAUSE);
    }
    loop {
        let now = look();
        if now == before {
            return;
        }
        before = now;
        sleep(PAUSE / 3);
    }
}
