//! `shaderlint`.

mod args;
mod baseline;
mod examine;
mod explain;
mod mend;
mod watch;

pub use args::Args;

use super::config::Configs;
use super::input::{Collected, InputFile, collect};
use super::{CLEAN, FAILED, FINDINGS};
use crate::report::{Format, Reporter, Summary};
use crate::rules::RULES;
use baseline::Baseline;
use examine::{Outcome, examine_all};
use mend::{Mend, Mended};
use std::io::{self, BufWriter, Write};
use std::sync::Arc;

/// Runs the linter and gives the exit code.
pub fn run(args: &Args) -> u8 {
    let code = match (&args.command, &args.explain) {
        (Some(command), _) => explain::run(command),
        (None, Some(name)) => explain::explain(name),
        (None, None) if args.watch => watch::run(args),
        (None, None) => check(args),
    };
    match code {
        Ok(code) => code,
        // Whoever reads the output has had enough of it.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => FINDINGS,
        Err(error) => {
            complain(&error.to_string());
            FAILED
        }
    }
}

/// Checks the paths once.
fn check(args: &Args) -> io::Result<u8> {
    let configs = Configs::new(args.given(), RULES);
    if let Some(message) = configs.problem() {
        complain(&message);
        return Ok(FAILED);
    }
    let Collected { inputs, problems } =
        collect(&args.paths, args.stdin_filename.as_deref(), &configs);
    problems.iter().for_each(|p| complain(p));
    let failed = !problems.is_empty();
    if inputs.is_empty() && !failed {
        complain("warning: there is no shader in the folders given");
    }
    if args.write_baseline.is_some() {
        return baseline::write(args, &inputs, &configs);
    }
    let (summary, read_all) = judge(args, &inputs, &configs)?;
    Ok(if failed || !read_all {
        FAILED
    } else if summary.errors > 0 || (args.deny_warnings && summary.warnings > 0) {
        FINDINGS
    } else {
        CLEAN
    })
}

fn complain(message: &str) {
    let _ = writeln!(io::stderr(), "shaderlint: {message}");
}

/// Checks all inputs, several at a time, and prints their findings in order. Says whether all could
/// be read and written.
fn judge(args: &Args, inputs: &[InputFile], configs: &Configs) -> io::Result<(Summary, bool)> {
    let mend = Mend::of(args);
    let baseline = args.baseline.as_deref().map(Baseline::load).transpose()?;
    // What is printed of fixes goes first to where the findings would go.
    let prints_text = mend.is_some_and(|m| m.prints(inputs));
    let format = if prints_text {
        Format::Short
    } else {
        args.format()
    };
    let out: Box<dyn Write> = if prints_text {
        Box::new(io::stderr())
    } else {
        Box::new(io::stdout().lock())
    };
    let here = std::env::current_dir().unwrap_or_default();
    let here = here.to_string_lossy().replace('\\', "/");
    let out = BufWriter::with_capacity(1 << 16, out);
    let mut reporter = Reporter::new(format, out, args.color.is_on())
        .with_pages(explain::page)
        .inside(&here)
        .offering_fixes();
    let mut all_well = true;
    let mut told: Vec<Arc<str>> = Vec::new();
    let mut print = |input: &InputFile, outcome: Outcome| -> io::Result<()> {
        let (mut findings, mended) = match outcome {
            Outcome::Checked(findings, mended) => (findings, mended),
            Outcome::Skipped => return Ok(()),
            Outcome::Failed(message) => {
                complain(&format!("{}: {message}", input.name));
                all_well = false;
                return Ok(());
            }
            Outcome::Misconfigured(message) => {
                if !told.contains(&message) {
                    complain(&message);
                    told.push(message);
                }
                all_well = false;
                return Ok(());
            }
        };
        match mended {
            None => {}
            Some(Mended::Left(message)) => complain(&format!("{}: {message}", input.name)),
            Some(Mended::Written(count)) => reporter.add_fixed(count),
            Some(Mended::Text(text)) => io::stdout().lock().write_all(text.as_bytes())?,
            Some(Mended::Refused(message)) => {
                complain(&format!("{}: {message}", input.name));
                all_well = false;
            }
        }
        if let Some(baseline) = &baseline {
            baseline.filter(&input.name, &findings.sources, &mut findings.diagnostics);
        }
        reporter.file(&input.name, &findings.sources, &findings.diagnostics)
    };
    examine_all(inputs, configs, mend, &mut print)?;
    let summary = reporter.finish()?;
    Ok((summary, all_well))
}
