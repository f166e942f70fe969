//! Where the files lie that a shader names, and what they hold.

use super::super::path::{absolute, tidy};
use super::common::Passes;
use super::scan::{Manner, Scan, Wanted, scan};
use std::collections::HashMap;
use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard};
use std::time::SystemTime;

/// Largest file that is included, in bytes.
pub const MAX_FILE: u64 = 4 * 1024 * 1024;
/// Largest `package.json` that is read, in bytes.
const MAX_PACKAGE: u64 = 1024 * 1024;
/// What bundlers put behind a name without an ending.
const ENDINGS: [&str; 5] = ["glsl", "vert", "frag", "vs", "fs"];
/// The folder that packages lie in.
const PACKAGES: &str = "node_modules";

/// Where `#include` finds its files.
#[derive(Clone, Default, Debug)]
pub struct Includes {
    /// The folder that no include may leave; `None` where nothing is included.
    root: Option<PathBuf>,
    /// What a leading `/` may stand for, the nearest first.
    tops: Vec<PathBuf>,
    /// `include_roots` of the configuration.
    roots: Vec<PathBuf>,
    files: Arc<Files>,
}

/// The files of a run, each read once.
#[derive(Default, Debug)]
pub struct Files {
    texts: Mutex<HashMap<PathBuf, Kept>>,
    /// By folder, the passes of ShaderToy in it.
    passes: Mutex<HashMap<PathBuf, Arc<Passes>>>,
}

#[derive(Debug)]
struct Kept {
    size: u64,
    changed: Option<SystemTime>,
    file: Arc<Text>,
}

/// A file that is put in, and what stands in it.
#[derive(Debug)]
pub struct Text {
    /// Its text.
    pub text: Arc<str>,
    /// Its directives.
    pub scan: Scan,
}

impl Text {
    /// Reads a text.
    pub fn new(text: Arc<str>) -> Text {
        let scan = scan(&text);
        Text { text, scan }
    }
}

/// A file that was found.
#[derive(Clone)]
pub struct Found {
    /// Its path as it is shown.
    pub name: String,
    /// Its path without links.
    pub real: PathBuf,
    /// What it holds.
    pub file: Arc<Text>,
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

impl Includes {
    /// Nothing is included.
    pub fn none() -> Includes {
        Includes::default()
    }

    /// Files inside this folder may be included.
    pub fn inside(root: &Path) -> Includes {
        Includes {
            root: root.canonicalize().ok(),
            tops: vec![root.to_path_buf()],
            ..Includes::default()
        }
    }

    /// With the folders that a leading `/` may stand for, the nearest first.
    pub fn with_tops(self, tops: Vec<PathBuf>) -> Includes {
        Includes { tops, ..self }
    }

    /// With the folders that are searched behind that of the file.
    pub fn with_roots(self, roots: Vec<PathBuf>) -> Includes {
        Includes { roots, ..self }
    }

    /// With the files that others have read.
    pub fn sharing(self, files: Arc<Files>) -> Includes {
        Includes { files, ..self }
    }

    /// The passes of ShaderToy that lie beside a file; `None` where nothing is included.
    pub fn passes(&self, name: &str) -> Option<Arc<Passes>> {
        self.root.as_ref()?;
        let folder = Path::new(name).parent()?.to_path_buf();
        if let Some(known) = lock(&self.files.passes).get(&folder) {
            return Some(known.clone());
        }
        let passes = Arc::new(Passes::inside(&folder));
        lock(&self.files.passes).insert(folder, passes.clone());
        Some(passes)
    }

    /// Finds a file that is named in another one.
    pub fn find(&self, from: &str, wanted: &Wanted) -> Result<Found, Absent> {
        let mut absent = Absent {
            looked_in: Vec::new(),
            why: Absence::NotFound,
        };
        let Some(root) = &self.root else {
            return Err(absent);
        };
        let plain = wanted.path.replace('\\', "/");
        // Bundlers take a question behind the path for themselves.
        let plain = plain.split('?').next().unwrap_or("");
        for (folder, rest) in self.places(root, from, plain) {
            let folder_shown = shown(&folder);
            if !absent.looked_in.contains(&folder_shown) {
                absent.looked_in.push(folder_shown);
            }
            let Some(path) = file_at(&tidy(&folder.join(rest)), wanted.manner) else {
                continue;
            };
            match self.load(root, &path) {
                Ok(found) => return Ok(found),
                Err(why) => absent.why = why,
            }
        }
        Err(absent)
    }

