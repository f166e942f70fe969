//! Checking inputs, several at a time.

use super::super::STACK;
use super::super::config::Configs;
use super::super::document::{DocumentError, Findings, check_with};
use super::super::input::{Content, InputFile, read};
use super::mend::{Mend, Mended};
use std::collections::BTreeMap;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, mpsc};

/// What became of one input.
pub enum Outcome {
    /// What is found, after what was mended.
    Checked(Findings, Option<Mended>),
    /// A JSON file in a folder that is no export.
    Skipped,
    /// It cannot be judged, for this reason.
    Failed(String),
    /// Its configuration is wrong, in this way.
    Misconfigured(Arc<str>),
}

/// Checks all inputs and hands on what became of them, in order.
pub fn examine_all(
    inputs: &[InputFile],
    configs: &Configs,
    mend: Option<Mend>,
    print: &mut impl FnMut(&InputFile, Outcome) -> io::Result<()>,
) -> io::Result<()> {
    let threads = match inputs.len() {
        0 | 1 => 1,
        count => std::thread::available_parallelism()
            .map_or(1, usize::from)
            .min(count),
    };
    if threads <= 1 {
        for input in inputs {
            print(input, examine(input, configs, mend))?;
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
                    let outcome = examine(input, configs, mend);
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

fn examine(input: &InputFile, configs: &Configs, mend: Option<Mend>) -> Outcome {
    let judge = match configs.judge(Path::new(&input.name)) {
        Ok(judge) => judge,
        Err(message) => return Outcome::Misconfigured(message),
    };
    let content = match read(input) {
        Ok(content) => content,
        Err(message) => return Outcome::Failed(message),
    };
    // A fault of this program costs one file its answer, never the others theirs.
    let judged = catch_unwind(AssertUnwindSafe(|| {
        let Some(mend) = mend else {
            return (check_with(&input.name, content, &judge.options()), None);
        };
        let (text, mended) = mend.apply(input, &content, &judge.options());
        let content = match text {
            Some(text) => Content::utf8(&text),
            None => content,
        };
        (check_with(&input.name, content, &judge.options()), mended)
    }));
    let Ok((judged, mended)) = judged else {
        return Outcome::Failed("shaderlint itself failed on this file; please report it".into());
    };
    match judged {
        Ok(findings) => Outcome::Checked(findings, mended),
        Err(DocumentError::NotAnExport) if !input.is_explicit => Outcome::Skipped,
        Err(DocumentError::NotAnExport) => {
            Outcome::Failed("this is no ShaderToy export: it has no `renderpass`".to_string())
        }
        Err(DocumentError::Export(error)) if input.is_explicit => {
            Outcome::Failed(error.to_string())
        }
        Err(DocumentError::Export(_)) => Outcome::Skipped,
        Err(DocumentError::TooLarge) => Outcome::Failed("the file is too large".to_string()),
    }
}
