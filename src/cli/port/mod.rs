//! The command line interface of `shaderport`.

mod args;
mod build;
#[cfg(feature = "naga")]
mod complete;
mod gallery;
mod load;
mod media;
mod read;
mod report;
mod save;
mod serve;
mod still;
mod watch;

pub use args::PortArgs;
pub(super) use load::{draft, put_channels};
pub(super) use read::read_text;
pub(super) use save::save;

use super::command::FAILED;
use super::global::GlobalArgs;
use super::usage::absent;
use args::PortCommand;
use build::{build_output, print};
use report::print_note;

/// Runs `shaderport` and returns the exit code.
pub fn run(args: &PortArgs) -> u8 {
    let options = GlobalArgs {
        verbose: args.verbose,
        ..GlobalArgs::default()
    };
    options.apply();
    match port(args) {
        Ok(code) => code,
        Err(message) => {
            print_note(&message);
            FAILED
        }
    }
}

fn port(args: &PortArgs) -> Result<u8, String> {
    let args = &args.clone().completed()?;
    if let Some(PortCommand::Gallery(args)) = &args.command {
        return gallery::run(args);
    }
    if let Some(args) = gallery::gallery_of(args)? {
        return gallery::run(&args);
    }
    let waits = args.watch || args.serve.is_some(); // for a file that comes later
    if let Some(message) = absent(&args.input).filter(|_| !waits || args.input.len() > 1) {
        return Err(message);
    }
    if waits {
        return watch::run(args);
    }
    let made = build_output(args, None)?;
    if args.is_saved() {
        save(&made.files, args.overwrite(), &made.read)?;
    } else if let Some(first) = made.files.first() {
        print(&first.content)?;
    }
    Ok(made.code)
}
