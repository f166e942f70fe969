//! Resolves the files that a shader includes.

use crate::access::{FileAccess, Includes};
use crate::files::scan::{IncludedFile, Manner, RequestedFile};
use crate::files::{FileType, Files};
use crate::input::parts::near;
use shaderlint_text::path::{plain, slashed, tidy};
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Size limit of `package.json` in bytes.
const MAX_PACKAGE: usize = 1024 * 1024;
/// Extensions that bundlers append to names without an extension.
pub const EXTENSIONS: [&str; 5] = ["glsl", "vert", "frag", "vs", "fs"];
/// Name of the folder of packages.
const PACKAGES: &str = "node_modules";

/// A resolved file.
#[derive(Clone)]
pub struct FoundFile {
    /// Path in messages.
    pub name: String,
    /// The folder that the path in the directive is relative to.
    pub folder: PathBuf,
    /// Path without symbolic links, for a chunk of a library with its name.
    pub real: PathBuf,
    /// Contents of the file, or of the chunk in it.
    pub file: Arc<IncludedFile>,
    /// For a chunk of a library: where it starts in the text of the file, and that text.
    pub outer: Option<(usize, Arc<str>)>,
    /// Whether it is not where its path says.
    pub is_elsewhere: bool,
}

/// Why a file was not included.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Absence {
    /// The file does not exist or cannot be read.
    NotFound,
    /// The file is outside the project.
    Outside,
    /// The limit of included files was reached.
    TooMany,
}

impl fmt::Display for Absence {
    /// A phrase that follows the path.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Absence::NotFound => "not found",
            Absence::Outside => "outside the project",
            Absence::TooMany => "too many included files",
        })
    }
}

/// A file that was not included.
pub struct Absent {
    /// Folders that were searched.
    pub looked_in: Vec<String>,
    /// Reason.
    pub why: Absence,
    /// A path that is nearly the same and exists.
    pub similar: Option<String>,
}

impl Absent {
    /// The result if the limit of included files was reached.
    pub fn too_many() -> Absent {
        Absent {
            looked_in: Vec::new(),
            why: Absence::TooMany,
            similar: None,
        }
    }
}

impl FileAccess<'_> {
    /// Resolves a path in an include directive of the file `from`.
    pub fn find(&self, from: &str, requested: &RequestedFile) -> Result<FoundFile, Absent> {
        let mut absent = Absent {
            looked_in: Vec::new(),
            why: Absence::NotFound,
            similar: None,
        };
        let named = slashed(&requested.path);
        // Bundlers accept a query after the path.
        let named = named.split('?').next().unwrap_or("");
        for (folder, rest) in self.places(from, named) {
            let folder_shown = shown(&folder);
            if !absent.looked_in.contains(&folder_shown) {
                absent.looked_in.push(folder_shown);
            }
            let path = tidy(&folder.join(rest));
            let Some(path) = file_at(self.files, &path, requested.manner) else {
                continue;
            };
            match self.load(&path) {
                Ok(found) => return Ok(FoundFile { folder, ..found }),
                Err(why) => absent.why = why,
            }
        }
        if absent.why == Absence::NotFound && requested.manner == Manner::Path {
            absent.similar = self.similar(from, named);
        }
        Err(absent)
    }

    /// The folders that a path may be relative to, in order of search, with the rest of the path.
    fn places<'p>(&self, from: &str, named: &'p str) -> Vec<(PathBuf, &'p str)> {
        let Includes { root, tops, roots } = &self.includes;
        let beside = Path::new(from).parent().unwrap_or(Path::new(""));
        let relative = |path: &Path| self.relative(path);
        let packages = || {
            let here = plain(&self.files.here().join(beside));
            let real = self.files.real(&here).unwrap_or(here);
            let above = real.ancestors().take_while(|f| f.starts_with(root));
            let above = above.map(|f| f.join(PACKAGES));
            let above = above.filter(|f| self.files.entry(f) == Some(FileType::Folder));
            above.map(|f| relative(&f)).collect::<Vec<_>>().into_iter()
        };
        if let Some(rest) = named.strip_prefix('~') {
            let rest = rest.trim_start_matches('/');
            return packages().map(|f| (f, rest)).collect();
        }
        if named.starts_with('/') {
            let rest = named.trim_start_matches('/');
            let all = tops.iter().chain(roots);
            return all.map(|f| (relative(f), rest)).collect();
        }
        let mut places = vec![(beside.to_path_buf(), named)];
        if !named.starts_with('.') {
            places.extend(roots.iter().map(|f| (relative(f), named)));
            places.extend(packages().map(|f| (f, named)));
        }
        places
    }

    /// The path of an existing file whose name is nearly that in a path.
    fn similar(&self, from: &str, named: &str) -> Option<String> {
        let (folder, name) = named.rsplit_once('/').map_or(("", named), |(f, n)| (f, n));
        let mut places = self.places(from, folder).into_iter();
        let (place, folder) = places.next()?;
        let mut names = self.files.names(&tidy(&place.join(folder)));
        names.retain(|name| EXTENSIONS.iter().any(|e| name.ends_with(&format!(".{e}"))));
        let near = near(name, names.iter().map(String::as_str))?;
        Some(named.strip_suffix(name)?.to_string() + near)
    }

    /// A path as in messages: relative to the current folder, if it is inside.
    pub fn relative(&self, path: &Path) -> PathBuf {
        let inside = path.strip_prefix(self.files.here());
        inside.unwrap_or(path).to_path_buf()
    }

    /// Reads a file, unless it is outside the project.
    pub fn load(&self, path: &Path) -> Result<FoundFile, Absence> {
        let real = self.files.real(path).ok_or(Absence::NotFound)?;
        if !real.starts_with(&self.includes.root) {
            return Err(Absence::Outside);
        }
        let file = self.cache.text(self.files, &real);
        Ok(FoundFile {
            name: slashed(path),
            folder: PathBuf::new(),
            file: file.ok_or(Absence::NotFound)?,
            real,
            outer: None,
            is_elsewhere: false,
        })
    }

    /// The file of the repository whose path has the parts of this one at its end, in order, as engines that
    /// have a table of names resolve it; `None` if several files with different texts fit.
    pub fn elsewhere(&self, from: &str, requested: &RequestedFile) -> Option<FoundFile> {
        let named = slashed(&requested.path);
        let from = plain(&self.files.here().join(from));
        let is_chunk = requested.manner == Manner::Chunk;
        let mut all = self.cache.shaders(&from, self.files, |shaders| {
            shaders.fitting(named.split('?').next()?, |path, rest| {
                // A chunk is code for any stage, as beside the file.
                let is_for_any = rest.is_empty() || rest.ends_with(".glsl");
                path != from && (is_for_any || !is_chunk)
            })
        })?;
        let load = |path: PathBuf| self.load(&self.relative(&path)).ok();
        let found = load(all.pop()?)?;
        let is_same = |path| load(path).is_some_and(|f| f.file.text == found.file.text);
        let is_one = all.into_iter().all(is_same);
        is_one.then_some(FoundFile {
            is_elsewhere: true,
            ..found
        })
    }

    /// The chunk of a library with this name, wherever the repository has it.
    pub fn chunk(&self, from: &str, name: &str) -> Option<FoundFile> {
        let from = plain(&self.files.here().join(from));
        let chunk = self.cache.shaders(&from, self.files, |shaders| {
            shaders.chunk(name, self.files).cloned()
        })?;
        let outer = self.load(&self.relative(&chunk.path)).ok()?;
        let text = outer.file.text.clone();
        // It may have changed since.
        text.get(chunk.start..chunk.start + chunk.file.text.len())?;
        Some(FoundFile {
            real: chunk.path.join(name),
            file: chunk.file,
            outer: Some((chunk.start, text)),
            is_elsewhere: true,
            ..outer
        })
    }
}

