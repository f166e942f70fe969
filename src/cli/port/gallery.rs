//! `shaderport gallery`: a page of many shaders, and a page for each.

use super::args::{GalleryArgs, PortArgs};
use super::load::{LoadedProject, in_folder, load};
use super::read::{plain_error, read_text, shown};
use super::save::{already_exists, file_name, save};
use super::still::still;
use crate::cli::command::{CLEAN, FINDINGS};
use crate::cli::output::Overwrite;
use crate::cli::run::Progress;
use crate::commands::run::position;
use crate::diagnostic::Severity;
use crate::port::{Composed, File, GalleryEntry, PassRole, Poster, embed, gallery, still_name};
use crate::text::kind::{Claim, FileKind, decide};
use std::collections::BTreeMap;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Largest media file that a page embeds, in bytes.
const MAX_MEDIA: u64 = 64 << 20;

/// Maximum depth of folders.
const MAX_DEPTH: usize = 8;

/// Name of the page of all shaders.
const INDEX: &str = "index";

/// Writes the gallery and returns the exit code.
pub(super) fn run(args: &GalleryArgs) -> Result<u8, String> {
    if !args.folder.is_dir() {
        return Err(format!("{}: expected a folder", shown(&args.folder)));
    }
    let index = args.output.join(format!("{INDEX}.html"));
    let overwrite = Overwrite::if_forced(args.force);
    // Reported before minutes are spent on the images.
    if overwrite == Overwrite::Never && index.exists() {
        return Err(already_exists(&index));
    }
    let mut paths = Vec::new();
    find(&args.folder, &args.output, MAX_DEPTH, &mut paths)?;
    if paths.is_empty() {
        return Err(format!("{}: no shader found", shown(&args.folder)));
    }
    let names = names(&args.folder, &paths)?;
    let mut made = MadeGallery::default();
    let mut refused = Vec::new();
    let progress = Progress::new(names.len() as u32);
    for (done, (name, path)) in (0..).zip(&names) {
        progress.drew(done);
        if let Err(why) = made.add(args, name, path) {
            refused.push((*path, why));
        }
    }
    drop(progress);
    // What another shader includes is not a shader of its own.
    refused.retain(|(path, _)| !made.read.iter().any(|read| read == *path));
    let mut stderr = io::stderr();
    for note in &made.notes {
        let _ = writeln!(stderr, "note: {note}");
    }
    for (_, why) in &refused {
        let _ = writeln!(stderr, "error: {why}; left out");
    }
    let code = if refused.is_empty() { CLEAN } else { FINDINGS };
    if made.entries.is_empty() {
        return Ok(code);
    }
    let heading = args.title.clone().unwrap_or_else(|| title(&args.folder));
    let address = args.url.as_ref().map(|url| url.folder());
    let page = gallery(&heading, &made.entries, address.as_ref());
    made.files.insert(
        0,
        File {
            path: index,
            content: page.into_bytes(),
        },
    );
    made.read.extend(paths);
    save(&made.files, overwrite, &made.read)?;
    if args.url.is_none() {
        let _ = writeln!(
            stderr,
            "note: link previews show no images, because `og:image` requires an absolute address; \
             pass the address of the output folder with `--url`"
        );
    }
    Ok(code)
}

/// The title of a gallery: the name of its folder.
fn title(folder: &Path) -> String {
    let absolute = folder.canonicalize().unwrap_or_else(|_| folder.into());
    let name = absolute.file_name().unwrap_or_default();
    match name.to_string_lossy() {
        name if name.is_empty() => "Shaders".to_string(),
        name => name.into_owned(),
    }
}

