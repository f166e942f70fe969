//! Checks inputs in parallel.

use super::super::config::Configs;
use super::super::disk::Disk;
use super::super::input::{InputFile, read};
use super::super::parallel::in_order;
use super::fix::{AppliedFixes, FixMode, FixOutcome};
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
    Checked(Box<Report>, FixOutcome, Offer),
    /// Not a file that is checked, with the reason. Standard input is passed through unchanged.
    Skipped(String, Option<AppliedFixes>),
    /// An error prevented the check, with its message.
    Failed(String),
    /// The configuration is invalid, with the message.
    Misconfigured(Arc<str>),
}

/// Fixes all inputs if asked to, checks them, and passes the outcomes to `print` in order.
pub fn check_all(
    inputs: &[InputFile],
    configs: &Configs,
    fix_mode: Option<FixMode>,
    print: &mut impl FnMut(&InputFile, Outcome) -> io::Result<()>,
) -> io::Result<()> {
    let run = &CheckRun {
        configs,
        checked: Arc::new(inputs.iter().map(|i| i.name.clone()).collect()),
        disk: Disk::new(),
        fix_mode,
    };
    let work = |index: usize| {
        inputs
            .get(index)
            .map(|input| (input, check_input(input, run)))
    };
    in_order(inputs.len(), &work, &mut |done| match done {
        Some((input, outcome)) => print(input, outcome),
        None => Ok(()),
    })
}

/// What all inputs of a run share.
struct CheckRun<'a> {
    configs: &'a Configs,
    /// The names of all inputs.
    checked: Arc<BTreeSet<String>>,
    disk: Disk,
    fix_mode: Option<FixMode>,
}

fn check_input(input: &InputFile, run: &CheckRun) -> Outcome {
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
    let checked = catch_unwind(AssertUnwindSafe(|| {
        fix_and_check(input, content, &options, run)
    }));
    let Ok((report, fix_outcome, offer)) = checked else {
        return Outcome::Failed(
            "internal error: shaderlint crashed on this file; please report it".into(),
        );
    };
    match report.unread {
        None => Outcome::Checked(Box::new(report), fix_outcome, offer),
        Some(Unread::Skipped(decision)) => {
            Outcome::Skipped(decision.to_string(), fix_outcome.applied)
        }
        Some(Unread::Export(error)) if !input.is_explicit => {
            Outcome::Skipped(error.to_string(), fix_outcome.applied)
        }
        Some(error @ (Unread::Export(_) | Unread::TooLarge)) => Outcome::Failed(error.to_string()),
    }
}

/// Fixes and checks one input.
fn fix_and_check(
    input: &InputFile,
    mut content: Content,
    options: &Options,
    run: &CheckRun,
) -> (Report, FixOutcome, Offer) {
    let (name, disk) = (&input.name, &run.disk);
    let (text, fix_outcome) = match run.fix_mode {
        Some(fix_mode) => fix_mode.apply(input, &content, options, disk),
        None => (None, FixOutcome::default()),
    };
    if let Some(text) = text {
        content = Content::utf8(&text);
    }
    let mut report = check_content(name, &content, options, disk);
    report.leave_alone(&fix_outcome.left);
    report.retract_failing_fixes((name, &content.text), options, disk);
    let is_written = content.encoding == Encoding::Utf8 && report.unread.is_none();
    let offer = match is_written {
        true => Offer::of(&report),
        false => Offer::default(),
    };
    (report, fix_outcome, offer)
}
