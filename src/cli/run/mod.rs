//! `shaderlint run`: draws a shader without a GPU and prints statistics.

mod args;
mod load;
mod png;
mod terminal;

pub use args::RunArgs;
pub(super) use load::{Trouble, Undrawable, read};
pub(super) use png::of_png;

use super::command::{CLEAN, FAILED, FINDINGS, TextOrJson, complain};
use super::global::{Talk, given};
use super::output::Overwrite;
use super::port::save;
use super::progress::Progress;
use crate::commands::run::{Bitmap, RunProgress, UniformText, answer};
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
    let args = &args.clone().completed()?;
    let format = match args.format {
        TextOrJson::Human => Format::Human,
        TextOrJson::Json => Format::Json,
    };
    refuse_other_images(args)?;
    let loaded = load(&args.file, args, format)?;
    let other = args.compare.as_ref();
    let other = other.map(|path| load(path, args, format)).transpose()?;
    let uniforms = uniform_text(args)?;
    let uniforms = uniforms.as_ref();
    let front = args.front(uniforms.map(|(name, text)| UniformText { name, text }));
    let mut line = None;
    let mut report = |at: RunProgress| {
        let line = line.get_or_insert_with(|| Progress::new(at.images[1] as u32));
        line.drew(at.images[0] as u32);
        line.frame(at.frames[0], at.frames[1]);
    };
    let both = (&loaded.shader, other.as_ref().map(|other| &other.shader));
    let made = answer(&args.request, both, &front, &mut report);
    drop(line);
    let mut made = made?;
    if args.format == TextOrJson::Human && given().talk() >= Talk::Normal {
        for note in &made.notes {
            let _ = writeln!(io::stderr(), "note: {note}");
        }
    }
    let mut shown = String::new();
    if let Some(image) = &made.image {
        let read = loaded
            .read
            .iter()
            .chain(other.iter().flat_map(|other| &other.read));
        let written = write(args, image, read.cloned().collect())?;
        if other.is_none() {
            shown = show(args, image, written.as_deref());
        }
        made.facts.written(written);
    }
    let text = match args.format {
        TextOrJson::Human => shown + &made.facts.text(),
        TextOrJson::Json => made.facts.json(),
    };
    let code = if made.facts.differ() { FINDINGS } else { CLEAN };
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
fn write(
    args: &RunArgs,
    bitmap: &Bitmap,
    mut read: Vec<PathBuf>,
) -> Result<Option<String>, Trouble> {
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