    /// The folders that a path may count from, in order, with the rest of the path.
    fn places<'p>(&self, root: &Path, from: &str, named: &'p str) -> Vec<(PathBuf, &'p str)> {
        let beside = Path::new(from).parent().unwrap_or(Path::new(""));
        let packages = || {
            let here = absolute(&Path::new(".").join(beside));
            let real = here.canonicalize().unwrap_or(here);
            let above: Vec<PathBuf> = real
                .ancestors()
                .take_while(|f| f.starts_with(root))
                .map(|f| f.join(PACKAGES))
                .collect();
            above.into_iter().filter(|f| f.is_dir()).map(relative)
        };
        if let Some(rest) = named.strip_prefix('~') {
            let rest = rest.trim_start_matches('/');
            return packages().map(|f| (f, rest)).collect();
        }
        if named.starts_with('/') {
            let rest = named.trim_start_matches('/');
            let all = self.tops.iter().chain(&self.roots);
            return all.map(|f| (relative(f.clone()), rest)).collect();
        }
        let mut places = vec![(beside.to_path_buf(), named)];
        if !named.starts_with('.') {
            let roots = self.roots.iter();
            places.extend(roots.map(|f| (relative(f.clone()), named)));
            places.extend(packages().map(|f| (f, named)));
        }
        places
    }

    /// Reads a file, unless it lies outside the project.
    pub fn load_inside(&self, path: &Path) -> Option<Found> {
        self.load(self.root.as_deref()?, path).ok()
    }

    fn load(&self, root: &Path, path: &Path) -> Result<Found, Absence> {
        let real = path.canonicalize().map_err(|_| Absence::NotFound)?;
        if !real.starts_with(root) {
            return Err(Absence::Outside);
        }
        let data = fs::metadata(&real).map_err(|_| Absence::NotFound)?;
        if !data.is_file() || data.len() > MAX_FILE {
            return Err(Absence::NotFound);
        }
        let (size, changed) = (data.len(), data.modified().ok());
        let name = path.to_string_lossy().replace('\\', "/");
        if let Some(kept) = lock(&self.files.texts).get(&real)
            && kept.size == size
            && kept.changed == changed
            && changed.is_some()
        {
            let file = kept.file.clone();
            return Ok(Found { name, real, file });
        }
        let text = fs::read_to_string(&real).map_err(|_| Absence::NotFound)?;
        let file = Arc::new(Text::new(text.into()));
        let kept = Kept {
            size,
            changed,
            file: file.clone(),
        };
        lock(&self.files.texts).insert(real.clone(), kept);
        Ok(Found { name, real, file })
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex
        .lock()
        .unwrap_or_else(|poisoned| poisoned.into_inner())
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

/// A path from the folder that the program runs in, where it lies inside.
fn relative(path: PathBuf) -> PathBuf {
    let here = std::env::current_dir().unwrap_or_default();
    path.strip_prefix(here)
        .map(Path::to_path_buf)
        .unwrap_or(path)
}

/// The file that a path means: itself, with an ending, or what its folder has for others.
fn file_at(base: &Path, manner: Manner) -> Option<PathBuf> {
    if base.is_file() {
        return Some(base.to_path_buf());
    }
    if let Some(file) = with_ending(base) {
        return Some(file);
    }
    // `<name>` is mostly a chunk of the host; a folder of that name means nothing.
    if manner == Manner::Chunk || !base.is_dir() {
        return None;
    }
    main_of(base).or_else(|| Some(base.join("index.glsl")).filter(|f| f.is_file()))
}

fn with_ending(base: &Path) -> Option<PathBuf> {
    let name = base.file_name()?.to_string_lossy().into_owned();
    let all = ENDINGS
        .iter()
        .map(|e| base.with_file_name(format!("{name}.{e}")));
    all.into_iter().find(|f| f.is_file())
}

/// The shader that a package names as what it is.
fn main_of(folder: &Path) -> Option<PathBuf> {
    let file = folder.join("package.json");
    let size = fs::metadata(&file).ok()?.len();
    if size > MAX_PACKAGE {
        return None;
    }
    let text = fs::read_to_string(&file).ok()?;
    let package: serde_json::Value = serde_json::from_str(&text).ok()?;
    let named = ["glslify", "browserify", "main"].iter();
    let named = named.filter_map(|key| package.get(key)?.as_str());
    let paths = named.map(|named| tidy(&folder.join(named)));
    let is_shader = |f: &PathBuf| {
        let ending = f.extension().and_then(|e| e.to_str());
        f.is_file() && ending.is_some_and(|e| ENDINGS.contains(&e))
    };
    let mut all = paths.filter_map(|p| {
        Some(p.clone())
            .filter(is_shader)
            .or_else(|| with_ending(&p))
    });
    all.next()
}
