//! Checks all inputs in parallel and prints their findings in order.

use super::super::command::{CLEAN, FAILED, FINDINGS, complain};
use super::super::config::configs;
use super::super::global::{Talk, given};
use super::super::input::{InputFile, collect};
use super::args::CheckArgs;
use super::baseline::{self, Baseline};
use super::cache::FindingCache;
use super::fix::{AppliedFixes, FixMode};
use super::inputs::{CheckMode, CheckedInput, Outcome, check_all};
use super::verbose;
use crate::commands::{self, CheckedText, FindingKey, rule_page};
use crate::diagnostic::Diagnostic;
use crate::engine::Offer;
use crate::engine::config::Configs;
use crate::lint::Proof;
use crate::report::{Format, Reporter, Summary};
use crate::text::path::slashed;
use std::collections::{BTreeMap, HashSet};
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::sync::Arc;

/// Checks the paths once.
pub fn check(args: &CheckArgs) -> io::Result<u8> {
    let talk = given().talk();
    let configs = configs(args.asked());
    if let Some(message) = configs.problem() {
        complain(&message);
        return Ok(FAILED);
    }
    let collected = collect(&args.paths, args.stdin_filename.as_deref(), &configs);
    collected.problems.iter().for_each(|p| complain(p));
    let failed = !collected.problems.is_empty();
    let inputs = &collected.inputs;
    if inputs.is_empty() && !failed && talk >= Talk::Normal {
        complain("warning: no shaders found in the given paths");
    }
    if args.write_baseline.is_some() {
        return baseline::write(args, inputs, &configs);
    }
    let (summary, read_all) = check_inputs(args, inputs, &configs)?;
    if talk == Talk::Verbose {
        verbose::passed_over(&collected.passed_over);
    }
    let max_warnings = match args.max_warnings {
        None if args.deny_warnings => 0,
        None => usize::MAX,
        Some(max) => max,
    };
    let is_too_much = summary.errors > 0 || summary.failing > 0 || summary.warnings > max_warnings;
    Ok(match () {
        () if failed || !read_all => FAILED,
        () if is_too_much && !args.exit_zero => FINDINGS,
        () => CLEAN,
    })
}

/// Checks all inputs in parallel and prints their findings in order. The flag says whether every
/// input could be read and written.
fn check_inputs(
    args: &CheckArgs,
    inputs: &[InputFile],
    configs: &Configs,
) -> io::Result<(Summary, bool)> {
    let fix_mode = FixMode::of(args);
    let baseline = args.baseline.as_deref().map(Baseline::load).transpose()?;
    // The first round prints diffs or fixed text instead of findings.
    let prints_text = fix_mode.is_some_and(|m| m.prints(inputs));
    let format = if prints_text {
        Format::Short
    } else {
        args.format()
    };
    let mut printer = FindingPrinter {
        reporter: reporter(format, prints_text),
        talk: given().talk(),
        configs,
        baseline,
        reported: Vec::new(),
        left: BTreeMap::new(),
        printed: HashSet::new(),
        requires_shaders: !args.force_exclude,
        all_well: true,
    };
    let mut remaining_fix_mode = fix_mode;
    // Files include each other, so all fixes are applied before findings are printed.
    if let Some(fix_mode) = fix_mode.filter(|m| m.writes() && !prints_text) {
        let all = fix_all(inputs, configs, fix_mode)?;
        printer.reporter.add_fixed(all.fixed);
        for (name, proofs) in &all.proofs {
            printer.proofs(name, proofs)?;
        }
        for message in all.refused {
            printer.print_message(&message)?;
            printer.all_well = false;
        }
        printer.left = all.left;
        remaining_fix_mode = None;
    }
    // Fixes and baselines are about more of a report than the cache keeps.
    let is_cached =
        fix_mode.is_none() && args.baseline.is_none() && given().talk() != Talk::Verbose;
    let cache = (is_cached && !args.no_cache)
        .then(FindingCache::here)
        .flatten();
    let mode = CheckMode {
        fix: remaining_fix_mode,
        shows_readings: printer.reporter.shows_readings(),
        requires_shaders: printer.requires_shaders,
        cache: cache.as_ref(),
    };
    check_all(inputs, configs, mode, &mut |input, outcome| {
        printer.outcome(input, outcome)
    })?;
    if printer.talk >= Talk::Normal
        && let Some(baseline) = &printer.baseline
    {
        baseline.stale().iter().for_each(|s| complain(s));
    }
    let summary = printer.reporter.finish()?;
    Ok((summary, printer.all_well))
}

