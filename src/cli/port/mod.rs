//! `shaderport`.

mod beside;
mod channels;
mod load;
mod media;
mod read;
mod save;
mod serve;
mod watch;
#[cfg(feature = "naga")]
mod whole;

use super::output::{Overwrite, diff};
use super::{CLEAN, FAILED, FINDINGS};
use crate::diagnostic::{Diagnostic, Severity};
use crate::engine::{Original, Repairs, Verified, repairable, verify};
use crate::exec::Equality;
#[cfg(feature = "naga")]
use crate::port::naga::FirstRow;
use crate::port::{Composed, Destination, File, MainChoice, Order, Remark, Target, build, missing};
use crate::report::{Format, Reporter, Summary};
use crate::text::Sources;
use clap::Parser;
use load::Loaded;
pub(super) use load::{draft, in_folder, put_channels};
pub(super) use read::{read_text, shown};
use save::Place;
pub(super) use save::save;
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

/// Turns ShaderToy code into WebGL2: a shader file, a folder of passes or an export in, a page that
/// plays it, a module or plain shaders out.
#[derive(Parser, Debug)]
#[command(name = "shaderport", version, about, max_term_width = 100)]
pub struct PortArgs {
    /// A shader file, a ShaderToy export (.json), a folder or several files whose names tell their
    /// passes (image.glsl, buffer_a.glsl, common.glsl, cubemap.glsl, sound.glsl); `-` is standard
    /// input
    #[arg(value_name = "INPUT")]
    input: Vec<PathBuf>,
    /// File to write, or folder for several shaders; without it the first file goes to standard
    /// output
    #[arg(short, long, value_name = "PATH")]
    output: Option<PathBuf>,
    /// What to make; without it the ending of the output tells
    #[arg(short, long, value_enum, value_name = "TARGET")]
    target: Option<Target>,
    /// Who runs the code, like `shadertoy`, `glsl-sandbox` or `bonzomatic`; without it the code tells.
    /// An unknown name shows all
    #[arg(long, value_name = "NAME", visible_alias = "from")]
    host: Option<String>,
    /// File of a pass, like `image=a.glsl` or `buffer_a=b.glsl`
    #[arg(long, value_name = "PASS=FILE")]
    pass: Vec<String>,
    /// What a channel reads, like `0=keyboard`, `image.1=photo.jpg`, `buffer_a.0=buffer_a` or, by the
    /// name of a sampler, `u_tex0=photo.jpg`; behind it may stand how, like `,nearest,clamp,noflip`
    #[arg(long, value_name = "[PASS.]N=SOURCE")]
    channel: Vec<String>,
    /// Folder with the site's files, such as media/a/x.jpg, to be put into the output
    #[arg(long, value_name = "FOLDER")]
    media: Option<PathBuf>,
    /// Largest file that goes onto a channel and into the output, like `200M`
    #[arg(long, value_name = "SIZE", default_value = "64M", value_parser = read::size_of)]
    max_media: u64,
    /// Leave channels black whose files are not at hand, instead of drawing something like them
    #[arg(long)]
    no_stand_ins: bool,
    /// Write what a host must know of a WGSL, SPIR-V, HLSL or MSL shader beside it, as FILE.json: the
    /// places of uniforms, textures, attributes and varyings
    #[cfg(feature = "naga")]
    #[arg(long)]
    interface: bool,
    /// Which row of the picture a WGSL, SPIR-V, HLSL or MSL shader draws first
    #[cfg(feature = "naga")]
    #[arg(long, value_enum, default_value_t, value_name = "ROW")]
    first_row: FirstRow,
    /// How plain shaders get their `main`
    #[arg(long, value_enum, default_value_t, value_name = "HOW")]
    main: MainChoice,
    /// Read back what is written, and tell by pass whether it draws what the original draws: proved
    /// by the same code, or the same bits on thousands of pixels
    #[arg(long, conflicts_with = "diff")]
    verify: bool,
    /// Do as ShaderToy's player does where two channels read one buffer: the last setting wins; and
    /// where music is not at hand: nothing is on its channel
    #[arg(long)]
    strict_player: bool,
    /// Mend code that does not compile where there is one answer: old GLSL, names that are reserved or
    /// built in, global values that are not constant, missing qualifiers; each repair is told
    #[arg(long)]
    repair: bool,
    /// Show the repairs as a diff, and write nothing
    #[arg(long)]
    diff: bool,
    /// Write over a file that is there already
    #[arg(long)]
    force: bool,
    /// Make the output again whenever a file changes, until it is stopped
    #[arg(long, conflicts_with = "diff")]
    watch: bool,
    /// Show the page at http://127.0.0.1, for programs on this machine alone; with `--watch` it is
    /// drawn anew at each change, and time, sliders and mouse stay
    #[arg(long, value_name = "PORT", num_args = 0..=1, default_missing_value = "4700")]
    #[arg(require_equals = true, conflicts_with_all = ["diff", "output"])]
    serve: Option<u16>,
}

