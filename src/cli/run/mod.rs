//! `shaderlint run`: draws a shader without a GPU and prints statistics.

mod args;
mod columns;
mod compare;
mod facts;
mod font;
mod functions;
mod heat;
mod image_file;
mod load;
mod loops;
mod numbers;
mod place;
mod png;
mod progress;
mod sheet;
mod show;
mod terminal;
mod uniforms;

pub use args::RunArgs;
pub(super) use args::{Heat, ShotSetting, size_of, time_of};
pub(super) use columns::{percent, seconds};
pub(super) use heat::{map, short};
pub(super) use image_file::decode;
pub(super) use load::{Shot, Trouble, Undrawable, read, shot};
pub(super) use place::position;
pub(super) use png::Bitmap;
pub(super) use progress::Progress;

use super::command::{CLEAN, FAILED, FINDINGS};
use super::output::Overwrite;
use super::port::save;
use crate::engine::playback::RenderedImage;
use crate::exec::Drawn;
use crate::port::File;
use crate::report::Format;
use args::RunFormat;
use facts::{CostFacts, OutputFacts, RunFacts};
use load::{Loaded, load};
use std::io::{self, IsTerminal, Write};
use std::path::PathBuf;
use terminal::Palette;

/// Runs the command and returns the exit code.
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

/// Draws the shader. Returns the text to print and the exit code.
fn drawn(args: &RunArgs) -> Result<(String, u8), Trouble> {
    let format = match args.format {
        RunFormat::Human => Format::Human,
        RunFormat::Json => Format::Json,
    };
    refuse_other_images(args)?;
    let loaded = load(&args.file, args, format)?;
    let mut own = shot(&loaded, &args.setting())?;
    if let Some(path) = &args.compare {
        let other = load(path, args, format)?;
        let mut other_shot = shot(&other, &args.setting())?;
        return compared(args, [(&loaded, &mut own), (&other, &mut other_shot)]);
    }
    let notes = own.notes(&loaded.project);
    if args.format == RunFormat::Human {
        for note in &notes {
            let _ = writeln!(io::stderr(), "note: {note}");
        }
    }
    if let Some(count) = args.sheet {
        let sheet = sheet::draw(&mut own, args, count)?;
        let written = write(args, &sheet, &loaded.read)?;
        return Ok((show(args, &sheet, written.as_deref()), CLEAN));
    }
    let moment = args.moment();
    let progress = Progress::new(1);
    let drawn = own.drawn(&moment, &progress)?;
    drop(progress);
    let image = RenderedImage::of(own.code(), &drawn, 0);
    let bitmap = match (args.heatmap, &args.show) {
        (Some(heat), _) => heat_map(heat, &image, &drawn),
        (None, Some(show)) => show::render(show, own.code(), &drawn),
        (None, None) => bitmap(&image),
    };
    let output = write(args, &bitmap, &loaded.read)?;
    let mut facts = facts_of(&loaded, &own, (&drawn, &image), args);
    facts.output.clone_from(&output);
    facts.notes = notes;
    Ok((
        match args.format {
            RunFormat::Human => show(args, &bitmap, output.as_deref()) + &facts.text(),
            RunFormat::Json => facts.json(),
        },
        CLEAN,
    ))
}

/// An image as 8-bit colours.
fn bitmap(image: &RenderedImage) -> Bitmap {
    Bitmap {
        size: image.size,
        bytes: image.bytes(),
    }
}

fn heat_map(heat: Heat, image: &RenderedImage, drawn: &Drawn) -> Bitmap {
    let counts = |all: &[u32]| all.iter().map(|n| f64::from(*n)).collect::<Vec<_>>();
    let (values, title) = match heat {
        Heat::Steps => (counts(&drawn.iterations), "STEPS"),
        Heat::Cost => (counts(&drawn.cost), "OPERATIONS"),
        Heat::Overdraw => {
            let waited = |(own, all): (&u32, &u32)| match *all {
                0 => 0.0,
                all => 100.0 * f64::from(all - own.min(&all)) / f64::from(all),
            };
            let pairs = drawn.cost.iter().zip(&drawn.ran);
            (pairs.map(waited).collect(), "OVERDRAW IN 8X4, %")
        }
        Heat::Nan => {
            let is_bad = |pixel: &[f32; 4]| pixel.iter().any(|lane| !lane.is_finite());
            let values = image.pixels.iter().map(|p| f64::from(u8::from(is_bad(p))));
            (values.collect(), "NOT FINITE")
        }
    };
    heat::map(drawn.size, &values, title)
}

