//! `shaderport gallery`: a page of many shaders, and a page for each.

mod batch;
mod find;

pub(super) use batch::gallery_of;

use super::args::{GalleryArgs, PortArgs};
use super::load::{LoadedProject, load};
use super::report::print_note;
use super::save::{already_exists, save};
use super::still::still;
use crate::cli::command::{CLEAN, FINDINGS};
use crate::cli::output::Overwrite;
use crate::cli::progress::Progress;
use crate::cli::usage::absent;
use crate::cli::watch::{Stamp, wait};
use crate::commands::run::{InputRequest, position};
use crate::diagnostic::Severity;
use crate::port::{File, Gallery, GalleryEntry, PageAddress, Poster, embed, gallery, still_file};
use crate::project::Composed;
use crate::text::path::slashed;
use find::{GallerySource, INDEX, sources, title};
use std::collections::HashMap;
use std::io::{self, Write};
use std::path::PathBuf;

/// Largest media file that a page embeds, in bytes.
const MAX_MEDIA: u64 = 64 << 20;

/// Names of the files that all pages share.
const PLAYER: [&str; 2] = ["player.js", "player.css"];

/// Writes the gallery and returns the exit code; with `--watch` runs until the process is
/// terminated.
pub(super) fn run(args: &GalleryArgs) -> Result<u8, String> {
    if let Some(message) = absent(&args.input) {
        return Err(message);
    }
    let index = args.output.join(format!("{INDEX}.html"));
    let overwrite = Overwrite::if_forced(args.force);
    // Reported before minutes are spent on the images.
    if overwrite == Overwrite::Never && index.exists() {
        return Err(already_exists(&index));
    }
    let mut made = MadeGallery::default();
    let code = made.update(args, overwrite)?;
    if args.url.is_none() && !made.pages.is_empty() {
        let _ = writeln!(
            io::stderr(),
            "note: link previews show no images, because `og:image` requires an absolute address; \
             pass the address of the output folder with `--url`"
        );
    }
    if !args.watch {
        return Ok(code);
    }
    loop {
        print_note("waiting for changes");
        wait(made.built(), || made.stamp(args));
        if let Err(message) = made.update(args, Overwrite::Allowed) {
            print_note(&message);
        }
    }
}

/// The page of a shader.
struct GalleryPage {
    entry: GalleryEntry,
    files: Vec<File>,
    note: Option<String>,
}

/// A page, or why the shader cannot be played, and the state of its files.
struct BuiltPage {
    source: GallerySource,
    made: Result<GalleryPage, String>,
    read: Vec<PathBuf>,
    stamp: Stamp,
}

/// The pages of a gallery, by name.
#[derive(Default)]
struct MadeGallery {
    pages: HashMap<String, BuiltPage>,
}

impl MadeGallery {
    /// Builds the pages that are new or changed, and writes them with the page of all shaders.
    fn update(&mut self, args: &GalleryArgs, overwrite: Overwrite) -> Result<u8, String> {
        let sources = sources(&args.input, &args.output)?;
        if sources.is_empty() {
            let places: Vec<_> = args.input.iter().map(slashed).collect();
            return Err(format!("{}: no shader found", places.join(", ")));
        }
        let mut before = std::mem::take(&mut self.pages);
        let mut files = Vec::new();
        let progress = Progress::new(sources.len() as u32);
        for (done, source) in (0..).zip(&sources) {
            progress.drew(done);
            let known = before.remove(&source.name);
            let page = match known.filter(|page| page.is_fresh(source)) {
                Some(page) => page.seen_again(),
                None => {
                    let built = BuiltPage::build(args, source);
                    files.extend(built.made.iter().flat_map(|made| made.files.clone()));
                    built
                }
            };
            self.pages.insert(source.name.clone(), page);
        }
        drop(progress);
        let names: Vec<&str> = sources.iter().map(|s| s.name.as_str()).collect();
        let code = self.report(&names);
        let made = names
            .iter()
            .filter_map(|n| self.pages.get(*n)?.made.as_ref().ok());
        let entries: Vec<&GalleryEntry> = made.map(|made| &made.entry).collect();
        if entries.is_empty() {
            return Ok(code);
        }
        let first = args.input.first().map(PathBuf::as_path);
        let heading = args.title.clone();
        let heading = heading.unwrap_or_else(|| match (first, &args.input[..]) {
            (Some(folder), [_]) if folder.is_dir() => title(folder),
            _ => title(&args.output),
        });
        let address = args.url.as_ref().map(PageAddress::folder);
        let Gallery {
            page,
            script,
            style,
        } = gallery(&heading, &entries, address.as_ref());
        let [script_name, style_name] = PLAYER;
        let shared = [
            (format!("{INDEX}.html"), page),
            (script_name.to_string(), script),
            (style_name.to_string(), style),
        ];
        let shared = shared.map(|(name, text)| File {
            path: args.output.join(name),
            content: text.into_bytes(),
        });
        files.splice(0..0, shared);
        let mut read: Vec<PathBuf> = sources.into_iter().map(|source| source.path).collect();
        read.extend(self.pages.values().flat_map(|page| page.read.clone()));
        save(&files, overwrite, &read)?;
        Ok(code)
    }

