//! Checking inputs, several at a time.

use super::super::STACK;
use super::super::config::Configs;
use super::super::input::{InputFile, read};
use super::mend::{Mend, Mended};
use crate::engine::{DocumentError, Findings, Offer, Options, Partners, check_with, offer};
use crate::text::{Content, Encoding};
use std::collections::BTreeMap;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, mpsc};

/// What became of one input.
pub enum Outcome {
    /// What is found after what was mended, and what can be mended.
    Checked(Box<Findings>, Option<Mended>, Offer),
    /// It is nothing that is read, for this reason; standard input is handed on as it is.
    Skipped(String, Option<Mended>),
    /// It cannot be judged, for this reason.
    Failed(String),
    /// Its configuration is wrong, in this way.
    Misconfigured(Arc<str>),
}

/// What is done with each input besides checking it.
#[derive(Clone, Copy, Default)]
pub struct Work {
    /// How it is mended.
    pub mend: Option<Mend>,
    /// Whether it is found out how many findings can be fixed.
    pub counts_fixes: bool,
}

/// Checks all inputs and hands on what became of them, in order.
pub fn examine_all(
    inputs: &[InputFile],
    configs: &Configs,
    work: Work,
    print: &mut impl FnMut(&InputFile, Outcome) -> io::Result<()>,
) -> io::Result<()> {
    let partners = Partners::beside(inputs.iter().map(|i| i.name.as_str()));
    let partners = &partners;
    let threads = match inputs.len() {
        0 | 1 => 1,
        count => std::thread::available_parallelism()
            .map_or(1, usize::from)
            .min(count),
    };
    if threads <= 1 {
        for input in inputs {
            print(input, examine(input, configs, partners, work))?;
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
                    let outcome = examine(input, configs, partners, work);
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

fn examine(input: &InputFile, configs: &Configs, partners: &Partners, work: Work) -> Outcome {
    let judge = match configs.judge(Path::new(&input.name)) {
        Ok(judge) => judge,
        Err(message) => return Outcome::Misconfigured(message),
    };
    let content = match read(input) {
        Ok(content) => content,
        Err(message) => return Outcome::Failed(message),
    };
    let options = || Options {
        partners,
        claim: input.claim,
        ..judge.options()
    };
    // A fault of this program costs one file its answer, never the others theirs.
    let judged = catch_unwind(AssertUnwindSafe(|| {
        let (text, mended) = match work.mend {
            Some(mend) => mend.apply(input, &content, &options()),
            None => (None, None),
        };
        let content = match text {
            Some(text) => Content::utf8(&text),
            None => content,
        };
        let is_written = content.encoding == Encoding::Utf8;
        let text = (work.counts_fixes && is_written).then(|| content.text.clone());
        let findings = check_with(&input.name, content, &options());
        let offer = match (&findings, text) {
            (Ok(findings), Some(text)) => offer(&input.name, &text, &options(), findings),
            _ => Offer::default(),
        };
        (findings.map(|f| (f, offer)), mended)
    }));
    let Ok((judged, mended)) = judged else {
        return Outcome::Failed("shaderlint itself failed on this file; please report it".into());
    };
    match judged {
        Ok((findings, offer)) => Outcome::Checked(Box::new(findings), mended, offer),
        Err(DocumentError::Skipped(decision)) => Outcome::Skipped(decision.to_string(), mended),
        Err(DocumentError::Export(error)) if input.is_explicit => {
            Outcome::Failed(error.to_string())
        }
        Err(DocumentError::Export(error)) => Outcome::Skipped(error.to_string(), mended),
        Err(DocumentError::TooLarge) => Outcome::Failed("the file is too large".to_string()),
    }
}