/// The reporter of a run. It writes to standard error if fixed text takes standard output.
fn reporter(format: Format, prints_text: bool) -> Reporter<BufWriter<Box<dyn Write>>> {
    let out: Box<dyn Write> = match given().talk() {
        Talk::Nothing => Box::new(io::sink()),
        _ if prints_text => Box::new(io::stderr()),
        _ => Box::new(io::stdout().lock()),
    };
    let here = slashed(std::env::current_dir().unwrap_or_default());
    let out = BufWriter::with_capacity(1 << 16, out);
    let reporter = Reporter::new(format, out, given().color.is_on())
        .with_pages(rule_page)
        .inside(&here);
    match given().talk() {
        Talk::Nothing | Talk::Findings => reporter.without_summary(),
        Talk::Normal | Talk::Verbose => reporter.summing_up(given().talk() == Talk::Verbose),
    }
}

/// Prints the outcomes of inputs.
struct FindingPrinter<'a> {
    reporter: Reporter<BufWriter<Box<dyn Write>>>,
    talk: Talk,
    configs: &'a Configs,
    baseline: Option<Baseline>,
    /// Configuration errors that were printed already.
    reported: Vec<Arc<str>>,
    /// By input: the findings whose fixes were not applied.
    left: BTreeMap<String, Vec<Diagnostic>>,
    /// The findings that were printed: several files may include the same one.
    printed: HashSet<FindingKey>,
    /// Whether it is an error if a named file has no shader: not if a hook names all files.
    requires_shaders: bool,
    /// Whether every input could be read and written.
    all_well: bool,
}