/// Runs the converter and gives the exit code.
pub fn run(args: &PortArgs) -> u8 {
    match port(args) {
        Ok(code) => code,
        Err(message) => {
            let _ = writeln!(io::stderr(), "shaderport: {message}");
            FAILED
        }
    }
}

fn port(args: &PortArgs) -> Result<u8, String> {
    if args.watch || args.serve.is_some() {
        return watch::run(args);
    }
    let made = make(args, None)?;
    if args.is_saved() {
        save(&made.files, args.overwrite(), &made.read)?;
    } else if let Some(first) = made.files.first() {
        print(&first.content)?;
    }
    Ok(made.code)
}

/// What comes of the arguments.
struct Made {
    /// What is to be written; empty where the errors forbid it, and where a diff was printed.
    files: Vec<File>,
    /// The files that it is made of.
    read: Vec<PathBuf>,
    /// The exit code.
    code: u8,
}

/// Ports what the arguments name, and tells what there is to tell. A page that is served knows its
/// version by which it hears of the next.
fn make(args: &PortArgs, version: Option<&str>) -> Result<Made, String> {
    #[cfg(feature = "naga")]
    if let Some(shaders) = whole::load(args)? {
        return whole::make(args, &shaders);
    }
    let Loaded {
        project,
        composed,
        repairs,
        given,
        read,
        notes,
    } = load::load(args)?;
    for remark in project.remarks() {
        let _ = writeln!(io::stderr(), "note: {remark}");
    }
    match args.repair || args.diff || repairs.done.len() < 2 {
        true => tell_repairs(&repairs).map_err(|e| e.to_string())?,
        false => {
            let count = repairs.done.len();
            let _ = writeln!(
                io::stderr(),
                "note: {count} things were mended that WebGL2 does not take; `--diff` shows them"
            );
        }
    }
    let nothing = |code| Made {
        files: Vec::new(),
        read: Vec::new(),
        code,
    };
    if args.diff {
        return print(diff_of(&repairs).as_bytes()).map(|()| nothing(CLEAN));
    }
    let target = args.target()?;
    let place = Place::of(args.output.as_deref(), target, &project.info.name);
    let order = args.order(target, place.output(), version);
    let made = build(&project, &composed, order).map_err(|e| e.to_string())?;
    let analyses = composed.units.iter().map(|u| composed.analysis(u));
    let found = analyses.flat_map(|a| &a.diagnostics);
    let summary = report(&composed.sources, found, &made.remarks).map_err(|e| e.to_string())?;
    if summary.errors > 0 && !args.repair {
        offer_repair(&composed);
    }
    // Other languages are made of what compiles, and of nothing else.
    if target != Target::Glsl && target.is_shaders() && summary.errors > 0 {
        return Ok(nothing(FINDINGS));
    }
    if !target.is_shaders() {
        let missing = missing(&project).into_iter().map(|what| what.to_string());
        for note in notes.into_iter().chain(missing) {
            let _ = writeln!(io::stderr(), "note: {note}");
        }
    }
    let mut code = if summary.errors > 0 { FINDINGS } else { CLEAN };
    if args.verify {
        let passes = verify(&project, &composed, given.as_ref(), target, &made.files)?;
        if !is_verified(passes) {
            code = FINDINGS;
        }
    }
    Ok(Made {
        files: made.files,
        read,
        code,
    })
}

