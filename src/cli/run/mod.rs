//! `shaderlint run`: a shader is drawn without a GPU, and what was seen is said.

mod args;
mod compare;
mod facts;
mod font;
mod heat;
mod load;
mod loops;
mod png;
mod progress;
mod sheet;
mod show;
mod terminal;
mod uniforms;

pub use args::RunArgs;

use super::output::Overwrite;
use super::port::save;
use super::{CLEAN, FAILED, FINDINGS};
use crate::engine::play::{Picture, Scene};
use crate::exec::{CompileOptions, Drawn, Stop, Watch};
use crate::port::File;
use crate::report::Format;
use args::{Heat, RunFormat};
use facts::{CostFacts, OutputFacts, RunFacts};
use load::{Loaded, Shot, Trouble, load, shot};
use png::Bitmap;
use progress::Progress;
use std::io::{self, IsTerminal, Write};
use std::path::PathBuf;
use terminal::Palette;

/// Runs the command and gives the exit code.
pub fn run(args: &RunArgs) -> io::Result<u8> {
    match drawn(args) {
        Ok((text, code)) => {
            io::stdout().lock().write_all(text.as_bytes())?;
            Ok(code)
        }
        Err(Trouble::Errors) => Ok(FINDINGS),
        Err(Trouble::Words(words)) => {
            let _ = writeln!(io::stderr(), "shaderlint: {words}");
            Ok(FAILED)
        }
    }
}

/// Does what the arguments ask for. Gives what is printed, and the exit code.
fn drawn(args: &RunArgs) -> Result<(String, u8), Trouble> {
    let format = match args.format {
        RunFormat::Human => Format::Human,
        RunFormat::Json => Format::Json,
    };
    let loaded = load(&args.file, args, format)?;
    let own = shot(&loaded, args, &options(args))?;
    if let Some(path) = &args.compare {
        let other = load(path, args, format)?;
        let other_shot = shot(&other, args, &options(args))?;
        return compared(args, [(&loaded, &own), (&other, &other_shot)]);
    }
    let notes = notes(&own.scene, &loaded);
    if args.format == RunFormat::Human {
        for note in &notes {
            let _ = writeln!(io::stderr(), "note: {note}");
        }
    }
    if let Some(count) = args.sheet {
        let sheet = sheet::draw(&own, args, count)?;
        let written = write(args, &sheet, &loaded.read)?;
        return Ok((show(args, &sheet, written.as_deref()), CLEAN));
    }
    let moment = args.moment();
    let progress = Progress::new(1);
    let drawn = own.drawn(args.size, &moment, args.threads())?;
    drop(progress);
    let bitmap = match (args.heatmap, &args.show) {
        (Some(heat), _) => heat_map(heat, &own, &drawn),
        (None, Some(show)) => show::picture(show, &own, &drawn),
        (None, None) => bitmap(&own, &drawn),
    };
    let output = write(args, &bitmap, &loaded.read)?;
    let mut told = facts_of(&loaded, &own, &drawn, args);
    told.output.clone_from(&output);
    told.notes = notes;
    Ok((
        match args.format {
            RunFormat::Human => show(args, &bitmap, output.as_deref()) + &told.text(),
            RunFormat::Json => told.json(),
        },
        CLEAN,
    ))
}

/// How the shader is compiled for what is asked.
fn options(args: &RunArgs) -> CompileOptions {
    CompileOptions {
        // Nobody asks for the cost of pictures that are only compared, or put on a sheet.
        watch: match args.compare.is_some() || args.sheet.is_some() {
            true => Watch::Nothing,
            false => Watch::Flow,
        },
        ..CompileOptions::default()
    }
}

/// What is to be said of how the shader was read, and of what stays empty.
fn notes(scene: &Scene, loaded: &Loaded) -> Vec<String> {
    let mut notes = loaded.project.notes.clone();
    let quoted = |names: &[&str]| format!("`{}`", names.join("`, `"));
    let zeros = scene.zeros();
    if !zeros.is_empty() {
        let names = quoted(&zeros);
        notes.push(format!(
            "nothing sets these uniforms, so they are zero: {names}; --uniforms sets them"
        ));
    }
    let guessed: Vec<&str> = scene.bound.guessed.iter().map(String::as_str).collect();
    if !guessed.is_empty() {
        let names = quoted(&guessed);
        notes.push(format!(
            "nothing gives these varyings, so they hold the place in the picture: {names}"
        ));
    }
    let samplers: Vec<&str> = scene
        .code
        .samplers
        .iter()
        .map(|s| s.name.as_str())
        .collect();
    if !samplers.is_empty() {
        let names = quoted(&samplers);
        notes.push(format!(
            "nothing is on these samplers, so they are black: {names}"
        ));
    }
    notes
}

/// What the screen shows of a draw.
fn bitmap(shot: &Shot, drawn: &Drawn) -> Bitmap {
    Bitmap {
        size: drawn.size,
        bytes: Picture::of(&shot.scene.code, drawn, 0).bytes(),
    }
}

