//! Where the files lie that a shader names, and what they hold.

use super::super::files::{FileType, Files};
use super::super::options::Includes;
use super::super::path::{plain, tidy};
use super::super::world::World;
use super::scan::{IncludedFile, Manner, Wanted};
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Largest `package.json` that is read, in bytes.
const MAX_PACKAGE: usize = 1024 * 1024;
/// What bundlers put behind a name without an ending.
pub const ENDINGS: [&str; 5] = ["glsl", "vert", "frag", "vs", "fs"];
/// The folder that packages lie in.
const PACKAGES: &str = "node_modules";

/// A file that was found.
#[derive(Clone)]
pub struct Found {
    /// Its path as it is shown.
    pub name: String,
    /// Its path without links.
    pub real: PathBuf,
    /// What it holds.
    pub file: Arc<IncludedFile>,
}

/// Why a file is not put in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Absence {
    /// There is none, or it cannot be read.
    NotFound,
    /// It lies outside the project.
    Outside,
    /// Too many files are put in already.
    TooMany,
}

impl fmt::Display for Absence {
    /// In words that go on behind the path.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Absence::NotFound => "not found",
            Absence::Outside => "outside the project",
            Absence::TooMany => "one file too many",
        })
    }
}

/// A file that is not found.
pub struct Absent {
    /// The folders that it was looked for in, as they are shown.
    pub looked_in: Vec<String>,
    /// Why it is not put in.
    pub why: Absence,
}

impl Absent {
    /// A file that is not looked for.
    pub fn too_many() -> Absent {
        Absent {
            looked_in: Vec::new(),
            why: Absence::TooMany,
        }
    }
}

impl World<'_> {
    /// Finds a file that is named in another one.
    pub fn find(&self, from: &str, wanted: &Wanted) -> Result<Found, Absent> {
        let mut absent = Absent {
            looked_in: Vec::new(),
            why: Absence::NotFound,
        };
        let named = wanted.path.replace('\\', "/");
        // Bundlers take a question behind the path for themselves.
        let named = named.split('?').next().unwrap_or("");
        for (folder, rest) in self.places(from, named) {
            let folder_shown = shown(&folder);
            if !absent.looked_in.contains(&folder_shown) {
                absent.looked_in.push(folder_shown);
            }
            let path = tidy(&folder.join(rest));
            let Some(path) = file_at(self.files, &path, wanted.manner) else {
                continue;
            };
            match self.load(&path) {
                Ok(found) => return Ok(found),
                Err(why) => absent.why = why,
            }
        }
        Err(absent)
    }

    /// The folders that a path may count from, in order, with the rest of the path.
    fn places<'p>(&self, from: &str, named: &'p str) -> Vec<(PathBuf, &'p str)> {
        let Includes { root, tops, roots } = &self.options.includes;
        let beside = Path::new(from).parent().unwrap_or(Path::new(""));
        let relative = |path: &Path| {
            let inside = path.strip_prefix(self.files.here());
            inside.unwrap_or(path).to_path_buf()
        };
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

    /// Reads a file, unless it lies outside the project.
    pub fn load(&self, path: &Path) -> Result<Found, Absence> {
        let real = self.files.real(path).ok_or(Absence::NotFound)?;
        if !real.starts_with(&self.options.includes.root) {
            return Err(Absence::Outside);
        }
        let file = self.options.memo.text(self.files, &real);
        Ok(Found {
            name: path.to_string_lossy().replace('\\', "/"),
            file: file.ok_or(Absence::NotFound)?,
            real,
        })
    }
}

/// Whether a file is that of a package.
pub fn is_of_package(path: &Path) -> bool {
    let mut parts = path.components();
    parts.any(|c| c.as_os_str() == PACKAGES)
}

/// A folder as it is shown.
fn shown(folder: &Path) -> String {
    let text = folder.to_string_lossy().replace('\\', "/");
    if text.is_empty() { ".".into() } else { text }
}

/// The file that a path means: itself, with an ending, or what its folder has for others.
fn file_at(files: &dyn Files, base: &Path, manner: Manner) -> Option<PathBuf> {
    let entry = files.entry(base);
    if entry == Some(FileType::File) {
        return Some(base.to_path_buf());
    }
    if let Some(file) = with_ending(files, base) {
        return Some(file);
    }
    // `<name>` is mostly a chunk of the host; a folder of that name means nothing.
    if manner == Manner::Chunk || entry != Some(FileType::Folder) {
        return None;
    }
    let index = || Some(base.join("index.glsl")).filter(|f| is_file(files, f));
    main_of(files, base).or_else(index)
}

fn is_file(files: &dyn Files, path: &Path) -> bool {
    files.entry(path) == Some(FileType::File)
}

fn with_ending(files: &dyn Files, base: &Path) -> Option<PathBuf> {
    let name = base.file_name()?.to_string_lossy().into_owned();
    let mut all = ENDINGS
        .iter()
        .map(|e| base.with_file_name(format!("{name}.{e}")));
    all.find(|f| is_file(files, f))
}

/// The shader that a package names as what it is.
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
        let ending = f.extension().and_then(|e| e.to_str());
        is_file(files, f) && ending.is_some_and(|e| ENDINGS.contains(&e))
    };
    let mut all = paths.filter_map(|p| {
        Some(p.clone())
            .filter(is_shader)
            .or_else(|| with_ending(files, &p))
    });
    all.next()
}
