//! Checking inputs, several at a time.

use super::super::STACK;
use super::super::config::Configs;
use super::super::disk::Disk;
use super::super::input::{InputFile, read};
use super::mend::{Mend, Mended};
use crate::engine::{Offer, Options, Report, Unread, check_content, offer};
use crate::text::{Content, Encoding};
use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, mpsc};

/// What became of one input.
pub enum Outcome {
    /// What is found after what was mended, and what can be mended.
    Checked(Box<Report>, Option<Mended>, Offer),
    /// It is nothing that is read, for this reason; standard input is handed on as it is.
    Skipped(String, Option<Mended>),
    /// It cannot be judged, for this reason.
    Failed(String),
    /// Its configuration is wrong, in this way.
    Misconfigured(Arc<str>),
}

/// What is done with each input besides checking it.
#[derive(Clone, Copy, Default)]
pub struct ExtraWork {
    /// How it is mended.
    pub mend: Option<Mend>,
    /// Whether it is found out how many findings can be fixed.
    pub counts_fixes: bool,
}

/// Checks all inputs and hands on what became of them, in order.
pub fn examine_all(
    inputs: &[InputFile],
    configs: &Configs,
    work: ExtraWork,
    print: &mut impl FnMut(&InputFile, Outcome) -> io::Result<()>,
) -> io::Result<()> {
    let run = &Run {
        configs,
        checked: Arc::new(inputs.iter().map(|i| i.name.clone()).collect()),
        disk: Disk::new(),
        work,
    };
    let threads = match inputs.len() {
        0 | 1 => 1,
        count => std::thread::available_parallelism()
            .map_or(1, usize::from)
            .min(count),
    };
    if threads <= 1 {
        for input in inputs {
            print(input, examine(input, run))?;
        }
        return Ok(());
    }
    let next = AtomicUsize::new(0);
    let (sender, receiver) = mpsc::sync_channel(threads * 4);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            let (next, sender) = (&next, sender.clone());
            let work = move || {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    let Some(input) = inputs.get(index) else {
                        return;
                    };
                    let outcome = examine(input, run);
                    if sender.send((index, outcome)).is_err() {
                        return;
                    }
                }
            };
            let builder = std::thread::Builder::new().stack_size(STACK);
            builder.spawn_scoped(scope, work)?;
        }
        drop(sender);
        let mut waiting = BTreeMap::new();
        let mut due = 0;
        for (index, outcome) in receiver {
            waiting.insert(index, outcome);
            while let Some(outcome) = waiting.remove(&due) {
                if let Some(input) = inputs.get(due) {
                    print(input, outcome)?;
                }
                due += 1;
            }
        }
        Ok(())
    })
}

/// What all inputs of a run have in common.
struct Run<'a> {
    configs: &'a Configs,
    /// Their names.
    checked: Arc<BTreeSet<String>>,
    disk: Disk,
    work: ExtraWork,
}

fn examine(input: &InputFile, run: &Run) -> Outcome {
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
    let Ok((report, mended, offer)) = judged else {
        return Outcome::Failed("shaderlint itself failed on this file; please report it".into());
    };
    match report.unread {
        None => Outcome::Checked(Box::new(report), mended, offer),
        Some(Unread::Skipped(decision)) => Outcome::Skipped(decision.to_string(), mended),
        Some(Unread::Export(error)) if !input.is_explicit => {
            Outcome::Skipped(error.to_string(), mended)
        }
        Some(error @ (Unread::Export(_) | Unread::TooLarge)) => Outcome::Failed(error.to_string()),
    }
}

/// Mends and checks one input.
fn judge(
    input: &InputFile,
    mut content: Content,
    options: &Options,
    run: &Run,
) -> (Report, Option<Mended>, Offer) {
    let (name, disk) = (&input.name, &run.disk);
    let (text, mended) = match run.work.mend {
        Some(mend) => mend.apply(input, &content, options, disk),
        None => (None, None),
    };
    if let Some(text) = text {
        content = Content::utf8(&text);
    }
    let report = check_content(name, &content, options, disk);
    let is_written = content.encoding == Encoding::Utf8 && report.unread.is_none();
    let offer = match run.work.counts_fixes && is_written {
        true => offer(name, &content.text, options, disk, &report),
        false => Offer::default(),
    };
    (report, mended, offer)
}