    /// Prints notes and errors.
    fn report(&self, names: &[&str]) -> u8 {
        let mut stderr = io::stderr();
        let pages: Vec<&BuiltPage> = names.iter().filter_map(|n| self.pages.get(*n)).collect();
        for page in &pages {
            if let Ok(GalleryPage {
                note: Some(note), ..
            }) = &page.made
            {
                let _ = writeln!(stderr, "note: {note}");
            }
        }
        // What another shader includes is not a shader of its own.
        let is_part = |page: &BuiltPage| {
            let mut others = pages.iter().filter(|p| p.source.name != page.source.name);
            others.any(|p| p.made.is_ok() && p.read.contains(&page.source.path))
        };
        let mut code = CLEAN;
        for page in &pages {
            if let Err(why) = &page.made
                && !is_part(page)
            {
                let _ = writeln!(stderr, "error: {why}; left out");
                code = FINDINGS;
            }
        }
        code
    }

    /// The state of all files when the pages were built from them, so that a change during the build
    /// is noticed.
    fn built(&self) -> Stamp {
        let mut stamp = Stamp::default();
        for page in self.pages.values() {
            stamp.add(&page.stamp);
        }
        stamp
    }

    /// The state of all files, including those that were added.
    fn stamp(&self, args: &GalleryArgs) -> Stamp {
        let found = sources(&args.input, &args.output).unwrap_or_default();
        let read = self.pages.values().flat_map(|page| page.read.clone());
        Stamp::of(found.into_iter().map(|source| source.path).chain(read))
    }
}

impl BuiltPage {
    fn build(args: &GalleryArgs, source: &GallerySource) -> BuiltPage {
        let mut read = vec![source.path.clone()];
        let stamp = Stamp::of(read.iter().cloned());
        let made = GalleryPage::build(args, source, &mut read);
        BuiltPage {
            source: source.clone(),
            made,
            stamp: stamp.with(read.iter().cloned()),
            read,
        }
    }

    /// The page as it is, of files that may have changed where other pages are made of them.
    fn seen_again(mut self) -> BuiltPage {
        self.stamp = Stamp::of(self.read.iter().cloned());
        self
    }

    /// Whether the files are those that it was built from.
    fn is_fresh(&self, source: &GallerySource) -> bool {
        // A file with several shaders changes, while some of them do not.
        self.source == *source
            && (source.text.is_some() || self.stamp == Stamp::of(self.read.iter().cloned()))
    }
}

impl GalleryPage {
    /// The page, or why the shader cannot be played. `read` gets the files that were read.
    fn build(
        args: &GalleryArgs,
        source: &GallerySource,
        read: &mut Vec<PathBuf>,
    ) -> Result<GalleryPage, String> {
        let LoadedProject {
            project,
            composed,
            read: files,
            ..
        } = load(&PortArgs {
            input: vec![source.path.clone()],
            text: source.text.clone(),
            source: InputRequest {
                host: args.host.clone(),
                ..InputRequest::default()
            },
            max_media: MAX_MEDIA,
            ..PortArgs::default()
        })?;
        read.extend(files);
        if let Some(error) = first_error(&composed) {
            return Err(error);
        }
        let drawn = still(&project, &composed);
        let note = drawn.as_ref().err().map(|why| {
            let path = slashed(&source.path);
            format!("{path} has no still image: {why}")
        });
        let name = &source.name;
        let page = args.output.join(format!("{name}.html"));
        let address = args.url.as_ref().map(PageAddress::folder);
        let poster = Poster {
            still: drawn.ok(),
            address: address.map(|folder| folder.beside(&format!("{name}.html"))),
            click: args.click,
            shared: true,
        };
        let [script, style] = PLAYER;
        let [text, ..] = embed(&project, &composed, &poster, &page).split(script, style);
        let mut files = vec![File {
            path: page.clone(),
            content: text.into_bytes(),
        }];
        files.extend(poster.still.iter().map(|still| still_file(&page, still)));
        Ok(GalleryPage {
            entry: GalleryEntry::of(name, &project, &poster),
            files,
            note,
        })
    }
}

/// The first error of a shader, and how many there are.
fn first_error(composed: &Composed) -> Option<String> {
    let found = composed.units.iter().map(|unit| composed.analysis(unit));
    let found = found.flat_map(|analysis| &analysis.diagnostics);
    let mut errors = found.filter(|d| d.severity == Severity::Error);
    let first = errors.next()?;
    let place = position(&composed.sources, first.span);
    let place = place.map_or(String::new(), |place| format!("{place}: "));
    let more = match errors.count() {
        0 => String::new(),
        n => format!(" (and {n} more)"),
    };
    Some(format!("{place}{}{more}", first.message))
}
