//! Finds the shaders of a gallery, and names their pages.

use crate::cli::disk::Disk;
use crate::cli::port::read::{plain_error, read_text};
use crate::cli::port::save::file_name;
use crate::detect::kind::{Claim, FileKind, decide};
use crate::engine::Options;
use crate::project::{PassRole, exports_in, folder_passes};
use crate::text::path::slashed;
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Maximum depth of folders.
const MAX_DEPTH: usize = 8;

/// Name of the page of all shaders.
pub(super) const INDEX: &str = "index";

/// A shader of a gallery.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct GallerySource {
    /// The name of its page, without extension.
    pub(super) name: String,
    /// Its file or folder.
    pub(super) path: PathBuf,
    /// Its text, if the file has several.
    pub(super) text: Option<String>,
}

/// The shaders of files and folders, in order of the names of their pages. The output folder is
/// skipped.
pub(super) fn sources(inputs: &[PathBuf], output: &Path) -> Result<Vec<GallerySource>, String> {
    let mut found = Vec::new();
    for input in inputs {
        let mut paths = Vec::new();
        match input.is_dir() {
            true => find(input, output, MAX_DEPTH, &mut paths)?,
            false => paths.push(input.clone()),
        }
        let root = match input.is_dir() {
            true => input.as_path(),
            false => input.parent().unwrap_or(Path::new("")),
        };
        for path in paths {
            found.extend(split(root, path)?);
        }
    }
    named(found)
}

/// The shader of a path, or those of an export with several.
fn split(root: &Path, path: PathBuf) -> Result<Vec<GallerySource>, String> {
    if path.extension().is_some_and(|e| e == "json") {
        let all = exports_in(&read_text(&path)?);
        if all.len() > 1 {
            let each = all.into_iter().map(|(name, text)| GallerySource {
                name: file_name(&name),
                path: path.clone(),
                text: Some(text),
            });
            return Ok(each.collect());
        }
    }
    let within = path.strip_prefix(root).unwrap_or(&path);
    let within = match path.is_dir() {
        true => within.to_path_buf(),
        false => within.with_extension(""),
    };
    let name = match within.as_os_str().is_empty() {
        true => title(root),
        false => slashed(&within),
    };
    Ok(vec![GallerySource {
        name: file_name(&name),
        path,
        text: None,
    }])
}

/// The sources in order of their names, which must differ.
fn named(found: Vec<GallerySource>) -> Result<Vec<GallerySource>, String> {
    let mut names: BTreeMap<String, GallerySource> = BTreeMap::new();
    for source in found {
        // Some file systems do not distinguish upper and lower case.
        let key = source.name.to_lowercase();
        let (name, path) = (source.name.clone(), slashed(&source.path));
        let other = match key.as_str() {
            INDEX => Some("the gallery".to_string()),
            _ => names.insert(key, source).map(|other| slashed(&other.path)),
        };
        match other {
            Some(other) if other == path => {
                return Err(format!(
                    "two shaders of {path} are called `{name}`; rename one of them"
                ));
            }
            Some(other) => {
                return Err(format!(
                    "{path} and {other} would both be written to {name}.html; rename the shader"
                ));
            }
            None => {}
        }
    }
    Ok(names.into_values().collect())
}

/// The title of a gallery: the name of its folder.
pub(super) fn title(folder: &Path) -> String {
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
    let options = Options::default();
    let passes = folder_passes(folder, options.file_access(&Disk::new())).unwrap_or_default();
    if passes.iter().any(|(role, _)| *role == PassRole::Image) {
        found.push(folder.to_path_buf());
        return Ok(());
    }
    let wrong = |e: io::Error| format!("{}: {}", slashed(folder), plain_error(&e));
    let entries: io::Result<Vec<_>> = fs::read_dir(folder).map_err(wrong)?.collect();
    let mut entries = entries.map_err(wrong)?;
    entries.sort_by_key(fs::DirEntry::file_name);
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
    match decide(&slashed(path), "", Claim::None).kind {
        FileKind::Shader => true,
        FileKind::Export => read_text(path).is_ok_and(|text| text.contains("\"renderpass\"")),
        _ => false,
    }
}
