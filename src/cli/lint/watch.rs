//! `--watch`: checks again whenever a file changes, until it is stopped.

use super::super::command::{FAILED, complain};
use super::super::config::configs;
use super::super::input::{InputFile, collect};
use super::super::usage::absent;
use super::super::watch::{Stamp, clear_screen, wait};
use super::args::CheckArgs;
use super::check::check;
use crate::engine::config::FILE;
use std::io;
use std::path::{Path, PathBuf};

/// Runs until the process is ended. The two lines on standard error that frame each check are for
/// editors, which clear their list of problems at the first.
pub fn run(args: &CheckArgs) -> io::Result<u8> {
    if args.paths.iter().any(|p| p.as_os_str() == "-") {
        complain("cannot watch standard input");
        return Ok(FAILED);
    }
    // A name that is wrong from the start is no file that an editor is about to write.
    if let Some(message) = absent(&args.paths) {
        complain(&message);
        return Ok(FAILED);
    }
    loop {
        clear_screen()?;
        complain("checking");
        let before = take_stamp(args);
        check(args)?;
        // Files written by fixes do not count as changes.
        let stamp = if args.fix || args.unsafe_fixes {
            take_stamp(args)
        } else {
            before
        };
        complain("waiting for changes");
        wait(stamp, || take_stamp(args));
    }
}

fn take_stamp(args: &CheckArgs) -> Stamp {
    let configs = configs(args.asked());
    let inputs = collect(&args.paths, args.stdin_filename.as_deref(), &configs).inputs;
    let files = inputs.iter().filter_map(|i| i.path.clone());
    let config_of = |i: &InputFile| configs.file_of(Path::new(&i.name));
    let here = PathBuf::from(FILE);
    let configs = inputs.iter().filter_map(config_of);
    Stamp::of(files.chain(configs).chain([here]))
}
