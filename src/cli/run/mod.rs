//! `shaderlint run`: draws a shader without a GPU and prints statistics.

mod args;
mod load;
mod png;
mod sheet;
mod terminal;

pub use args::RunArgs;
pub(super) use args::{Heat, size_of, time_of};
pub(super) use load::{LoadedFiles, Trouble, Undrawable, read};
pub(super) use png::of_png;

use super::command::{CLEAN, FAILED, FINDINGS, TextOrJson, complain};
use super::global::given;
use super::output::Overwrite;
use super::port::save;
use super::progress::Progress;
use crate::commands::run::{
    Bitmap, Shot, UniformText, compare, compared_moments, frame, rays, shot, trace,
};
use crate::port::File;
use crate::report::Format;
use crate::text::path::slashed;
use load::load;
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
            complain(&words);
            Ok(FAILED)
        }
    }
}

/// Draws the shader. Returns the text to print and the exit code.
fn drawn(args: &RunArgs) -> Result<(String, u8), Trouble> {
    let format = match args.format {
        TextOrJson::Human => Format::Human,
        TextOrJson::Json => Format::Json,
    };
    refuse_other_images(args)?;
    let loaded = load(&args.file, args, format)?;
    let uniforms = uniform_text(args)?;
    let uniforms = uniforms
        .as_ref()
        .map(|(name, text)| UniformText { name, text });
    let mut own = shot(&loaded.shader, &args.setting(uniforms))?;
    if let Some(path) = &args.compare {
        let other = load(path, args, format)?;
        let mut other_shot = shot(&other.shader, &args.setting(uniforms))?;
        return compared(args, [(&loaded, &mut own), (&other, &mut other_shot)]);
    }
    if args.format == TextOrJson::Human {
        for note in own.notes(&loaded.shader.project) {
            let _ = writeln!(io::stderr(), "note: {note}");
        }
    }
    if let Some(pixel) = args.pixel {
        return traced(args, &loaded, &mut own, pixel);
    }
    if let Some(count) = args.sheet {
        let (sheet, mut facts) = sheet::draw(&loaded.shader, &mut own, args, count)?;
        facts.output = write(args, &sheet, &loaded.read)?;
        let text = match args.format {
            TextOrJson::Human => show(args, &sheet, facts.output.as_deref()) + &facts.text(),
            TextOrJson::Json => facts.json(),
        };
        return Ok((text, CLEAN));
    }
    let moment = args.moment();
    let progress = Progress::new(1);
    let mut report_frame = |number| progress.frame(number, moment.frame);
    let made = frame(
        &loaded.shader,
        &mut own,
        &moment,
        args.view(),
        &mut report_frame,
    );
    drop(progress);
    let mut made = made?;
    if args.report {
        let setting = args.setting(uniforms);
        made.facts.rays = rays(&loaded.shader, &own, &setting, &moment);
    }
    let output = write(args, &made.bitmap, &loaded.read)?;
    made.facts.output.clone_from(&output);
    Ok((
        match args.format {
            TextOrJson::Human => show(args, &made.bitmap, output.as_deref()) + &made.facts.text(),
            TextOrJson::Json => made.facts.json(),
        },
        CLEAN,
    ))
}

/// Traces a pixel. Returns the text to print and the exit code.
fn traced(
    args: &RunArgs,
    loaded: &LoadedFiles,
    shot: &mut Shot,
    pixel: [u32; 2],
) -> Result<(String, u8), Trouble> {
    let moment = args.moment();
    let progress = Progress::new(1);
    let mut report_frame = |number| progress.frame(number, moment.frame);
    let facts = trace(&loaded.shader, shot, &moment, pixel, &mut report_frame)
        .map_err(|e| format!("--pixel: {e}"))?;
    let text = match args.format {
        TextOrJson::Human => facts.text(),
        TextOrJson::Json => facts.json(),
    };
    Ok((text, CLEAN))
}

/// Compares two shaders. Returns the text to print and the exit code.
fn compared(args: &RunArgs, both: [(&LoadedFiles, &mut Shot); 2]) -> Result<(String, u8), Trouble> {
    let [(one, shot), (other, other_shot)] = both;
    let names = [&one.shader.name, &other.shader.name].map(String::as_str);
    let moments = match args.time.is_some() || args.frame.is_some() {
        true => vec![args.moment()],
        false => compared_moments(args.size, args.mouse),
    };
    let progress = Progress::new(moments.len() as u32);
    let mut report = |number: usize, frame| {
        progress.drew(number as u32);
        let last = moments.get(number).map_or(0, |moment| moment.frame);
        progress.frame(frame, last);
    };
    let made = compare([shot, other_shot], names, args.size, &moments, &mut report);
    drop(progress);
    let (mut facts, image) = made?;
    let read: Vec<PathBuf> = one.read.iter().chain(&other.read).cloned().collect();
    if let Some(image) = &image {
        facts.output = write(args, image, &read)?;
    }
    let code = if facts.same { CLEAN } else { FINDINGS };
    let text = match args.format {
        TextOrJson::Human => facts.text(),
        TextOrJson::Json => facts.json(),
    };
    Ok((text, code))
}

/// The text of the file of uniforms.
fn uniform_text(args: &RunArgs) -> Result<Option<(String, String)>, Trouble> {
    let read = |path: &PathBuf| Ok((slashed(path), super::port::read_text(path)?));
    args.uniforms.as_ref().map(read).transpose()
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
    Ok(Some(slashed(path)))
}

/// The image as text for the terminal, if it was not written to a file.
fn show(args: &RunArgs, bitmap: &Bitmap, written: Option<&str>) -> String {
    if written.is_some() || args.format == TextOrJson::Json {
        return String::new();
    }
    let is_colored = given().color.is_on();
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
