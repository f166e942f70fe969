//! Checks inputs in parallel.

use super::super::disk::Disk;
use super::super::input::{InputFile, read};
use super::super::parallel::in_order;
use super::cache::{Entry, FindingCache, Key, Recorder};
use super::fix::{AppliedFixes, FixMode, FixOutcome};
use crate::commands::{self, CheckedText, Recognition};
use crate::detect::kind::{FileKind, is_searched};
use crate::engine::config::Configs;
use crate::engine::{Options, Unread};
use crate::project::Files;
use crate::text::Content;
use std::collections::BTreeSet;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Arc;

/// The result of one input.
pub enum Outcome {
    /// The findings that remain after fixing, and the fixes on offer.
    Checked(Box<CheckedInput>),
    /// Not a file that is checked, with the reason. Standard input is passed through unchanged.
    Skipped(String, Option<AppliedFixes>),
    /// An error prevented the check, with its message.
    Failed(String),
    /// The configuration is invalid, with the message.
    Misconfigured(Arc<str>),
}

/// A checked input.
pub struct CheckedInput {
    /// The findings. If they were in the cache, only what is printed is known.
    pub text: CheckedText,
    /// The fixes that were applied.
    pub fixed: FixOutcome,
}

/// How inputs are checked.
#[derive(Clone, Copy, Default)]
pub struct CheckMode<'a> {
    /// The fixes to apply first.
    pub fix: Option<FixMode>,
    /// Whether the output says how inputs were interpreted.
    pub shows_readings: bool,
    /// Whether it is an error if a named file has no shader.
    pub requires_shaders: bool,
    /// Findings of unchanged files.
    pub cache: Option<&'a FindingCache>,
}

/// Fixes all inputs if asked to, checks them, and passes the outcomes to `print` in order.
pub fn check_all(
    inputs: &[InputFile],
    configs: &Configs,
    mode: CheckMode<'_>,
    print: &mut impl FnMut(&InputFile, Outcome) -> io::Result<()>,
) -> io::Result<()> {
    let run = &CheckRun {
        configs,
        checked: Arc::new(inputs.iter().map(|i| i.name.clone()).collect()),
        disk: Disk::new(),
        mode,
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
    mode: CheckMode<'a>,
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
    let key = run.mode.cache.and_then(|cache| {
        let key = cache.key(input, &content, &options, run.mode.shows_readings)?;
        Some((cache, key))
    });
    let options = Options {
        checked: run.checked.clone(),
        claim: input.claim,
        ..Options::clone(&options)
    };
    if let Some(known) = key.and_then(|key| known(key, &content, &options)) {
        return Outcome::Checked(Box::new(known));
    }
    let recorder = Recorder::new(&run.disk);
    // A panic loses the result of one file only.
    let checked = catch_unwind(AssertUnwindSafe(|| match key {
        Some(_) => fix_and_check(input, &content, (&options, &recorder), run),
        None => fix_and_check(input, &content, (&options, &run.disk), run),
    }));
    let Ok(checked) = checked else {
        return Outcome::Failed(
            "internal error: shaderlint crashed on this file; please report it".into(),
        );
    };
    if let (Some(key), None) = (key, &checked.text.report.unread) {
        keep(key, &checked, (&content, &options), recorder);
    }
    match checked.text.report.unread {
        None => Outcome::Checked(Box::new(checked)),
        // Whoever pipes a text as GLSL wants it checked, and so does whoever names a file.
        Some(Unread::Skipped(decision)) => match (&input.path, run.mode.requires_shaders) {
            (None, _) if is_asked_for(input, run) => Outcome::Failed(decision.to_string()),
            (Some(_), true)
                if input.is_explicit && !matches!(decision.kind, FileKind::Foreign(_)) =>
            {
                Outcome::Failed(format!("not checked: {decision}"))
            }
            _ => Outcome::Skipped(decision.to_string(), checked.fixed.applied),
        },
        Some(error @ Unread::NotGlsl) if !is_asked_for(input, run) => {
            Outcome::Skipped(error.to_string(), checked.fixed.applied)
        }
        Some(error @ Unread::Export(_)) if !input.is_explicit => {
            Outcome::Skipped(error.to_string(), checked.fixed.applied)
        }
        Some(error) => Outcome::Failed(error.to_string()),
    }
}

/// Whether an input that is not checked is an error: it is named or piped as GLSL. When fixing,
/// standard input is passed on instead.
fn is_asked_for(input: &InputFile, run: &CheckRun) -> bool {
    let is_passed_on = input.path.is_none() && run.mode.fix.is_some();
    input.is_explicit && is_searched(&input.name) && !is_passed_on
}

/// The result of an earlier run, if nothing has changed since.
fn known(
    (cache, key): (&FindingCache, Key),
    content: &Content,
    options: &Options,
) -> Option<CheckedInput> {
    let (report, scope, offer) = cache.find(key, options)?.report(&content.text)?;
    let text = CheckedText {
        report,
        scope,
        offer,
    };
    Some(CheckedInput {
        text,
        fixed: FixOutcome::default(),
    })
}

/// Keeps a result for later runs, unless it depends on the whole repository, or there is nothing to
/// keep because the text was not checked.
fn keep(
    (cache, key): (&FindingCache, Key),
    checked: &CheckedInput,
    (content, options): (&Content, &Options),
    recorder: Recorder<'_>,
) {
    let Some(asked) = recorder.asked() else {
        return;
    };
    let report = &checked.text.report;
    let is_left_out = report.shaders.is_empty() && !report.embedded().is_empty();
    if report.language.is_some() || is_left_out {
        return;
    }
    let depends_on = asked.into_iter().map(|question| {
        let digest = cache.answers.digest(&question, options);
        (question, digest)
    });
    let CheckedText {
        report,
        scope,
        offer,
    } = &checked.text;
    let result = (report, scope, *offer);
    cache.keep(key, &Entry::of(result, &content.text, depends_on.collect()));
}

/// Fixes and checks one input.
fn fix_and_check(
    input: &InputFile,
    content: &Content,
    (options, files): (&Options, &dyn Files),
    run: &CheckRun,
) -> CheckedInput {
    let name = &input.name;
    let (text, fixed) = match run.mode.fix {
        Some(fix_mode) => fix_mode.apply(input, content, options, &run.disk),
        None => (None, FixOutcome::default()),
    };
    let written = text.map(|text| Content::utf8(&text));
    let content = written.as_ref().unwrap_or(content);
    let recognition = run
        .mode
        .shows_readings
        .then(|| match run.configs.names_host() {
            true => Recognition::Never,
            false => Recognition::WhereComposed,
        });
    CheckedInput {
        text: commands::check((name, content), (options, files), &fixed.left, recognition),
        fixed,
    }
}
