//! `--watch` and `--serve`: rebuilds the output on each change, and serves it as a page.

use super::args::PortArgs;
use super::build::build_output;
use super::load::named_files;
use super::report::print_note;
use super::save::save;
use super::serve::PageServer;
use crate::cli::output::Overwrite;
use crate::cli::watch::{Stamp, wait};
use crate::port::{Target, waiting_page};
use std::path::PathBuf;
use std::time::SystemTime;

/// Runs until the process is terminated.
pub(super) fn run(args: &PortArgs) -> Result<u8, String> {
    if args.input.iter().any(|p| p.as_os_str() == "-") {
        return Err("cannot watch or serve standard input; pass a file".to_string());
    }
    match args.serve {
        Some(_) if args.target()? != Target::Html => {
            Err("`--serve` requires `--target html`, the default".to_string())
        }
        Some(port) => serve(args, PageServer::open(port)?),
        None if !args.is_saved() => Err("`--watch` requires `-o FILE` or `--serve`".to_string()),
        None => write(args),
    }
}

/// Writes the output on each change.
fn write(args: &PortArgs) -> Result<u8, String> {
    let mut before = look(args, &[]);
    let made = build_output(args, None)?;
    save(&made.files, args.overwrite(), &made.read)?;
    let mut read = made.read;
    loop {
        before = next_change(args, before, &read);
        // From here on the output belongs to this run, and a file that cannot be read may be half
        // saved.
        let saved = build_output(args, None).and_then(|m| {
            read = m.read;
            save(&m.files, Overwrite::Allowed, &read)
        });
        if let Err(message) = saved {
            print_note(&message);
        }
    }
}

/// Serves the page; with `--watch` rebuilds it on each change.
fn serve(args: &PortArgs, server: PageServer) -> Result<u8, String> {
    print_note(&format!(
        "serving the page at {}; press Ctrl+C to stop",
        server.address()
    ));
    let mut read = Vec::new();
    let mut before = look(args, &read);
    loop {
        let version = version();
        match build_output(args, Some(&version)) {
            Ok(made) => {
                read = made.read;
                if let Some(page) = made.files.into_iter().next() {
                    server.show(&version, page.content);
                }
            }
            Err(message) if !args.watch => return Err(message),
            Err(message) => {
                print_note(&message);
                server.show_trouble(&message);
                if server.is_empty() {
                    server.show(&version, waiting_page(&message, &version).into_bytes());
                }
            }
        }
        if !args.watch {
            return Ok(server.stay());
        }
        before = next_change(args, before, &read);
    }
}

/// Waits until the files differ from their state before the build. Returns their new state.
fn next_change(args: &PortArgs, before: Stamp, read: &[PathBuf]) -> Stamp {
    print_note("waiting for changes");
    // Files that were discovered during the build are taken in their current state.
    let before = before.with(read.iter().cloned());
    wait(before, || look(args, read));
    look(args, read)
}

/// A version string that differs from that of every earlier page.
fn version() -> String {
    let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
    now.map_or(0, |t| t.as_nanos()).to_string()
}

/// The state of all input files: those that were `read` last, and those that the arguments name,
/// which may not exist yet.
fn look(args: &PortArgs, read: &[PathBuf]) -> Stamp {
    let named = named_files(args).into_iter();
    Stamp::of(named.chain(read.iter().cloned()))
}
