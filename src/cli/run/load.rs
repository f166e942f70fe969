//! Loads a shader and reports its errors.

use super::args::RunArgs;
use crate::cli::config::configs;
use crate::cli::disk::Disk;
use crate::cli::global::given;
use crate::cli::port;
use crate::commands::run::Loaded;
use crate::diagnostic::Severity;
use crate::engine::config::ConfigArgs;
use crate::engine::{check, scripted, set_from_scripts};
use crate::project::{Composed, add_stand_ins};
use crate::report::{Format, Reporter};
use crate::text::path::slashed;
use std::io;
use std::path::{Path, PathBuf};

/// Why nothing was drawn.
#[derive(Debug)]
pub enum Trouble {
    /// The shader has errors, which were printed.
    Errors,
    /// Another reason, as a message.
    Words(String),
}

impl From<String> for Trouble {
    fn from(words: String) -> Trouble {
        Trouble::Words(words)
    }
}

impl From<io::Error> for Trouble {
    fn from(error: io::Error) -> Trouble {
        Trouble::Words(error.to_string())
    }
}

/// Why a file cannot be drawn.
pub enum Undrawable {
    /// The passes have errors.
    Errors(Box<Composed>),
    /// Another reason, as a message.
    Words(String),
}

/// A shader without errors, and the files that were read.
pub struct LoadedFiles {
    /// The shader.
    pub shader: Loaded,
    /// The files, which must not be overwritten.
    pub read: Vec<PathBuf>,
}

/// Loads a shader. Its errors are printed as the linter prints them.
pub fn load(path: &Path, args: &RunArgs, format: Format) -> Result<LoadedFiles, Trouble> {
    let name = slashed(path);
    match read(path, args.input.host.as_deref(), &args.input.channels) {
        Ok(loaded) => Ok(loaded),
        Err(Undrawable::Errors(composed)) => {
            if !print_errors(path, &name, format)? {
                print_composed(&composed, format)?;
            }
            Err(Trouble::Errors)
        }
        Err(Undrawable::Words(words)) => {
            match path.is_file() && print_errors(path, &name, format)? {
                true => Err(Trouble::Errors),
                false => Err(Trouble::Words(words)),
            }
        }
    }
}

/// Loads a shader, as the dialect `from` if that is given, with the channels of the command line.
pub fn read(
    path: &Path,
    from: Option<&str>,
    channels: &[String],
) -> Result<LoadedFiles, Undrawable> {
    let name = slashed(path);
    let wrong = |e| Undrawable::Words(format!("{name}: {e}"));
    let opened = port::draft(path, from, channels);
    let (draft, composed) = opened.map_err(Undrawable::Words)?;
    let (mut project, mut read) = (draft.project, draft.read);
    if path.is_file() {
        let text = port::read_text(path).map_err(Undrawable::Words)?;
        let options = configs(ConfigArgs::default()).options(path);
        let options = options.map_err(|e| Undrawable::Words(e.to_string()))?;
        let values = scripted(&name, &text, &options, &Disk::new());
        set_from_scripts(&mut project, &values);
    }
    let put = port::put_channels(&mut project, &draft.orders);
    let (files, remarks) = put.map_err(Undrawable::Words)?;
    read.extend(files);
    read.extend(path.is_file().then(|| path.to_path_buf()));
    project.notes.extend(remarks);
    add_stand_ins(&mut project);
    let composed = project.renew(composed, &name).map_err(wrong)?;
    if composed.has_errors() {
        return Err(Undrawable::Errors(Box::new(composed)));
    }
    Ok(LoadedFiles {
        shader: Loaded {
            name,
            project,
            composed,
        },
        read,
    })
}

/// Prints the errors that the linter finds; returns whether there are any.
fn print_errors(path: &Path, name: &str, format: Format) -> Result<bool, Trouble> {
    // The error may be in another pass.
    if !path.is_file() {
        return Ok(false);
    }
    let text = port::read_text(path)?;
    let options = configs(ConfigArgs::default()).options(path);
    let options = options.map_err(|e| e.to_string())?;
    let mut report = check(name, &text, &options, &Disk::new());
    report.diagnostics.retain(|d| d.severity == Severity::Error);
    if !report.diagnostics.is_empty() {
        let mut reporter = Reporter::new(format, io::stdout().lock(), given().color.is_on());
        reporter.file(name, &report.sources, &report.diagnostics)?;
        reporter.finish()?;
    }
    Ok(!report.diagnostics.is_empty())
}

/// Prints the errors of the composed sources, including the code around the shader.
fn print_composed(composed: &Composed, format: Format) -> Result<(), Trouble> {
    let all = composed.units.iter().map(|unit| composed.analysis(unit));
    let found = all.flat_map(|checked| &checked.diagnostics);
    let mut errors: Vec<_> = found
        .filter(|d| d.severity == Severity::Error)
        .cloned()
        .collect();
    errors.dedup();
    let mut reporter = Reporter::new(format, io::stdout().lock(), given().color.is_on());
    reporter.file("", &composed.sources, &errors)?;
    reporter.finish()?;
    Ok(())
}
