//! `shaderport`.

use super::input::{Content, Encoding, InputFile, read};
use super::output::{Overwrite, write};
use super::{CLEAN, FAILED, FINDINGS};
use crate::diagnostic::Diagnostic;
use crate::port::{Composed, Project, VERTEX, compose, glsl, html};
use crate::report::{Format, Reporter};
use clap::{Parser, ValueEnum};
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

/// Turns ShaderToy code into WebGL2: a shader file or an export in, a page that plays it or plain
/// shaders out.
#[derive(Parser, Debug)]
#[command(name = "shaderport", version, about, max_term_width = 100)]
pub struct Args {
    /// A shader file or a ShaderToy export (.json); `-` is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// File to write; without it a fragment shader goes to standard output
    #[arg(short, long, value_name = "PATH")]
    output: Option<PathBuf>,
    /// What to make; without it the ending of the output tells
    #[arg(short, long, value_enum, value_name = "TARGET")]
    target: Option<Target>,
    /// Write over a file that is there already
    #[arg(long)]
    force: bool,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Target {
    /// One page with everything in it
    Html,
    /// A fragment shader for each pass, and the vertex shader
    Glsl,
}

/// Runs the converter and gives the exit code.
pub fn run(args: &Args) -> u8 {
    match port(args) {
        Ok(code) => code,
        Err(message) => {
            let _ = writeln!(io::stderr(), "shaderport: {message}");
            FAILED
        }
    }
}

fn port(args: &Args) -> Result<u8, String> {
    let name = args.input.to_string_lossy().replace('\\', "/");
    let project = load(&args.input, &name).map_err(|e| format!("{name}: {e}"))?;
    let composed = compose(&project, &name).ok_or(format!("{name}: this is too large"))?;
    let has_errors = report(&composed).map_err(|e| e.to_string())?;
    let files = make(args, &project, &composed)?;
    match &args.output {
        Some(_) => {
            let overwrite = if args.force {
                Overwrite::Allowed
            } else {
                Overwrite::Never
            };
            save(&files, overwrite)?;
        }
        None => {
            let text = files.first().map_or("", |(_, text)| text);
            let printed = io::stdout().lock().write_all(text.as_bytes());
            printed.map_err(|e| format!("the shader cannot be written: {e}"))?;
        }
    }
    Ok(if has_errors { FINDINGS } else { CLEAN })
}

fn load(path: &Path, name: &str) -> Result<Project, String> {
    let is_stdin = path.as_os_str() == "-";
    let input = InputFile {
        name: name.to_string(),
        path: (!is_stdin).then(|| path.to_path_buf()),
        is_explicit: true,
    };
    let Content { text, encoding } = read(&input)?;
    match encoding {
        Encoding::Utf16 => return Err("the file is UTF-16; save it as UTF-8".to_string()),
        Encoding::Binary => return Err("the file is no text".to_string()),
        Encoding::Utf8 | Encoding::Damaged(_) => {}
    }
    let is_json = text.trim_start().starts_with(['{', '[']);
    if is_json {
        return Project::from_json(&text).map_err(|e| e.to_string());
    }
    let stem = path
        .file_stem()
        .map_or(String::new(), |s| s.to_string_lossy().into_owned());
    Project::from_shader(&stem, &text).map_err(|e| e.to_string())
}

/// Prints what the browser will say of the passes; tells whether it will refuse one.
fn report(composed: &Composed) -> io::Result<bool> {
    let mut found: Vec<Diagnostic> = Vec::new();
    for unit in &composed.units {
        let problems = composed.analyze(unit).diagnostics;
        found.extend(
            problems
                .into_iter()
                .filter(|d| !found.contains(d))
                .collect::<Vec<_>>(),
        );
    }
    if found.is_empty() {
        return Ok(false);
    }
    let stderr = io::stderr();
    let color = stderr.is_terminal() && std::env::var_os("NO_COLOR").is_none();
    let mut reporter = Reporter::new(Format::Human, stderr.lock(), color);
    reporter.file("", &composed.sources, &found)?;
    Ok(reporter.finish()?.errors > 0)
}

/// The files of the target, by path.
fn make(
    args: &Args,
    project: &Project,
    composed: &Composed,
) -> Result<Vec<(PathBuf, String)>, String> {
    let output = args.output.clone().unwrap_or_default();
    let target = args.target.unwrap_or_else(|| {
        let ending = output.extension().and_then(|e| e.to_str()).unwrap_or("");
        if matches!(ending, "html" | "htm") {
            Target::Html
        } else {
            Target::Glsl
        }
    });
    match target {
        Target::Html => Ok(vec![(output, html(project, composed))]),
        Target::Glsl => shaders(output, project, composed),
    }
}

/// One pass becomes the file named and the vertex shader beside it; several go into a folder.
fn shaders(
    output: PathBuf,
    project: &Project,
    composed: &Composed,
) -> Result<Vec<(PathBuf, String)>, String> {
    let mut passes = glsl(project, composed);
    if passes.len() > 1 {
        let names: Vec<String> = passes.iter().map(|p| p.name.clone()).collect();
        return Err(format!(
            "this has {} passes ({}); write a page, with `-o FILE.html`",
            names.len(),
            names.join(", ")
        ));
    }
    let pass = passes.pop().ok_or("this has no pass")?;
    let vertex = output.with_extension("vert");
    Ok(vec![(output, pass.fragment), (vertex, VERTEX.to_string())])
}

/// Writes all files, or none where one is in the way.
fn save(files: &[(PathBuf, String)], overwrite: Overwrite) -> Result<(), String> {
    let taken = files
        .iter()
        .find(|(path, _)| path.symlink_metadata().is_ok());
    if let (Overwrite::Never, Some((path, _))) = (overwrite, taken) {
        return Err(format!(
            "{} is there already; --force writes over it",
            path.display()
        ));
    }
    for (path, text) in files {
        write(path, text.as_bytes(), overwrite).map_err(|e| format!("{}: {e}", path.display()))?;
    }
    Ok(())
}
