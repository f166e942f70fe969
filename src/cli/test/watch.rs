//! `--watch`: tests again what a change touches, until it is stopped.

use super::super::command::{FAILED, complain};
use super::super::usage::absent;
use super::super::watch::{clear_screen, wait};
use super::args::TestArgs;
use super::session::{TestSession, print_message, stamp};
use std::io;

pub fn run(args: &TestArgs) -> io::Result<u8> {
    // A name that is wrong from the start is no file that an editor is about to write.
    if let Some(message) = absent(&args.paths) {
        complain(&message);
        return Ok(FAILED);
    }
    let mut session = TestSession::default();
    loop {
        clear_screen()?;
        session.run(args)?;
        let before = stamp(args, &session);
        print_message("waiting for changes");
        wait(before, || stamp(args, &session));
    }
}