impl FindingPrinter<'_> {
    fn outcome(&mut self, input: &InputFile, outcome: Outcome) -> io::Result<()> {
        let CheckedInput {
            text: checked,
            fixed,
        } = match outcome {
            Outcome::Checked(checked) => *checked,
            Outcome::Skipped(reason, applied) => {
                let is_printed = input.is_explicit && self.talk >= Talk::Normal;
                if is_printed || self.talk == Talk::Verbose {
                    self.print_message(&format!("{}: skipped: {reason}", input.name))?;
                }
                // Standard input is passed through unchanged.
                return applied.map_or(Ok(()), |m| self.applied(input, m));
            }
            Outcome::Failed(message) => {
                self.all_well = false;
                return self.print_message(&format!("{}: {message}", input.name));
            }
            Outcome::Misconfigured(message) => {
                self.all_well = false;
                if self.reported.contains(&message) {
                    return Ok(());
                }
                self.print_message(&message)?;
                self.reported.push(message);
                return Ok(());
            }
        };
        if self.talk == Talk::Verbose {
            self.reporter.flush()?;
            verbose::read(input, &checked.report, self.configs);
        }
        if let Some(language) = checked.report.language
            && checked.report.counted_infos > 0
            && input.is_explicit
            && self.talk == Talk::Normal
        {
            self.print_message(&format!(
                "{}: not checked: {}",
                input.name,
                language.shader()
            ))?;
        }
        if self.lacks_shaders(input, &checked) {
            self.all_well = false;
            let why = "not checked: it contains no text that is certainly GLSL";
            self.print_message(&format!("{}: {why}", input.name))?;
        }
        self.proofs(&input.name, &fixed.proofs)?;
        if let Some(applied) = fixed.applied {
            self.applied(input, applied)?;
        }
        self.report(input, checked)
    }

    /// Whether a named file is a document without shaders, not even such as are left out.
    fn lacks_shaders(&self, input: &InputFile, checked: &CheckedText) -> bool {
        let report = &checked.report;
        let is_named = self.requires_shaders && input.is_explicit && input.path.is_some();
        let has_shaders = checked.scope.shaders > 0 || !report.embedded().is_empty();
        is_named && !has_shaders && report.language.is_none() && report.diagnostics.is_empty()
    }

    /// Prints a message on standard error.
    fn print_message(&mut self, message: &str) -> io::Result<()> {
        self.reporter.flush()?;
        complain(message);
        Ok(())
    }

    /// With `-v`, prints how fixes were verified to keep the image.
    fn proofs(&mut self, name: &str, proofs: &[Proof]) -> io::Result<()> {
        match verbose::proofs(proofs) {
            Some(printed) if self.talk == Talk::Verbose => {
                self.print_message(&format!("{name}: {printed}"))
            }
            _ => Ok(()),
        }
    }

    fn applied(&mut self, input: &InputFile, applied: AppliedFixes) -> io::Result<()> {
        match applied {
            AppliedFixes::Written(count) => {
                self.reporter.add_fixed(count);
                Ok(())
            }
            AppliedFixes::Text(text) => io::stdout().lock().write_all(text.as_bytes()),
            AppliedFixes::Refused(message) => {
                self.all_well = false;
                self.print_message(&format!("{}: {message}", input.name))
            }
        }
    }

    fn report(&mut self, input: &InputFile, mut checked: CheckedText) -> io::Result<()> {
        if let Some(left) = self.left.get(&input.name) {
            checked.report.leave_alone(left);
            checked.offer = Offer::of(&checked.report);
        }
        let options = self.configs.options(Path::new(&input.name)).ok();
        let settings = options.as_ref().map(|o| &*o.settings);
        let baseline = self.baseline.as_mut();
        commands::print(
            &mut self.reporter,
            (&input.name, checked),
            settings,
            &mut self.printed,
            |report| {
                if let Some(baseline) = baseline {
                    baseline.filter(&input.name, &report.sources, &mut report.diagnostics);
                }
            },
        )
    }
}

/// The results of fixing all inputs.
#[derive(Default)]
struct AllFixed {
    /// The number of fixed findings.
    fixed: usize,
    /// Messages about files that could not be written.
    refused: Vec<String>,
    /// By input: whether the image was verified to stay the same.
    proofs: BTreeMap<String, Vec<Proof>>,
    /// By input: the findings whose fixes were not applied.
    left: BTreeMap<String, Vec<Diagnostic>>,
}

/// Fixes all inputs that are files.
fn fix_all(inputs: &[InputFile], configs: &Configs, fix_mode: FixMode) -> io::Result<AllFixed> {
    /// Fixing a file may allow more fixes in the files that include it.
    const ROUNDS: usize = 3;
    let mode = CheckMode {
        fix: Some(fix_mode),
        ..CheckMode::default()
    };
    let mut all = AllFixed::default();
    for round in 0..ROUNDS {
        let before = all.fixed;
        let mut includes = false;
        check_all(inputs, configs, mode, &mut |input, outcome| {
            if let Outcome::Checked(checked) = outcome {
                let CheckedInput {
                    text,
                    fixed: fix_outcome,
                } = *checked;
                includes |= text.report.includes();
                let proofs = all.proofs.entry(input.name.clone()).or_default();
                proofs.extend(fix_outcome.proofs);
                all.left.insert(input.name.clone(), fix_outcome.left);
                match fix_outcome.applied {
                    Some(AppliedFixes::Written(count)) => all.fixed += count,
                    Some(AppliedFixes::Refused(message)) if round == 0 => {
                        all.refused.push(format!("{}: {message}", input.name));
                    }
                    _ => {}
                }
            }
            Ok(())
        })?;
        if all.fixed == before || !includes {
            break;
        }
    }
    all.left.retain(|_, left| !left.is_empty());
    Ok(all)
}
