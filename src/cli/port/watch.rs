//! `--watch` and `--serve`: what was made is made again at each change, and shown on a page.

use super::args::PortArgs;
use super::load::files_of;
use super::make::make;
use super::report::tell;
use super::save::save;
use super::serve::PageServer;
use crate::cli::output::Overwrite;
use crate::cli::watch::{Stamp, wait};
use crate::port::{ChannelSource, Target, waiting_page};
use std::path::PathBuf;
use std::time::SystemTime;

/// Runs until the process is ended.
pub(super) fn run(args: &PortArgs) -> Result<u8, String> {
    if args.input.iter().any(|p| p.as_os_str() == "-") {
        return Err("standard input cannot be watched or served; name a file".to_string());
    }
    match args.serve {
        Some(_) if args.target()? != Target::Html => {
            Err("only a page can be served; leave `--target` away".to_string())
        }
        Some(port) => serve(args, PageServer::open(port)?),
        None if !args.is_saved() => {
            Err("say where to write, with `-o FILE`, or `--serve` the page".to_string())
        }
        None => write(args),
    }
}

/// Writes the output at each change.
fn write(args: &PortArgs) -> Result<u8, String> {
    let mut before = look(args, &[]);
    let made = make(args, None)?;
    save(&made.files, args.overwrite(), &made.read)?;
    let mut read = made.read;
    loop {
        before = next_change(args, before, &read);
        // From here on the output is this run's own, and what cannot be read may be half saved.
        let saved = make(args, None).and_then(|m| {
            read = m.read;
            save(&m.files, Overwrite::Allowed, &read)
        });
        if let Err(message) = saved {
            tell(&message);
        }
    }
}

/// Shows the page; with `--watch` anew at each change.
fn serve(args: &PortArgs, server: PageServer) -> Result<u8, String> {
    tell(&format!(
        "the page is at {}; Ctrl+C ends it",
        server.address()
    ));
    let mut read = Vec::new();
    let mut before = look(args, &read);
    loop {
        let version = version();
        match make(args, Some(&version)) {
            Ok(made) => {
                read = made.read;
                if let Some(page) = made.files.into_iter().next() {
                    server.show(&version, page.content);
                }
            }
            Err(message) if !args.watch => return Err(message),
            Err(message) => {
                tell(&message);
                server.tell(&message);
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

/// Waits until the files differ from what they were before the output was made; gives what they are.
fn next_change(args: &PortArgs, before: Stamp, read: &[PathBuf]) -> Stamp {
    tell("waiting for changes");
    // What was only found while reading is taken as it is now.
    let before = before.with(read.iter().cloned());
    wait(before, || look(args, read));
    look(args, read)
}

/// What tells a page from those made before it, in this run or another.
fn version() -> String {
    let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
    now.map_or(0, |t| t.as_nanos()).to_string()
}

/// What is to be seen of the files that the output is made of: those that were `read` last, and those
/// that the arguments name and that may come.
fn look(args: &PortArgs, read: &[PathBuf]) -> Stamp {
    let named = files_of(args).unwrap_or_default();
    let orders = args.orders().unwrap_or_default().into_iter();
    let media = orders.filter_map(|o| match o.order.source {
        ChannelSource::File(path) => Some(PathBuf::from(path)),
        _ => None,
    });
    Stamp::of(named.into_iter().chain(media).chain(read.iter().cloned()))
}
