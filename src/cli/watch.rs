//! Waiting for files to change.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::thread::sleep;
use std::time::{Duration, SystemTime};

/// How often files are looked at. Asking the file system works on every one of them, network and
/// container mounts included, where change events do not arrive.
const PAUSE: Duration = Duration::from_millis(300);

/// Sizes and times of files, by which a change is seen.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Stamp(BTreeMap<PathBuf, (u64, Option<SystemTime>)>);

impl Stamp {
    /// What is to be seen of some files now; a file that is not there has no part in it.
    pub fn of(files: impl IntoIterator<Item = PathBuf>) -> Stamp {
        let seen = files.into_iter().filter_map(|path| {
            let data = fs::metadata(&path).ok()?;
            Some((path, (data.len(), data.modified().ok())))
        });
        Stamp(seen.collect())
    }

    /// The same with files of which nothing was known, as they are now.
    pub fn with(mut self, files: impl IntoIterator<Item = PathBuf>) -> Stamp {
        for (path, seen) in Stamp::of(files).0 {
            self.0.entry(path).or_insert(seen);
        }
        self
    }
}

/// Returns when a look at the files differs from the one before, and has stopped to change: editors
/// write in several steps, and the last look decides.
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
