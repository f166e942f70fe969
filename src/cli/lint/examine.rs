//! Checks inputs in parallel.

use super::super::config::Configs;
use super::super::disk::Disk;
use super::super::input::{InputFile, read};
use super::super::parallel::in_order;
use super::mend::{Mend, Mended, Mending};
use crate::engine::{Offer, Options, Report, Unread, check_content};
use crate::text::{Content, Encoding};
use std::collections::BTreeSet;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Arc;

/// The result of one input.
pub enum Outcome {
    /// The findings that remain after fixing, and the fixes on offer.
    Checked(Box<Report>, Mending, Offer),
    /// Not a file that is checked, with the reason. Standard input is passed through unchanged.
    Skipped(String, Option<Mended>),
    /// An error prevented the check, with its message.
    Failed(String),
    /// The configuration is invalid, with the message.
    Misconfigured(Arc<str>),
}

/// Fixes all inputs if asked to, checks them, and passes the outcomes to `print` in order.
pub fn examine_all(
    inputs: &[InputFile],
    configs: &Configs,
    mend: Option<Mend>,
    print: &mut impl FnMut(&InputFile, Outcome) -> io::Result<()>,
) -> io::Result<()> {
    let run = &Examination {
        configs,
        checked: Arc::new(inputs.iter().map(|i| i.name.clone()).collect()),
        disk: Disk::new(),
        mend,
    };
    let work = |index: usize| inputs.get(index).map(|input| (input, examine(input, run)));
    in_order(inputs.len(), &work, &mut |done| match done {
        Some((input, outcome)) => print(input, outcome),
        None => Ok(()),
    })
}

/// What all inputs of a run share.
struct Examination<'a> {
    configs: &'a Configs,
    /// The names of all inputs.
    checked: Arc<BTreeSet<String>>,
    disk: Disk,
    mend: Option<Mend>,
}

fn examine(input: &InputFile, run: &Examination) -> Outcome {
    let options = match run.configs.options(Path::new(&input.name)) {
        Ok(options) => options,
        Err(message) => return Outcome::Misconfigured(message),
    };
    let content = match read(input) {
        Ok(content) => content,
        Err(message) => return Outcome::Failed(message),
    };
    let options = Options {
        checked: run.checked.clone(),
        claim: input.claim,
        ..Options::clone(&options)
    };
    // A panic loses the result of one file only.
    let judged = catch_unwind(AssertUnwindSafe(|| judge(input, content, &options, run)));
    let Ok((report, mending, offer)) = judged else {
        return Outcome::Failed(
            "internal error: shaderlint crashed on this file; please report it".into(),
        );
    };
    match report.unread {
        None => Outcome::Checked(Box::new(report), mending, offer),
        Some(Unread::Skipped(decision)) => Outcome::Skipped(decision.to_string(), mending.mended),
        Some(Unread::Export(error)) if !input.is_explicit => {
            Outcome::Skipped(error.to_string(), mending.mended)
        }
        Some(error @ (Unread::Export(_) | Unread::TooLarge)) => Outcome::Failed(error.to_string()),
    }
}

/// Fixes and checks one input.
fn judge(
    input: &InputFile,
    mut content: Content,
    options: &Options,
    run: &Examination,
) -> (Report, Mending, Offer) {
    let (name, disk) = (&input.name, &run.disk);
    let (text, mending) = match run.mend {
        Some(mend) => mend.apply(input, &content, options, disk),
        None => (None, Mending::default()),
    };
    if let Some(text) = text {
        content = Content::utf8(&text);
    }
    let mut report = check_content(name, &content, options, disk);
    report.leave_alone(&mending.left);
    let is_written = content.encoding == Encoding::Utf8 && report.unread.is_none();
    let offer = match is_written {
        true => Offer::of(&report),
        false => Offer::default(),
    };
    (report, mending, offer)
}