fn heat_map(heat: Heat, shot: &Shot, drawn: &Drawn) -> Bitmap {
    let counts = |all: &[u32]| all.iter().map(|n| f64::from(*n)).collect::<Vec<_>>();
    let (values, title) = match heat {
        Heat::Steps => (counts(&drawn.turns), "STEPS"),
        Heat::Cost => (counts(&drawn.cost), "OPERATIONS"),
        Heat::Nan => {
            let picture = Picture::of(&shot.scene.code, drawn, 0);
            let is_bad = |pixel: &[f32; 4]| pixel.iter().any(|lane| !lane.is_finite());
            let values = picture
                .pixels
                .iter()
                .map(|p| f64::from(u8::from(is_bad(p))));
            (values.collect(), "NOT FINITE")
        }
    };
    heat::map(drawn.size, &values, title)
}

fn facts_of(loaded: &Loaded, shot: &Shot, drawn: &Drawn, args: &RunArgs) -> RunFacts {
    let code = &shot.scene.code;
    let program = loaded.program(shot);
    let outputs = code.outputs.iter().zip(0..).map(|(slot, at)| {
        let facts = Picture::of(code, drawn, at).facts(&drawn.covered);
        let ty = program.map_or(String::new(), |p| p.type_name(slot.ty));
        let lanes = slot.ty.components();
        OutputFacts::of(&slot.name, (ty, lanes), &facts, drawn.covered.len())
    });
    let moment = args.moment();
    let loops = program.filter(|_| args.report);
    RunFacts {
        schema: 1,
        file: loaded.name.clone(),
        size: drawn.size,
        time: moment.time,
        frame: moment.frame,
        mouse: facts::mouse(&moment),
        output: None,
        outputs: outputs.collect(),
        cost: CostFacts::of(&drawn.seen, &drawn.cost),
        loops: loops.map(|program| loops::rows(program, shot, &drawn.seen)),
        notes: Vec::new(),
    }
}

/// Compares two shaders and says what came of it.
fn compared(args: &RunArgs, both: [(&Loaded, &Shot); 2]) -> Result<(String, u8), Trouble> {
    let names = both.map(|(loaded, _)| loaded.name.as_str());
    let (mut told, picture) = compare::compare(both.map(|(_, shot)| shot), names, args)?;
    let read: Vec<PathBuf> = both.iter().flat_map(|(l, _)| l.read.clone()).collect();
    if let Some(picture) = &picture {
        told.output = write(args, picture, &read)?;
    }
    let code = if told.same { CLEAN } else { FINDINGS };
    Ok((told.print(args.format), code))
}

/// Writes a picture where it was asked for; gives how the file is called.
fn write(args: &RunArgs, bitmap: &Bitmap, read: &[PathBuf]) -> Result<Option<String>, Trouble> {
    let Some(path) = &args.output else {
        return Ok(None);
    };
    let content = bitmap.png()?;
    if path.as_os_str() == "-" {
        io::stdout().lock().write_all(&content)?;
        return Ok(None);
    }
    let overwrite = match args.force {
        true => Overwrite::Allowed,
        false => Overwrite::Never,
    };
    let mut read = read.to_vec();
    read.extend(args.uniforms.clone());
    let file = File {
        path: path.clone(),
        content,
    };
    save(&[file], overwrite, &read)?;
    Ok(Some(super::port::shown(path)))
}

/// The picture as it is drawn in the terminal, where it is not written.
fn show(args: &RunArgs, bitmap: &Bitmap, written: Option<&str>) -> String {
    if written.is_some() || args.format == RunFormat::Json {
        return String::new();
    }
    let is_wanted = args.color.is_on();
    if !io::stdout().is_terminal() && !is_wanted {
        return String::new();
    }
    let palette = match is_wanted {
        true => Palette::of(|name| std::env::var(name).ok()),
        false => Palette::Mono,
    };
    let (columns, lines) =
        terminal_size::terminal_size().map_or((80, 24), |(columns, lines)| (columns.0, lines.0));
    let size = terminal::fit(bitmap.size, u32::from(columns), u32::from(lines.max(8)) - 5);
    if let Some(told) = palette.told() {
        let _ = writeln!(io::stderr(), "note: {told}");
    }
    terminal::draw(&bitmap.shrunk(size), palette)
}

/// What is said of a run that did not come to its end.
fn stopped(stop: &Stop, fuel: u64) -> String {
    match stop {
        Stop::OutOfFuel { pixel: [x, y] } => format!(
            "the run was ended: the pixels around ({x}, {y}) took more than {fuel} operations"
        ),
    }
}

/// What may be meant by a name that is none of some.
fn near(name: &str, all: &[String]) -> String {
    let distances = all
        .iter()
        .map(|n| (strsim::damerau_levenshtein(n, name), n));
    let near = distances.filter(|(distance, _)| *distance <= 2).min();
    near.map_or(String::new(), |(_, n)| format!("; did you mean `{n}`?"))
}
