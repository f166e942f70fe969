//! The GLSL files of a repository by name, and the chunks of libraries in it.

use super::Files;
use super::repository::visit;
use super::scan::IncludedFile;
use super::words::is_glsl;
use crate::include::EXTENSIONS;
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_detect::embed::{DocumentLanguage, extract_named};
use shaderlint_detect::kind::file_extension;
use shaderlint_host::presets;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

/// Maximum number of files that fit one path.
const MAX_FITTING: usize = 16;

/// Chunks by name, `None` for several with different texts.
type Chunks = FxHashMap<String, Option<LibraryChunk>>;

/// The GLSL files of a repository.
#[derive(Debug)]
pub struct RepositoryShaders {
    root: PathBuf,
    /// By the first word of the name.
    files: FxHashMap<String, Vec<PathBuf>>,
    /// The chunks; read when one is asked for first.
    chunks: OnceLock<Chunks>,
}

/// A chunk of a library: `@export name` and its text.
#[derive(Clone, Debug)]
pub struct LibraryChunk {
    /// The file that contains it.
    pub path: PathBuf,
    /// Where it starts there.
    pub start: usize,
    /// Its text, of the same length as in the file.
    pub file: Arc<IncludedFile>,
}

impl RepositoryShaders {
    /// Lists the files under a folder, except for dependencies and build output.
    pub fn under(root: &Path, files: &dyn Files) -> RepositoryShaders {
        let mut found = FxHashMap::<String, Vec<PathBuf>>::default();
        let is_all = visit(root, files, is_glsl, &mut |path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let first = first_word(&name).to_string();
            found.entry(first).or_default().push(path);
            0
        });
        // A file that was not seen may fit as well.
        if !is_all {
            found.clear();
        }
        RepositoryShaders {
            root: root.to_path_buf(),
            files: found,
            chunks: OnceLock::new(),
        }
    }

    /// The files whose name is the last part of a path, perhaps without its extension, in folders whose names
    /// contain the other parts in order. `fits` is also asked, with the extension that the path omits. `None` if
    /// they are too many.
    pub fn fitting(&self, path: &str, fits: impl Fn(&Path, &str) -> bool) -> Option<Vec<PathBuf>> {
        let parts = path.split('/').map(|p| p.trim_start_matches(['~', '@']));
        // The source of build output is meant, which has the same folders.
        let is_folder = |p: &&str| !["", ".", "..", "dist", "build", "out"].contains(p);
        let mut parts: Vec<&str> = parts.filter(is_folder).collect();
        let name = parts.pop()?;
        let is_named = |path: &&PathBuf| {
            let own = path.file_name().unwrap_or_default().to_string_lossy();
            let rest = own.strip_prefix(name).filter(|rest| is_omitted(rest));
            rest.is_some_and(|rest| fits(path, rest))
        };
        let all = self.files.get(first_word(name)).into_iter().flatten();
        let all: Vec<&PathBuf> = all.filter(is_named).collect();
        let within = |parts: &[&str]| -> Vec<PathBuf> {
            let is_in = |path: &&PathBuf| {
                let folder = path.parent().and_then(|f| f.strip_prefix(&self.root).ok());
                let mut folders = folder.into_iter().flatten();
                parts.iter().all(|part| folders.any(|f| f == *part))
            };
            let all = all.iter().copied().filter(is_in);
            all.cloned().collect()
        };
        let mut found = within(&parts);
        // The scope of a package is no folder.
        let has_scope = path.starts_with(['@', '~']) && !path.get(1..)?.starts_with('/');
        if found.is_empty() && has_scope {
            found = within(parts.get(1..)?);
        }
        (found.len() <= MAX_FITTING).then_some(found)
    }

    /// The chunk of this name.
    pub fn chunk(&self, name: &str, files: &dyn Files) -> Option<&LibraryChunk> {
        let chunks = self.chunks.get_or_init(|| {
            let mut all = Chunks::default();
            add_chunks(&self.root, files, &mut all);
            let own = all.keys().map(|name| first_word(name).to_string());
            let own: FxHashSet<_> = own.collect();
            // Chunks of a package are those that the repository does not have.
            let hosts = presets().filter(|host| host.takes_annotations);
            for package in hosts.flat_map(|host| &host.packages) {
                let folder = self.root.join("node_modules").join(package);
                let mut others = Chunks::default();
                add_chunks(&folder, files, &mut others);
                others.retain(|name, _| !own.contains(first_word(name)));
                all.extend(others);
            }
            all
        });
        chunks.get(name)?.as_ref()
    }
}

fn first_word(name: &str) -> &str {
    name.split('.').next().unwrap_or(name)
}

/// Whether a path may omit this end of a file name.
fn is_omitted(end: &str) -> bool {
    let end = end.strip_prefix(".module").unwrap_or(end);
    let extension = end.strip_prefix('.');
    end.is_empty() || extension.is_some_and(|e| EXTENSIONS.contains(&e))
}

/// Adds the chunks under a folder. Where a library has them as GLSL and as scripts made of that, the first
/// count.
fn add_chunks(root: &Path, files: &dyn Files, found: &mut Chunks) {
    let is_script = |e: &str| DocumentLanguage::of_extension(e) == Some(DocumentLanguage::Script);
    for is_meant in [&is_glsl as &dyn Fn(&str) -> bool, &is_script] {
        let mut more = Chunks::default();
        visit(root, files, is_meant, &mut |path| {
            let text = files.load(&path).unwrap_or_default();
            if text.contains("@export ") {
                add_chunks_in(&path, &text, &mut more);
            }
            text.len()
        });
        more.retain(|name, _| !found.contains_key(name));
        found.extend(more);
    }
}

fn add_chunks_in(path: &Path, text: &str, found: &mut Chunks) {
    let extension = file_extension(&path.to_string_lossy());
    let language = DocumentLanguage::of_extension(&extension);
    let all = extract_named("", language.unwrap_or(DocumentLanguage::Sections), text);
    for shader in all {
        let Some(name) = shader.chunk.filter(|name| !name.is_empty()) else {
            continue;
        };
        let chunk = LibraryChunk {
            path: path.to_path_buf(),
            start: shader.start,
            file: Arc::new(IncludedFile::new(shader.code.into())),
        };
        let other = found.entry(name).or_insert_with(|| Some(chunk.clone()));
        let is_same = |other: &LibraryChunk| other.file.text == chunk.file.text;
        if !other.as_ref().is_some_and(is_same) {
            *other = None;
        }
    }
}