impl PortArgs {
    /// What is to be made, and how.
    fn order<'a>(
        &self,
        target: Target,
        output: Destination<'a>,
        version: Option<&'a str>,
    ) -> Order<'a> {
        Order {
            target,
            main: self.main,
            output,
            version,
            #[cfg(feature = "naga")]
            interface: self.interface,
            #[cfg(feature = "naga")]
            first_row: self.first_row,
        }
    }

    /// What to make: what is asked for, else what the ending of the output tells.
    fn target(&self) -> Result<Target, String> {
        let path = self.output.as_deref().unwrap_or(Path::new(""));
        match (self.target, self.serve) {
            (Some(target), _) => Ok(target),
            (None, Some(_)) if self.output.is_none() => Ok(Target::Html),
            // A folder may have any name.
            (None, _) if path.is_dir() => Ok(Target::of_path(path).unwrap_or(Target::Glsl)),
            (None, _) if path.as_os_str() == "-" => Ok(Target::Glsl),
            (None, _) => Target::of_path(path).map_err(|e| format!("-o {}: {e}", path.display())),
        }
    }

    /// Whether files are written, and not standard output.
    fn is_saved(&self) -> bool {
        self.output
            .as_ref()
            .is_some_and(|path| path.as_os_str() != "-")
    }

    /// Whether a file may be in the way.
    fn overwrite(&self) -> Overwrite {
        match self.force {
            true => Overwrite::Allowed,
            false => Overwrite::Never,
        }
    }
}

fn print(text: &[u8]) -> Result<(), String> {
    let printed = io::stdout().lock().write_all(text);
    printed.map_err(|e| format!("the output cannot be written: {e}"))
}

/// Tells by pass whether what is to be written draws what the original draws.
fn is_verified(passes: Vec<Verified>) -> bool {
    let mut is_so = true;
    for verified in passes {
        let Verified {
            pass,
            original,
            outcome,
        } = verified;
        let said = match &outcome {
            Ok(Equality::Proved) => "the same code".to_string(),
            Ok(Equality::Seen { pixels }) => format!("the same bits on {pixels} pixels"),
            Ok(Equality::Differs { pixel: [x, y], .. }) => {
                format!("another picture than the original, first seen at pixel {x}, {y}")
            }
            Ok(Equality::TooLong) => "not compared: it runs too long".to_string(),
            Err(why) => format!("not compared: {why}"),
        };
        is_so &= matches!(outcome, Ok(Equality::Proved | Equality::Seen { .. }));
        let since = match original {
            Original::Given => "",
            Original::Repaired => " as the repaired text; what was given does not compile",
        };
        let _ = writeln!(io::stderr(), "{pass}: {said}{since}");
    }
    is_so
}

/// All repairs, as a diff.
fn diff_of(repairs: &Repairs) -> String {
    let changed = repairs.changed().map(|(before, after)| {
        let name = match &before.part {
            Some(part) => format!("{}/{part}", before.path),
            None => before.path.clone(),
        };
        diff(&name, &before.text, after)
    });
    changed.collect()
}

/// Prints what was repaired, at the places where it stood.
fn tell_repairs(repairs: &Repairs) -> io::Result<()> {
    if repairs.is_empty() {
        return Ok(());
    }
    let mut reporter = Reporter::new(Format::Human, io::stderr().lock(), is_colored());
    reporter.file("", &repairs.before, &repairs.done)?;
    reporter.finish().map(|_| ())
}

/// Says that `--repair` would help, where it would.
fn offer_repair(composed: &Composed) {
    let help = match repairable(composed) {
        0 => return,
        1 => "help: `--repair` mends one of these; `--diff` shows how".to_string(),
        n => format!("help: `--repair` mends {n} of these; `--diff` shows how"),
    };
    let _ = writeln!(io::stderr(), "{help}");
}

fn is_colored() -> bool {
    io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none()
}

/// Prints what the browser will say of the passes, and why some could not be made as asked for.
fn report<'a>(
    sources: &Sources,
    problems: impl Iterator<Item = &'a Diagnostic>,
    remarks: &[Remark],
) -> io::Result<Summary> {
    let mut found: Vec<Diagnostic> = Vec::new();
    for problem in problems {
        if !found.contains(problem) {
            found.push(problem.clone());
        }
    }
    let mut stderr = io::stderr().lock();
    let mut errors = 0;
    for remark in remarks {
        if sources.text(remark.span).is_empty() {
            let (severity, pass) = (remark.severity.name(), &remark.pass);
            writeln!(stderr, "{severity}: {pass}: {}", remark.message)?;
            errors += usize::from(remark.severity == Severity::Error);
        } else {
            found.push(remark.diagnostic());
        }
    }
    if found.is_empty() {
        return Ok(Summary {
            errors,
            ..Summary::default()
        });
    }
    let mut reporter = Reporter::new(Format::Human, stderr, is_colored());
    reporter.file("", sources, &found)?;
    let mut summary = reporter.finish()?;
    summary.errors += errors;
    Ok(summary)
}