/// Finds shader files, exports and folders of passes, sorted by path. The output folder, hidden
/// folders and symbolic links are skipped.
fn find(
    folder: &Path,
    output: &Path,
    depth: usize,
    found: &mut Vec<PathBuf>,
) -> Result<(), String> {
    let passes = in_folder(folder).unwrap_or_default();
    if passes.iter().any(|(role, _)| *role == PassRole::Image) {
        found.push(folder.to_path_buf());
        return Ok(());
    }
    let wrong = |e: io::Error| format!("{}: {}", shown(folder), plain_error(&e));
    let entries: io::Result<Vec<_>> = fs::read_dir(folder).map_err(wrong)?.collect();
    let mut entries = entries.map_err(wrong)?;
    entries.sort_by_key(fs::DirEntry::file_name);
    // The other files of a folder with projects of SHADERed belong to these.
    let is_project = |path: &PathBuf| path.extension().is_some_and(|e| e == "sprj");
    let projects = entries.iter().map(fs::DirEntry::path).filter(is_project);
    let projects: Vec<PathBuf> = projects.collect();
    if !projects.is_empty() {
        found.extend(projects);
        return Ok(());
    }
    for entry in entries {
        let (path, kind) = (entry.path(), entry.file_type().map_err(wrong)?);
        let name = entry.file_name();
        let is_skipped = name.to_string_lossy().starts_with('.') || name == "node_modules";
        if kind.is_dir() && !is_skipped && depth > 0 && !is_same(&path, output) {
            find(&path, output, depth - 1, found)?;
        } else if kind.is_file() && !is_skipped && is_shader(&path) {
            found.push(path);
        }
    }
    Ok(())
}

fn is_same(one: &Path, other: &Path) -> bool {
    let real = |path: &Path| path.canonicalize().ok();
    real(one).is_some_and(|path| real(other) == Some(path))
}

/// Whether a file is a shader or an export. A vertex shader belongs to the fragment shader beside
/// it.
fn is_shader(path: &Path) -> bool {
    let partner = match path.extension().and_then(|e| e.to_str()) {
        Some("vert") => "frag",
        Some("vs") => "fs",
        Some("vsh") => "fsh",
        _ => "",
    };
    if !partner.is_empty() && path.with_extension(partner).is_file() {
        return false;
    }
    match decide(&shown(path), "", Claim::None).kind {
        FileKind::Shader => true,
        FileKind::Export => read_text(path).is_ok_and(|text| text.contains("\"renderpass\"")),
        _ => false,
    }
}

/// The paths with the names of their pages, in order of names.
fn names<'p>(folder: &Path, paths: &'p [PathBuf]) -> Result<Vec<(String, &'p PathBuf)>, String> {
    let mut names: BTreeMap<String, (String, &PathBuf)> = BTreeMap::new();
    for path in paths {
        let within = path.strip_prefix(folder).unwrap_or(path);
        let within = match path.is_dir() {
            true => within.to_path_buf(),
            false => within.with_extension(""),
        };
        let name = match within.as_os_str().is_empty() {
            true => title(folder),
            false => shown(&within),
        };
        let name = file_name(&name);
        let other = match name.to_lowercase() {
            key if key == INDEX => Some("the gallery".to_string()),
            // Some file systems do not distinguish upper and lower case.
            key => names
                .insert(key, (name.clone(), path))
                .map(|(_, path)| shown(path)),
        };
        if let Some(other) = other {
            let path = shown(path);
            return Err(format!(
                "{path} and {other} would both be written to {name}.html; rename the shader"
            ));
        }
    }
    Ok(names.into_values().collect())
}

/// The files of a gallery.
#[derive(Default)]
struct MadeGallery {
    files: Vec<File>,
    entries: Vec<GalleryEntry>,
    notes: Vec<String>,
    /// The files that were read, which must not be overwritten.
    read: Vec<PathBuf>,
}

impl MadeGallery {
    /// Adds a shader, or returns why it cannot be played.
    fn add(&mut self, args: &GalleryArgs, name: &str, path: &Path) -> Result<(), String> {
        let LoadedProject {
            project,
            composed,
            read,
            ..
        } = load(&PortArgs {
            input: vec![path.to_path_buf()],
            host: args.host.clone(),
            max_media: MAX_MEDIA,
            ..PortArgs::default()
        })?;
        if let Some(error) = first_error(&composed) {
            return Err(error);
        }
        let drawn = still(&project, &composed);
        if let Err(why) = &drawn {
            let path = shown(path);
            self.notes.push(format!("{path} has no still image: {why}"));
        }
        let page = args.output.join(format!("{name}.html"));
        let poster = Poster {
            still: drawn.ok(),
            address: args
                .url
                .as_ref()
                .map(|url| url.folder().beside(&format!("{name}.html"))),
        };
        self.entries.push(GalleryEntry::of(name, &project, &poster));
        self.files.push(File {
            content: embed(&project, &composed, &poster, &page).into_bytes(),
            path: page.clone(),
        });
        if let Some(still) = poster.still {
            self.files.push(File {
                path: page.with_file_name(still_name(&page)),
                content: still.png,
            });
        }
        self.read.extend(read);
        Ok(())
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
