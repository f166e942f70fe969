//! `shaderlint fmt`.

mod args;

pub use args::FormatArgs;

use super::command::{CLEAN, FAILED, FINDINGS};
use super::config::{configs, style};
use super::evidence;
use super::global::given;
use super::input::{InputFile, collect, read};
use super::output::{diff, replace};
use super::parallel::in_order;
use crate::commands::FormatRequest;
use crate::diagnostic::count;
use crate::engine::config::Configs;
use crate::engine::{Formatting, format};
use crate::format::StyleChoice;
use crate::text::{Encoding, LineIndex, apply_edits};
use std::io::{self, Write};
use std::path::Path;

/// Formats the paths and returns the exit code.
pub fn run(args: &FormatArgs) -> io::Result<u8> {
    let configs = configs(args.asked());
    if let Some(message) = configs.problem() {
        complain(&message);
        return Ok(FAILED);
    }
    let collected = collect(&args.paths, args.stdin_filename.as_deref(), &configs);
    collected.problems.iter().for_each(|p| complain(p));
    let inputs = &collected.inputs;
    let mut tally = FormatTally {
        has_failed: !collected.problems.is_empty(),
        ..FormatTally::default()
    };
    let work = |index: usize| {
        inputs
            .get(index)
            .map(|input| (input, examine(input, args.request, &configs)))
    };
    in_order(inputs.len(), &work, &mut |done| match done {
        Some((input, outcome)) => tally.outcome(args, input, outcome),
        None => Ok(()),
    })?;
    if given().quiet == 0 {
        tally.sum_up(args);
    }
    Ok(match (tally.has_failed, args.check && tally.changed > 0) {
        (true, _) => FAILED,
        (false, true) => FINDINGS,
        (false, false) => CLEAN,
    })
}

fn complain(message: &str) {
    let _ = writeln!(io::stderr(), "shaderlint fmt: {message}");
}

/// The result of formatting one input.
enum FormatOutcome {
    /// The old and the new text, and messages about parts that were left as they are.
    Formatted {
        old: String,
        new: String,
        problems: Vec<String>,
    },
    /// The input contains no shader, for this reason; and its text.
    Skipped(String, String),
    Failed(String),
}

/// The number of inputs with each result.
#[derive(Default)]
struct FormatTally {
    changed: usize,
    unchanged: usize,
    has_failed: bool,
}

/// Formats an input without writing it.
fn examine(input: &InputFile, request: FormatRequest, configs: &Configs) -> FormatOutcome {
    let style = match style(configs, Path::new(&input.name), StyleChoice::default()) {
        Ok(style) => request.choice().or(style),
        Err(message) => return FormatOutcome::Failed(message.to_string()),
    };
    let content = match read(input) {
        Ok(content) if content.encoding == Encoding::Utf8 => content,
        Ok(_) => return FormatOutcome::Failed("the file is not valid UTF-8".to_string()),
        Err(message) => return FormatOutcome::Failed(message),
    };
    let old = content.text;
    evidence::file(&input.name, &old, configs);
    let Formatting { edits, left } = match format(&input.name, &old, input.claim, style) {
        Ok(formatting) => formatting,
        Err(decision) => return FormatOutcome::Skipped(decision.to_string(), old),
    };
    let Ok(new) = apply_edits(&old, 0, &edits) else {
        return FormatOutcome::Failed(
            "internal error: edits overlap; the file was not written".to_string(),
        );
    };
    let lines = LineIndex::new(&old);
    let problems = left.iter().map(|why| {
        let place = lines.position(&old, why.span.start);
        format!(
            "{}:{}:{}: not formatted: {}",
            input.name, place.line, place.column, why.message
        )
    });
    FormatOutcome::Formatted {
        problems: problems.collect(),
        old,
        new,
    }
}

impl FormatTally {
    fn outcome(
        &mut self,
        args: &FormatArgs,
        input: &InputFile,
        outcome: FormatOutcome,
    ) -> io::Result<()> {
        match outcome {
            FormatOutcome::Formatted { old, new, problems } => {
                problems.iter().for_each(|p| complain(p));
                match (old == new, problems.is_empty()) {
                    (false, _) => self.changed += 1,
                    (true, true) => self.unchanged += 1,
                    (true, false) => {}
                }
                self.has_failed |= !problems.is_empty();
                self.formatted(args, input, &old, &new)
            }
            FormatOutcome::Skipped(reason, text) => {
                if input.is_explicit && given().quiet == 0 {
                    complain(&format!("{}: skipped: {reason}", input.name));
                }
                // Standard input is passed through unchanged.
                match input.path.is_none() && !args.check && !args.diff {
                    true => io::stdout().lock().write_all(text.as_bytes()),
                    false => Ok(()),
                }
            }
            FormatOutcome::Failed(message) => {
                self.has_failed = true;
                complain(&format!("{}: {message}", input.name));
                Ok(())
            }
        }
    }

    fn formatted(
        &mut self,
        args: &FormatArgs,
        input: &InputFile,
        old: &str,
        new: &str,
    ) -> io::Result<()> {
        let mut out = io::stdout().lock();
        if args.check && old != new {
            let same = old.lines().zip(new.lines()).take_while(|(a, b)| a == b);
            writeln!(out, "{}:{}: not formatted", input.name, same.count() + 1)?;
        }
        if args.diff && old != new {
            out.write_all(diff(&input.name, old, new).as_bytes())?;
        }
        match &input.path {
            _ if args.check || args.diff => Ok(()),
            None => out.write_all(new.as_bytes()),
            Some(path) if old != new => {
                if let Err(error) = replace(path, old.as_bytes(), new.as_bytes()) {
                    self.has_failed = true;
                    self.changed -= 1;
                    complain(&format!("{}: cannot write the file: {error}", input.name));
                }
                Ok(())
            }
            Some(_) => Ok(()),
        }
    }

    fn sum_up(&self, args: &FormatArgs) {
        let files = |n| count(n, "file");
        let would = match args.check || args.diff {
            true => "would be reformatted",
            false => "reformatted",
        };
        let message = match (self.changed, self.unchanged) {
            (0, 0) => return,
            (0, n) => format!("{} already formatted", files(n)),
            (n, 0) => format!("{} {would}", files(n)),
            (n, m) => format!("{} {would}, {m} already formatted", files(n)),
        };
        complain(&message);
    }
}
