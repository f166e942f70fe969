//! `reduce`: minimises a shader while keeping a diagnostic.

use super::super::command::{CLEAN, FAILED, complain};
use super::super::config::configs;
use super::super::disk::Disk;
use super::super::evidence;
use super::super::output::{self, Overwrite};
use crate::diagnostic::Severity;
use crate::engine::check;
use crate::engine::config::{ConfigArgs, Selection};
use crate::lint::{Infos, rule_name};
use crate::rules::page;
use crate::syntax::reduce;
use std::collections::BTreeSet;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Minimise a shader while keeping a diagnostic.
#[derive(clap::Args, Debug)]
pub struct ReduceArgs {
    /// Shader to minimise
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Shell command that exits with code 0 for every candidate to keep; `{}` is replaced with the
    /// path
    ///
    /// Without --keep and --rule, the compile errors of the shader are kept.
    #[arg(long, value_name = "COMMAND")]
    keep: Option<String>,
    /// Keep a finding of this rule or compile error
    #[arg(long, value_name = "NAME", conflicts_with = "keep")]
    rule: Vec<String>,
    /// Maximum number of candidates to test
    #[arg(long, value_name = "N", default_value_t = 10_000)]
    tries: usize,
    /// File to write instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Whether a candidate still shows what is to be kept.
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
                format!("{name}: `{command}` does not exit with code 0 for the original file")
            }
            None => format!("{name}: not all of the given rules report a finding"),
        });
    }
    let left = reduce(&text, args.tries, &mut *keeps);
    let (before, after) = (text.len(), left.text.len());
    complain(&format!(
        "{name}: reduced from {before} to {after} bytes in {} attempts",
        left.tries
    ));
    Ok(left.text)
}

/// Keeps candidates for which the command exits with code 0.
fn by_command(command: &str, file: &Path) -> Result<Keeps, String> {
    if !command.contains("{}") {
        return Err("the command has no `{}` placeholder for the file path".to_string());
    }
    let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
    // The same file name, because the extension determines the stage.
    let path = folder
        .path()
        .join(file.file_name().unwrap_or("a.glsl".as_ref()));
    let command = command.replace("{}", &quoted(&path));
    Ok(Box::new(move |text| {
        // Moved into the closure: dropping it would delete the folder.
        let _ = &folder;
        fs::write(&path, text).is_ok() && shell(&command)
    }))
}

/// Whether the system's shell runs the command with exit code 0.
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

/// A path, quoted as one argument of the shell.
fn quoted(path: &Path) -> String {
    let text = path.display().to_string();
    if cfg!(windows) {
        format!("\"{text}\"")
    } else {
        format!("'{}'", text.replace('\'', r"'\''"))
    }
}

/// Keeps one finding of each named rule or, without names, the same set of errors.
fn by_findings(args: &ReduceArgs, name: String, text: &str) -> Result<Keeps, String> {
    if let Some(unknown) = args.rule.iter().find(|n| page(n).is_none()) {
        return Err(format!("unknown rule or compile error `{unknown}`"));
    }
    let requested: BTreeSet<String> = args.rule.iter().map(|n| rule_name(n).to_string()).collect();
    let select = match requested.is_empty() {
        true => Vec::new(),
        false => vec!["all".to_string()],
    };
    let configs = configs(ConfigArgs {
        given: Selection {
            select,
            infos: Infos::Shown,
            ..Selection::default()
        },
        ..ConfigArgs::default()
    });
    let options = configs.options(&args.file).map_err(|e| e.to_string())?;
    let disk = Disk::new();
    evidence::file(&name, text, &configs);
    let found = move |text: &str, errors_only: bool| -> BTreeSet<String> {
        let all = check(&name, text, &options, &disk).diagnostics;
        let all = all
            .iter()
            .filter(|d| !errors_only || d.severity == Severity::Error);
        all.map(|d| d.rule.to_string()).collect()
    };
    if !requested.is_empty() {
        return Ok(Box::new(move |text| {
            found(text, false).is_superset(&requested)
        }));
    }
    let errors = found(text, true);
    if errors.is_empty() {
        let message = "no errors to keep; use --rule NAME or --keep COMMAND";
        return Err(format!("{}: {message}", args.file.display()));
    }
    Ok(Box::new(move |text| found(text, true) == errors))
}
