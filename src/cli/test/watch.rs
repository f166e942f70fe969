//! `--watch`: tests again what a change touches, until it is stopped.

use super::super::command::{FAILED, complain};
use super::super::watch::wait;
use super::args::TestArgs;
use super::session::{TestSession, print_message, stamp};
use std::io::{self, IsTerminal, Write};

pub fn run(args: &TestArgs) -> io::Result<u8> {
    // A name that is wrong from the start is no file that an editor is about to write.
    if let Some(missing) = args.paths.iter().find(|p| !p.exists()) {
        complain(&format!("{}: no such file or folder", missing.display()));
        return Ok(FAILED);
    }
    let mut session = TestSession::default();
    loop {
        if io::stdout().is_terminal() {
            // Clears the screen and moves the cursor to the top.
            write!(io::stdout(), "\x1b[2J\x1b[H")?;
        }
        session.run(args)?;
        let before = stamp(args, &session);
        print_message("waiting for changes");
        wait(before, || stamp(args, &session));
    }
}
