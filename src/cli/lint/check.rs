//! Checks all inputs in parallel and prints their findings in order.

use super::super::command::{CLEAN, FAILED, FINDINGS, complain};
use super::super::config::Configs;
use super::super::input::{InputFile, collect};
use super::args::{LintArgs, Talk};
use super::baseline::{self, Baseline};
use super::examine::{Outcome, examine_all};
use super::mend::{Mend, Mended};
use super::verbose::Recognition;
use super::{explain, verbose};
use crate::diagnostic::{Diagnostic, Severity};
use crate::engine::{Offer, Report, Shader, Wholeness};
use crate::lint::{Proof, Unrun};
use crate::report::{Format, Reporter, Scope, Summary};
use std::collections::{BTreeMap, HashSet};
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::sync::Arc;

/// Checks the paths once.
pub fn check(args: &LintArgs) -> io::Result<u8> {
    let talk = args.talk();
    let tell = |message: &str| {
        if talk > Talk::Nothing {
            complain(message);
        }
    };
    let configs = Configs::new(args.asked());
    if let Some(message) = configs.problem() {
        tell(&message);
        return Ok(FAILED);
    }
    let collected = collect(&args.paths(), args.stdin_filename.as_deref(), &configs);
    collected.problems.iter().for_each(|p| tell(p));
    let failed = !collected.problems.is_empty();
    let inputs = &collected.inputs;
    if inputs.is_empty() && !failed && talk >= Talk::Normal {
        complain("warning: no shaders found in the given paths");
    }
    if args.write_baseline.is_some() {
        return baseline::write(args, inputs, &configs);
    }
    let (summary, read_all) = judge(args, inputs, &configs)?;
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
fn judge(args: &LintArgs, inputs: &[InputFile], configs: &Configs) -> io::Result<(Summary, bool)> {
    let mend = Mend::of(args);
    let baseline = args.baseline.as_deref().map(Baseline::load).transpose()?;
    // The first round prints diffs or fixed text instead of findings.
    let prints_text = mend.is_some_and(|m| m.prints(inputs));
    let format = if prints_text {
        Format::Short
    } else {
        args.format()
    };
    let mut printer = FindingPrinter {
        reporter: reporter(args, format, prints_text),
        talk: args.talk(),
        configs,
        baseline,
        told: Vec::new(),
        left: BTreeMap::new(),
        said: HashSet::new(),
        all_well: true,
    };
    let mut left_to_mend = mend;
    // Files include each other, so all fixes are applied before findings are printed.
    if let Some(mend) = mend.filter(|m| m.writes() && !prints_text) {
        let all = mend_all(inputs, configs, mend)?;
        printer.reporter.add_fixed(all.fixed);
        for (name, proofs) in &all.proofs {
            printer.proofs(name, proofs)?;
        }
        for message in all.refused {
            printer.tell(&message)?;
            printer.all_well = false;
        }
        printer.left = all.left;
        left_to_mend = None;
    }
    examine_all(inputs, configs, left_to_mend, &mut |input, outcome| {
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
fn reporter(
    args: &LintArgs,
    format: Format,
    prints_text: bool,
) -> Reporter<BufWriter<Box<dyn Write>>> {
    let out: Box<dyn Write> = match args.talk() {
        Talk::Nothing => Box::new(io::sink()),
        _ if prints_text => Box::new(io::stderr()),
        _ => Box::new(io::stdout().lock()),
    };
    let here = std::env::current_dir().unwrap_or_default();
    let here = here.to_string_lossy().replace('\\', "/");
    let out = BufWriter::with_capacity(1 << 16, out);
    let reporter = Reporter::new(format, out, args.color.is_on())
        .with_pages(explain::rule_page)
        .inside(&here);
    match args.talk() {
        Talk::Nothing | Talk::Findings => reporter.without_summary(),
        Talk::Normal | Talk::Verbose => reporter.summing_up(),
    }
}

/// Identifies a finding: file, pass and offset, rule, message.
type Said = ((String, Option<String>, u32), &'static str, String);

/// Prints the outcomes of inputs.
struct FindingPrinter<'a> {
    reporter: Reporter<BufWriter<Box<dyn Write>>>,
    talk: Talk,
    configs: &'a Configs,
    baseline: Option<Baseline>,
    /// Configuration errors that were printed already.
    told: Vec<Arc<str>>,
    /// By input: the findings whose fixes were not applied.
    left: BTreeMap<String, Vec<Diagnostic>>,
    /// The findings that were printed: several files may include the same one.
    said: HashSet<Said>,
    /// Whether every input could be read and written.
    all_well: bool,
}

impl FindingPrinter<'_> {
    fn outcome(&mut self, input: &InputFile, outcome: Outcome) -> io::Result<()> {
        let (report, mending, offer) = match outcome {
            Outcome::Checked(report, mending, offer) => (report, mending, offer),
            Outcome::Skipped(reason, mended) => {
                let is_told = input.is_explicit && self.talk >= Talk::Normal;
                if is_told || self.talk == Talk::Verbose {
                    self.tell(&format!("{}: skipped: {reason}", input.name))?;
                }
                // Standard input is passed through unchanged.
                return mended.map_or(Ok(()), |m| self.mended(input, m));
            }
            Outcome::Failed(message) => {
                self.all_well = false;
                return self.tell(&format!("{}: {message}", input.name));
            }
            Outcome::Misconfigured(message) => {
                self.all_well = false;
                if self.told.contains(&message) {
                    return Ok(());
                }
                self.tell(&message)?;
                self.told.push(message);
                return Ok(());
            }
        };
        if self.talk == Talk::Verbose {
            self.tell(&verbose::read(input, &report, self.configs))?;
        }
        self.proofs(&input.name, &mending.proofs)?;
        if let Some(mended) = mending.mended {
            self.mended(input, mended)?;
        }
        self.report(input, *report, offer)
    }

    /// Prints a message on standard error.
    fn tell(&mut self, message: &str) -> io::Result<()> {
        self.reporter.flush()?;
        if self.talk > Talk::Nothing {
            complain(message);
        }
        Ok(())
    }

    /// With `-v`, prints how fixes were verified to keep the image.
    fn proofs(&mut self, name: &str, proofs: &[Proof]) -> io::Result<()> {
        match verbose::proofs(proofs) {
            Some(said) if self.talk == Talk::Verbose => self.tell(&format!("{name}: {said}")),
            _ => Ok(()),
        }
    }

    fn mended(&mut self, input: &InputFile, mended: Mended) -> io::Result<()> {
        match mended {
            Mended::Written(count) => {
                self.reporter.add_fixed(count);
                Ok(())
            }
            Mended::Text(text) => io::stdout().lock().write_all(text.as_bytes()),
            Mended::Refused(message) => {
                self.all_well = false;
                self.tell(&format!("{}: {message}", input.name))
            }
        }
    }

    fn report(
        &mut self,
        input: &InputFile,
        mut report: Report,
        mut offer: Offer,
    ) -> io::Result<()> {
        if let Some(left) = self.left.get(&input.name) {
            report.leave_alone(left);
            offer = Offer::of(&report);
        }
        let options = self.configs.options(Path::new(&input.name)).ok();
        let settings = options.as_ref().map(|o| &o.settings);
        let mut scope = scope_of(&report.shaders);
        scope.left_out = report.left_out;
        if self.reporter.tells_readings() {
            scope.read_as = Some(verbose::reading(
                &input.name,
                &report,
                self.configs,
                Recognition::WhereComposed,
            ));
        }
        let found = &mut report.diagnostics;
        if let Some(settings) = settings {
            let is_error = |d: &&Diagnostic| d.severity == Severity::Error;
            let before = found.iter().filter(is_error).count();
            found.retain(|d| settings.reports(d.rule));
            scope.hidden = before - found.iter().filter(is_error).count();
        }
        let sources = &report.sources;
        found.retain(|d| {
            let Some(file) = sources.file_at(d.span.start) else {
                return true;
            };
            let place = (
                file.path.clone(),
                file.part.clone(),
                d.span.start - file.base,
            );
            self.said.insert((place, d.rule, d.message.clone()))
        });
        if let Some(baseline) = &mut self.baseline {
            let before = found.len();
            baseline.filter(&input.name, &report.sources, found);
            scope.known = before - found.len();
        }
        if scope.known > 0 {
            // Fixes of findings in the baseline are not on offer.
            offer = Offer::of(&report);
        }
        let found = &report.diagnostics;
        self.reporter.add_offer(offer.safe, offer.others);
        if let Some(settings) = settings {
            let failing = found.iter().filter(|d| settings.fails(d.rule));
            scope.failing = failing.map(|d| d.rule).collect();
        }
        self.reporter
            .input(&input.name, &report.sources, found, &scope)
    }
}

/// What was checked, as the summary counts it.
fn scope_of(shaders: &[Shader]) -> Scope {
    let mut scope = Scope {
        shaders: shaders.len(),
        ..Scope::default()
    };
    for shader in shaders {
        scope.open_names.extend(shader.holes.iter().cloned());
        match &shader.unrun {
            Unrun::Functions { names, .. } => scope.unrun_functions.extend(names.iter().cloned()),
            Unrun::Everywhere if shader.has_errors && shader.wholeness == Wholeness::Whole => {
                scope.unrun_shaders += 1;
            }
            Unrun::Everywhere | Unrun::Nowhere => {}
        }
    }
    scope
}

/// The results of fixing all inputs.
#[derive(Default)]
struct AllMended {
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
fn mend_all(inputs: &[InputFile], configs: &Configs, mend: Mend) -> io::Result<AllMended> {
    /// Fixing a file may allow more fixes in the files that include it.
    const ROUNDS: usize = 3;
    let mut all = AllMended::default();
    for round in 0..ROUNDS {
        let before = all.fixed;
        let mut includes = false;
        examine_all(inputs, configs, Some(mend), &mut |input, outcome| {
            if let Outcome::Checked(report, mending, _) = outcome {
                includes |= report.includes();
                let proofs = all.proofs.entry(input.name.clone()).or_default();
                proofs.extend(mending.proofs);
                all.left.insert(input.name.clone(), mending.left);
                match mending.mended {
                    Some(Mended::Written(count)) => all.fixed += count,
                    Some(Mended::Refused(message)) if round == 0 => {
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
