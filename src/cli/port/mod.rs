//! The command line interface of `shaderport`.

mod args;
mod beside;
mod channels;
mod load;
mod make;
mod media;
mod read;
mod report;
mod save;
mod serve;
mod watch;
#[cfg(feature = "naga")]
mod whole;

pub use args::PortArgs;
pub(super) use load::{draft, in_folder, put_channels};
pub(super) use read::{read_text, shown};
pub(super) use save::save;

use super::command::FAILED;
use make::{make, print};
use report::tell;

/// Runs `shaderport` and returns the exit code.
pub fn run(args: &PortArgs) -> u8 {
    match port(args) {
        Ok(code) => code,
        Err(message) => {
            tell(&message);
            FAILED
        }
    }
}

fn port(args: &PortArgs) -> Result<u8, String> {
    if args.watch || args.serve.is_some() {
        return watch::run(args);
    }
    let made = make(args, None)?;
    if args.is_saved() {
        save(&made.files, args.overwrite(), &made.read)?;
    } else if let Some(first) = made.files.first() {
        print(&first.content)?;
    }
    Ok(made.code)
}