/// The facts of a frame; `image` is its first output.
fn facts_of(
    loaded: &Loaded,
    shot: &Shot,
    (drawn, image): (&Drawn, &RenderedImage),
    args: &RunArgs,
) -> RunFacts {
    let code = shot.code();
    let program = loaded.program(shot);
    let outputs = code.outputs.iter().zip(0..).map(|(slot, at)| {
        let facts = match at {
            0 => image.facts(&drawn.covered),
            at => RenderedImage::of(code, drawn, at).facts(&drawn.covered),
        };
        let ty = program.map_or(String::new(), |p| p.type_name(slot.ty));
        let lanes = slot.ty.components();
        OutputFacts::of(&slot.name, (ty, lanes), &facts, drawn.covered.len())
    });
    let moment = args.moment();
    let reported = program.filter(|_| args.report);
    RunFacts {
        schema: 1,
        file: loaded.name.clone(),
        size: drawn.size,
        time: moment.time,
        frame: moment.frame,
        mouse: facts::mouse(&moment),
        output: None,
        outputs: outputs.collect(),
        cost: CostFacts::of(drawn),
        loops: reported.map(|program| loops::rows(program, shot, &drawn.seen)),
        functions: reported.map(|program| functions::rows(program, &drawn.seen)),
        numbers: reported.map(|program| numbers::rows(program, shot, &drawn.seen)),
        notes: Vec::new(),
    }
}

/// Compares two shaders. Returns the text to print and the exit code.
fn compared(args: &RunArgs, both: [(&Loaded, &mut Shot); 2]) -> Result<(String, u8), Trouble> {
    let [(one, shot), (other, other_shot)] = both;
    let names = [&one.name, &other.name].map(String::as_str);
    let (mut facts, image) = compare::compare([shot, other_shot], names, args)?;
    let read: Vec<PathBuf> = one.read.iter().chain(&other.read).cloned().collect();
    if let Some(image) = &image {
        facts.output = write(args, image, &read)?;
    }
    let code = if facts.same { CLEAN } else { FINDINGS };
    Ok((facts.print(args.format), code))
}

/// Refuses a file name of another image format, before anything is drawn.
fn refuse_other_images(args: &RunArgs) -> Result<(), Trouble> {
    // Input files are refused when the image is written.
    let Some(path) = args.output.as_ref().filter(|path| **path != args.file) else {
        return Ok(());
    };
    match path.extension() {
        Some(extension) if !extension.eq_ignore_ascii_case("png") => Err(format!(
            "{}: images are written as PNG; use `-o {}`",
            path.display(),
            path.with_extension("png").display()
        )
        .into()),
        _ => Ok(()),
    }
}

/// Writes the image if `-o` is given, and returns its name.
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

/// The image as text for the terminal, if it was not written to a file.
fn show(args: &RunArgs, bitmap: &Bitmap, written: Option<&str>) -> String {
    if written.is_some() || args.format == RunFormat::Json {
        return String::new();
    }
    let is_colored = args.color.is_on();
    if !io::stdout().is_terminal() && !is_colored {
        return String::new();
    }
    let palette = match is_colored {
        true => Palette::of(|name| std::env::var(name).ok()),
        false => Palette::Mono,
    };
    let (columns, lines) =
        terminal_size::terminal_size().map_or((80, 24), |(columns, lines)| (columns.0, lines.0));
    let size = terminal::fit(bitmap.size, u32::from(columns), u32::from(lines.max(8)) - 5);
    if let Some(note) = palette.note() {
        let _ = writeln!(io::stderr(), "note: {note}");
    }
    terminal::draw(&bitmap.shrunk(size), palette)
}
