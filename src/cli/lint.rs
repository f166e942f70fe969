//! `shaderlint`.

use super::document::{DialectChoice, DocumentError, Findings, check};
use super::input::{InputFile, collect, read};
use super::{CLEAN, FAILED, FINDINGS};
use crate::lint::Settings;
use crate::report::{Format, Reporter, Summary};
use crate::rules::RULES;
use clap::{Parser, ValueEnum};
use std::collections::BTreeMap;
use std::io::{self, BufWriter, IsTerminal, Write};
use std::panic::catch_unwind;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;

/// Checks GLSL for WebGL2 and ShaderToy. An error means that the browser's compiler refuses the
/// shader; everything else is a warning or an info.
#[derive(Parser, Debug)]
#[command(name = "shaderlint", version, about, max_term_width = 100)]
pub struct Args {
    /// Files and folders to check; `-` is standard input
    #[arg(value_name = "PATH", required = true)]
    paths: Vec<PathBuf>,
    /// How to print the findings
    #[arg(long, value_enum, default_value_t = FormatChoice::Human, value_name = "FORMAT")]
    format: FormatChoice,
    /// What the shaders are written for
    #[arg(long, value_enum, default_value_t, value_name = "DIALECT")]
    dialect: DialectChoice,
    /// Name that stands for standard input in messages, and tells by its ending what it is
    #[arg(long, value_name = "NAME")]
    stdin_filename: Option<String>,
    /// Run these rules or groups too; `all` is every rule
    #[arg(long, value_name = "RULE", value_delimiter = ',')]
    select: Vec<String>,
    /// Do not run these rules or groups
    #[arg(long, value_name = "RULE", value_delimiter = ',')]
    ignore: Vec<String>,
    /// Exit with 1 on warnings too
    #[arg(long)]
    deny_warnings: bool,
    /// When to print in colour
    #[arg(long, value_enum, default_value_t, value_name = "WHEN")]
    color: ColorChoice,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum FormatChoice {
    /// With excerpts of the source
    Human,
    /// One line a finding
    Short,
    /// One JSON object
    Json,
    /// One JSON object a line
    Jsonl,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, ValueEnum)]
enum ColorChoice {
    /// On a terminal, unless the environment says otherwise
    #[default]
    Auto,
    /// Always
    Always,
    /// Never
    Never,
}

impl ColorChoice {
    fn is_on(self) -> bool {
        let is_set = |name: &str| std::env::var_os(name).is_some_and(|v| !v.is_empty());
        match self {
            ColorChoice::Always => true,
            ColorChoice::Never => false,
            ColorChoice::Auto if is_set("NO_COLOR") => false,
            ColorChoice::Auto if is_set("FORCE_COLOR") || is_set("CLICOLOR_FORCE") => true,
            ColorChoice::Auto => {
                let dumb = std::env::var_os("TERM").is_some_and(|t| t == "dumb");
                !dumb && io::stdout().is_terminal()
            }
        }
    }
}

/// Runs the linter and gives the exit code.
pub fn run(args: &Args) -> u8 {
    let settings = match Settings::new(RULES, &args.select, &args.ignore) {
        Ok(settings) => settings,
        Err(unknown) => {
            let near = unknown
                .near
                .map_or(String::new(), |n| format!("; did you mean `{n}`?"));
            complain(&format!(
                "there is no rule or group `{}`{near}",
                unknown.name
            ));
            return FAILED;
        }
    };
    let (inputs, problems) = collect(&args.paths, args.stdin_filename.as_deref());
    problems.iter().for_each(|p| complain(p));
    let failed = !problems.is_empty();
    if inputs.is_empty() && !failed {
        complain("warning: there is no shader in the folders given");
    }
    match judge(args, &inputs, &settings) {
        Ok((summary, read_all)) => {
            if failed || !read_all {
                FAILED
            } else if summary.errors > 0 || (args.deny_warnings && summary.warnings > 0) {
                FINDINGS
            } else {
                CLEAN
            }
        }
        // Whoever reads the output has had enough of it.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => FINDINGS,
        Err(error) => {
            complain(&format!("the findings cannot be written: {error}"));
            FAILED
        }
    }
}

fn complain(message: &str) {
    let _ = writeln!(io::stderr(), "shaderlint: {message}");
}

/// Checks all inputs, several at a time, and prints their findings in order. Says whether all could
/// be read.
fn judge(args: &Args, inputs: &[InputFile], settings: &Settings) -> io::Result<(Summary, bool)> {
    let format = match args.format {
        FormatChoice::Human => Format::Human,
        FormatChoice::Short => Format::Short,
        FormatChoice::Json => Format::Json,
        FormatChoice::Jsonl => Format::Jsonl,
    };
    let out = BufWriter::with_capacity(1 << 16, io::stdout().lock());
    let mut reporter = Reporter::new(format, out, args.color.is_on());
    let mut read_all = true;
    let mut print = |input: &InputFile, outcome: Outcome| match outcome {
        Outcome::Checked(findings) => reporter.file(&findings.sources, &findings.diagnostics),
        Outcome::Skipped => Ok(()),
        Outcome::Failed(message) => {
            complain(&format!("{}: {message}", input.name));
            read_all = false;
            Ok(())
        }
    };
    let threads = std::thread::available_parallelism()
        .map_or(1, usize::from)
        .min(inputs.len());
    if threads <= 1 {
        for input in inputs {
            print(input, examine(input, args.dialect, settings))?;
        }
    } else {
        in_parallel(inputs, threads, args.dialect, settings, &mut print)?;
    }
    Ok((reporter.finish()?, read_all))
}

/// What became of one input.
enum Outcome {
    Checked(Findings),
    /// A JSON file in a folder that is no export.
    Skipped,
    Failed(String),
}

fn in_parallel(
    inputs: &[InputFile],
    threads: usize,
    dialect: DialectChoice,
    settings: &Settings,
    print: &mut impl FnMut(&InputFile, Outcome) -> io::Result<()>,
) -> io::Result<()> {
    let next = AtomicUsize::new(0);
    let (sender, receiver) = mpsc::sync_channel(threads * 4);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            let (next, sender) = (&next, sender.clone());
            scope.spawn(move || {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    let Some(input) = inputs.get(index) else {
                        return;
                    };
                    if sender
                        .send((index, examine(input, dialect, settings)))
                        .is_err()
                    {
                        return;
                    }
                }
            });
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

fn examine(input: &InputFile, dialect: DialectChoice, settings: &Settings) -> Outcome {
    let content = match read(input) {
        Ok(content) => content,
        Err(message) => return Outcome::Failed(message),
    };
    // A fault of this program costs one file its answer, never the others theirs.
    let judged = catch_unwind(|| check(&input.name, content, dialect, settings));
    let Ok(judged) = judged else {
        return Outcome::Failed("shaderlint itself failed on this file; please report it".into());
    };
    match judged {
        Ok(findings) => Outcome::Checked(findings),
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