/// Whether a file belongs to a package.
pub fn is_of_package(path: &Path) -> bool {
    let mut parts = path.components();
    parts.any(|c| c.as_os_str() == PACKAGES)
}

fn shown(folder: &Path) -> String {
    let text = slashed(folder);
    if text.is_empty() { ".".into() } else { text }
}

/// The file that a path refers to: the file itself, with an extension appended, or the main file of
/// a folder.
fn file_at(files: &dyn Files, base: &Path, manner: Manner) -> Option<PathBuf> {
    let entry = files.entry(base);
    if entry == Some(FileType::File) {
        return Some(base.to_path_buf());
    }
    // A chunk is code for any stage, not the shader of one.
    let extensions = match manner {
        Manner::Chunk => &EXTENSIONS[..1],
        Manner::Path => &EXTENSIONS,
    };
    if let Some(file) = with_known_extension(files, base, extensions) {
        return Some(file);
    }
    // `<name>` usually is a chunk of the host, not a folder.
    if manner == Manner::Chunk || entry != Some(FileType::Folder) {
        return None;
    }
    let index = || Some(base.join("index.glsl")).filter(|f| is_file(files, f));
    main_of(files, base).or_else(index)
}

fn is_file(files: &dyn Files, path: &Path) -> bool {
    files.entry(path) == Some(FileType::File)
}

fn with_known_extension(files: &dyn Files, base: &Path, extensions: &[&str]) -> Option<PathBuf> {
    let name = base.file_name()?.to_string_lossy().into_owned();
    let mut all = extensions
        .iter()
        .map(|e| base.with_file_name(format!("{name}.{e}")));
    all.find(|f| is_file(files, f))
}

/// The shader that a package exports.
fn main_of(files: &dyn Files, folder: &Path) -> Option<PathBuf> {
    let text = files.load(&folder.join("package.json")).ok()?;
    if text.len() > MAX_PACKAGE {
        return None;
    }
    let package: serde_json::Value = serde_json::from_str(&text).ok()?;
    let named = ["glslify", "browserify", "main"].iter();
    let named = named.filter_map(|key| package.get(key)?.as_str());
    let paths = named.map(|named| tidy(&folder.join(named)));
    let is_shader = |f: &PathBuf| {
        let extension = f.extension().and_then(|e| e.to_str());
        is_file(files, f) && extension.is_some_and(|e| EXTENSIONS.contains(&e))
    };
    let mut all = paths.filter_map(|p| {
        Some(p.clone())
            .filter(is_shader)
            .or_else(|| with_known_extension(files, &p, &EXTENSIONS))
    });
    all.next()
}
