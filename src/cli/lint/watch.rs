//! `--watch`: checks again whenever a file changes, until it is stopped.

use super::super::FAILED;
use super::super::config::{Configs, FILE};
use super::super::input::{InputFile, collect};
use super::args::LintArgs;
use super::{check, complain};
use std::collections::BTreeMap;
use std::fs;
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// How often files are looked at. Asking the file system works on every one of them, network and
/// container mounts included, where change events do not arrive.
const PAUSE: Duration = Duration::from_millis(300);

/// Runs until the process is ended. The two lines on standard error that frame each check are for
/// editors, which clear their list of problems at the first.
pub fn run(args: &LintArgs) -> io::Result<u8> {
    if args.paths.iter().any(|p| p.as_os_str() == "-") {
        complain("standard input cannot be watched");
        return Ok(FAILED);
    }
    loop {
        if io::stdout().is_terminal() {
            // Clears the screen and goes to its top.
            write!(io::stdout(), "\x1b[2J\x1b[H")?;
        }
        complain("checking");
        let before = take_stamp(args);
        check(args)?;
        // What was mended is no change.
        let mut stamp = if args.fix || args.unsafe_fixes {
            take_stamp(args)
        } else {
            before
        };
        complain("waiting for changes");
        while take_stamp(args) == stamp {
            std::thread::sleep(PAUSE);
        }
        // Editors write in several steps; the last look decides.
        while take_stamp(args) != stamp {
            stamp = take_stamp(args);
            std::thread::sleep(PAUSE / 3);
        }
    }
}

/// Sizes and times of all files.
type Stamp = BTreeMap<PathBuf, (u64, Option<SystemTime>)>;

fn take_stamp(args: &LintArgs) -> Stamp {
    let configs = Configs::new(args.asked());
    let inputs = collect(&args.paths(), args.stdin_filename.as_deref(), &configs).inputs;
    let files = inputs.iter().filter_map(|i| i.path.clone());
    let config_of = |i: &InputFile| configs.file_of(Path::new(&i.name));
    let here = PathBuf::from(FILE);
    files
        .chain(inputs.iter().filter_map(config_of))
        .chain([here])
        .filter_map(|path| {
            let data = fs::metadata(&path).ok()?;
            Some((path, (data.len(), data.modified().ok())))
        })
        .collect()
}
