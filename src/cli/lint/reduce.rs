//! `reduce`: a shader made small while what is reported of it stays.

use super::super::command::{CLEAN, FAILED, complain};
use super::super::output::{self, Overwrite};
use crate::diagnostic::{ERRORS, Severity};
use crate::engine::{DialectChoice, NoFiles, Options, check};
use crate::lint::Settings;
use crate::rules::RULES;
use crate::syntax::reduce;
use std::collections::BTreeSet;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The arguments of `reduce`.
#[derive(clap::Args, Debug)]
pub struct ReduceArgs {
    /// The shader
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Keep what this command exits with 0 for; `{}` is the path of what is tried. Without it, the
    /// errors that shaderlint reports are kept
    #[arg(long, value_name = "COMMAND")]
    keep: Option<String>,
    /// Keep a finding of this rule
    #[arg(long, value_name = "NAME", conflicts_with = "keep")]
    rule: Vec<String>,
    /// Try no more than this
    #[arg(long, value_name = "N", default_value_t = 10_000)]
    tries: usize,
    /// Write to this file, not to standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Whether a text is still of interest.
type Keeps = Box<dyn FnMut(&str) -> bool>;

/// Reduces a file and gives the exit code.
pub fn run(args: &ReduceArgs) -> io::Result<u8> {
    match reduced(args) {
        Ok(text) => {
            match &args.output {
                Some(path) => output::write(path, text.as_bytes(), Overwrite::Never)
                    .map_err(|e| io::Error::other(format!("{}: {e}", path.display())))?,
                None => io::stdout().lock().write_all(text.as_bytes())?,
            }
            Ok(CLEAN)
        }
        Err(message) => {
            complain(&message);
            Ok(FAILED)
        }
    }
}

fn reduced(args: &ReduceArgs) -> Result<String, String> {
    let name = args.file.display().to_string();
    let text = fs::read_to_string(&args.file).map_err(|e| format!("{name}: {e}"))?;
    let mut keeps: Keeps = match &args.keep {
        Some(command) => by_command(command, &args.file)?,
        None => by_findings(args, name.clone(), &text)?,
    };
    if !keeps(&text) {
        return Err(match &args.keep {
            Some(command) => {
                format!("{name}: `{command}` does not exit with 0 for the file itself")
            }
            None => format!("{name}: not all of these rules report something"),
        });
    }
    let left = reduce(&text, args.tries, &mut *keeps);
    let (before, after) = (text.len(), left.text.len());
    complain(&format!(
        "{name}: {before} bytes became {after} in {} tries",
        left.tries
    ));
    Ok(left.text)
}

/// Keeps what a command exits with 0 for.
fn by_command(command: &str, file: &Path) -> Result<Keeps, String> {
    if !command.contains("{}") {
        return Err("the command has no `{}` where the file's path goes".to_string());
    }
    let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
    // The same name, since the ending tells the stage.
    let path = folder
        .path()
        .join(file.file_name().unwrap_or("a.glsl".as_ref()));
    let command = command.replace("{}", &quoted(&path));
    Ok(Box::new(move |text| {
        // The folder lives as long as this does.
        let _ = &folder;
        fs::write(&path, text).is_ok() && shell(&command)
    }))
}

/// Whether the system's shell runs a command to exit code 0.
fn shell(command: &str) -> bool {
    let (program, flag) = if cfg!(windows) {
        ("cmd", "/C")
    } else {
        ("sh", "-c")
    };
    let status = Command::new(program)
        .args([flag, command])
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    status.is_ok_and(|s| s.success())
}

/// A path as one word of the shell.
fn quoted(path: &Path) -> String {
    let text = path.display().to_string();
    if cfg!(windows) {
        format!("\"{text}\"")
    } else {
        format!("'{}'", text.replace('\'', r"'\''"))
    }
}

/// Keeps a finding of each rule that is named, or just the errors that there are.
fn by_findings(args: &ReduceArgs, name: String, text: &str) -> Result<Keeps, String> {
    let known = |n: &str| ERRORS.contains(&n) || RULES.iter().any(|r| r.name == n);
    if let Some(unknown) = args.rule.iter().find(|n| !known(n)) {
        return Err(format!("there is no rule or compile error `{unknown}`"));
    }
    let wanted: BTreeSet<String> = args.rule.iter().cloned().collect();
    let select = match wanted.is_empty() {
        true => Vec::new(),
        false => vec!["all".to_string()],
    };
    let settings = Settings::new(RULES, &select, &[]).map_err(|e| e.name)?;
    let options = Options::new(DialectChoice::Auto, settings);
    let found = move |text: &str, errors_only: bool| -> BTreeSet<String> {
        let all = check(&name, text, &options, &NoFiles).diagnostics;
        let all = all
            .iter()
            .filter(|d| !errors_only || d.severity == Severity::Error);
        all.map(|d| d.rule.to_string()).collect()
    };
    if !wanted.is_empty() {
        return Ok(Box::new(move |text| {
            found(text, false).is_superset(&wanted)
        }));
    }
    let errors = found(text, true);
    if errors.is_empty() {
        let message = "there is no error to keep: name a `--rule`, or a command with `--keep`";
        return Err(format!("{}: {message}", args.file.display()));
    }
    Ok(Box::new(move |text| found(text, true) == errors))
}
