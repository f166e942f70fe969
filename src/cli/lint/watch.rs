//! `--watch`: checks again whenever a file changes, until it is stopped.

use super::super::config::Configs;
use super::super::input::collect;
use super::args::Args;
use super::{check, complain};
use crate::rules::RULES;
use std::collections::BTreeMap;
use std::fs;
use std::io::{self, IsTerminal, Write};
use std::path::PathBuf;
use std::time::{Duration, SystemTime};

/// How often files are looked at. Asking the file system works on every one of them, network and
/// container mounts included, where change events do not arrive.
const PAUSE: Duration = Duration::from_millis(300);

/// Runs until the process is ended.
pub fn run(args: &Args) -> io::Result<u8> {
    let mut stamp = Stamp::new();
    loop {
        if io::stdout().is_terminal() {
            // Clears the screen and goes to its top.
            write!(io::stdout(), "\x1b[2J\x1b[H")?;
        }
        check(args)?;
        let seen = take_stamp(args);
        complain("waiting for changes");
        stamp.clone_from(&seen);
        loop {
            std::thread::sleep(PAUSE);
            let now = take_stamp(args);
            if now != stamp {
                // Editors write in several steps; the last look decides.
                stamp = settle(args, now);
                break;
            }
        }
    }
}

/// Sizes and times of all files.
type Stamp = BTreeMap<PathBuf, (u64, Option<SystemTime>)>;

fn settle(args: &Args, mut stamp: Stamp) -> Stamp {
    loop {
        std::thread::sleep(PAUSE / 3);
        let now = take_stamp(args);
        if now == stamp {
            return now;
        }
        stamp = now;
    }
}

fn take_stamp(args: &Args) -> Stamp {
    let configs = Configs::new(args.given(), RULES);
    let inputs = collect(&args.paths, args.stdin_filename.as_deref(), &configs).inputs;
    let paths = inputs.into_iter().filter_map(|i| i.path);
    let config = args
        .config
        .clone()
        .unwrap_or_else(|| super::super::config::FILE.into());
    paths
        .chain([config])
        .filter_map(|path| {
            let data = fs::metadata(&path).ok()?;
            Some((path, (data.len(), data.modified().ok())))
        })
        .collect()
}
