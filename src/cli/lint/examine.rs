//! Checking inputs, several at a time.

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

/// What became of one input.
pub enum Outcome {
    /// What is found after what was mended, and what can be mended.
    Checked(Box<Report>, Mending, Offer),
    /// It is nothing that is read, for this reason; standard input is handed on as it is.
    Skipped(String, Option<Mended>),
    /// It cannot be judged, for this reason.
    Failed(String),
    /// Its configuration is wrong, in this way.
    Misconfigured(Arc<str>),
}

/// Mends all inputs, where they are to be, checks them and hands on what became of them, in order.
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

/// What all inputs of a run have in common.
struct Examination<'a> {
    configs: &'a Configs,
    /// Their names.
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
    // A fault of this program costs one file its answer, never the others theirs.
    let judged = catch_unwind(AssertUnwindSafe(|| judge(input, content, &options, run)));
    let Ok((report, mending, offer)) = judged else {
        return Outcome::Failed("shaderlint itself failed on this file; please report it".into());
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

/// Mends and checks one input.
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
