//! `--watch` and `--serve`: what was made is made again at each change, and shown on a page.

use super::channels::file_of;
use super::load::is_shader;
use super::serve::Server;
use super::{PortArgs, make, save};
use crate::cli::output::Overwrite;
use crate::cli::watch::{Stamp, wait};
use crate::port::{ChannelSource, Target, waiting_page};
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
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
        Some(port) => serve(args, Server::open(port)?),
        None if !args.is_saved() => {
            Err("say where to write, with `-o FILE`, or `--serve` the page".to_string())
        }
        None => write(args),
    }
}

/// Writes the output at each change.
fn write(args: &PortArgs) -> Result<u8, String> {
    let mut before = look(args);
    let made = make(args, None)?;
    save(&made.files, args.overwrite(), &made.read)?;
    loop {
        tell("waiting for changes");
        wait(before, || look(args));
        before = look(args);
        // From here on the output is this run's own, and what cannot be read may be half saved.
        let saved = make(args, None).and_then(|m| save(&m.files, Overwrite::Allowed, &m.read));
        if let Err(message) = saved {
            tell(&message);
        }
    }
}

/// Shows the page; with `--watch` anew at each change.
fn serve(args: &PortArgs, server: Server) -> Result<u8, String> {
    tell(&format!(
        "the page is at {}; Ctrl+C ends it",
        server.address()
    ));
    loop {
        let before = look(args);
        let version = version();
        match make(args, Some(&version)) {
            Ok(made) => {
                if let Some(page) = made.files.into_iter().next() {
                    server.show(&version, page.content);
                }
            }
            Err(message) if !args.watch => return Err(message),
            Err(message) => {
                tell(&message);
                if server.is_empty() {
                    server.show(&version, waiting_page(&message, &version).into_bytes());
                }
            }
        }
        if !args.watch {
            return Ok(server.stay());
        }
        tell("waiting for changes");
        wait(before, || look(args));
    }
}

/// What tells a page from those made before it, in this run or another.
fn version() -> String {
    let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
    now.map_or(0, |t| t.as_nanos()).to_string()
}

fn tell(message: &str) {
    let _ = writeln!(io::stderr(), "shaderport: {message}");
}

/// What is to be seen of the files that the output is made of.
fn look(args: &PortArgs) -> Stamp {
    let mut files: Vec<PathBuf> = Vec::new();
    for path in &args.input {
        match path.is_dir() {
            true => files.extend(in_folder(path)),
            false => files.push(path.clone()),
        }
    }
    let named = args.pass.iter().filter_map(|text| text.split_once('='));
    files.extend(named.map(|(_, path)| PathBuf::from(path)));
    files.extend(file_of(args));
    if let Ok(orders) = super::channels::orders(args) {
        files.extend(orders.into_iter().filter_map(|o| match o.order.source {
            ChannelSource::File(path) => Some(PathBuf::from(path)),
            _ => None,
        }));
    }
    Stamp::of(files)
}

/// The shaders of a folder, where passes may come and go.
fn in_folder(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten();
    let paths = entries.filter_map(|e| Some(e.ok()?.path()));
    paths.filter(|p| is_shader(p)).collect()
}
