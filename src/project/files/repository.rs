//! The words of a repository: whether another of its files contains a name.

use super::for_others::NamesForOthers;
use super::words::{GLSL, hash, is_glsl, words};
use crate::files::{FileType, Files};
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_detect::kind::file_extension;
use shaderlint_host::chunk_libraries;
use shaderlint_text::path::plain;
use std::collections::{HashMap, VecDeque};
use std::hash::{BuildHasherDefault, Hasher};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// Maximum number of files that are read.
const MAX_FILES: usize = 20_000;
/// Maximum number of bytes that are read.
const MAX_BYTES: usize = 64 * 1024 * 1024;
/// Maximum number of file and folder names that are visited.
const MAX_NAMES: usize = 100_000;
/// Maximum number of parent folders that are searched for the root of the repository.
const MAX_ABOVE: usize = 32;

/// Extensions of other files that may declare names for a shader: languages of programs that
/// complete shaders.
const CODE: &[&str] = &[
    "fx", "inc", "js", "mjs", "cjs", "jsx", "ts", "mts", "cts", "tsx", "vue", "svelte", "astro",
    "html", "htm", "json", "c", "cc", "cpp", "cxx", "h", "hh", "hpp", "m", "mm", "rs", "cs",
    "java", "kt", "swift", "go", "dart", "py", "rb", "php", "lua", "hx", "pde", "gd", "zig",
];

/// A file that declares names for shaders, or shows how they are compiled, contains one of these.
const SIGN_WORDS: &[&str] = &[
    "float",
    "vec2",
    "vec3",
    "vec4",
    "mat2",
    "mat3",
    "mat4",
    "ivec2",
    "ivec3",
    "ivec4",
    "sampler2D",
    "samplerCube",
    "uniform",
    "uniforms",
    "varying",
    "attribute",
    "defines",
    "shader",
    "shaders",
    "Shader",
    "glsl",
    "fragmentShader",
    "vertexShader",
    "shaderSource",
    "onBeforeCompile",
    "version",
];

/// The hashes of [`SIGN_WORDS`].
static SIGNS: OnceLock<FxHashSet<u64>> = OnceLock::new();

/// Stands for several files that contain a word.
const SEVERAL: u32 = u32::MAX;

/// What the programs of a repository do with shaders.
#[derive(Default)]
struct Programs {
    any: bool,
    hand_over: bool,
    hold_version: bool,
}

/// The files of some words: by hash of a word the number of its file, or [`SEVERAL`].
#[derive(Default)]
struct WordFiles(HashMap<u64, u32, BuildHasherDefault<HashedBefore>>);

impl WordFiles {
    fn add(&mut self, hash: u64, number: u32) {
        let file = self.0.entry(hash).or_insert(number);
        if *file != number {
            *file = SEVERAL;
        }
    }

    /// Whether a word belongs to a file other than this one.
    fn is_elsewhere(&self, word: &str, own: Option<u32>) -> bool {
        match self.0.get(&hash(word)) {
            None => false,
            Some(&SEVERAL) => true,
            Some(&number) => own != Some(number),
        }
    }
}

/// What the files of a repository declare for shaders.
#[derive(Default)]
struct DeclaredWords {
    /// Names that a file declares for shaders in other texts.
    declared: WordFiles,
    /// Words of complete shaders that these do not declare.
    lacked: WordFiles,
    /// Inputs and outputs that complete shaders declare for themselves.
    owned: WordFiles,
    /// Whether a program puts declarations together from parts.
    writes_declarations: bool,
}

/// The words in the code of a repository.
#[derive(Default)]
pub struct RepositoryWords {
    words: WordFiles,
    files: FxHashMap<PathBuf, u32>,
    /// The files that are about shaders.
    about_shaders: Vec<PathBuf>,
    /// What these declare; read when that is asked first.
    declared: OnceLock<DeclaredWords>,
    /// Whether all code was read.
    pub is_all: bool,
    /// Whether a program may write `#version` before shaders: it contains `#version`, or passes
    /// shaders to a library.
    pub adds_version: bool,
}

impl RepositoryWords {
    /// Reads the code under a folder, except for dependencies and build output.
    pub fn under(root: &Path, files: &dyn Files) -> RepositoryWords {
        let mut found = RepositoryWords {
            is_all: true,
            ..RepositoryWords::default()
        };
        let mut programs = Programs::default();
        let is_code = |extension: &str| [GLSL, CODE].iter().any(|all| all.contains(&extension));
        found.is_all = visit(root, files, is_code, &mut |path| {
            found.read(path, &mut programs, files)
        });
        found.adds_version = programs.hold_version || programs.any && !programs.hand_over;
        found
    }

    /// Reads a file and returns its length in bytes.
    fn read(&mut self, path: PathBuf, programs: &mut Programs, files: &dyn Files) -> usize {
        let Ok(text) = files.load(&path) else {
            return 0;
        };
        let name = path.to_string_lossy();
        let number = self.files.len() as u32;
        let signs = SIGNS.get_or_init(|| SIGN_WORDS.iter().map(|word| hash(word)).collect());
        let mut is_about_shaders = false;
        for word in words(&text) {
            let hash = hash(word);
            is_about_shaders |= signs.contains(&hash);
            self.words.add(hash, number);
        }
        let is_program = !is_glsl(&file_extension(&name));
        programs.any |= is_program;
        for library in chunk_libraries().iter().filter(|_| is_program) {
            let added = library.added_in(&text).into_iter();
            added.for_each(|member| self.words.add(hash(&member), number));
        }
        let length = text.len();
        if is_about_shaders && is_program {
            programs.hand_over |= text.contains(".shaderSource(");
            programs.hold_version |= text.contains("#version 300");
            let directives = text.split('#').skip(1).filter_map(|rest| {
                let mut words = words(rest);
                Some(match words.next()? {
                    "extension" => format!("#extension {}", words.next()?),
                    word => format!("#{word}"),
                })
            });
            let macros = macros_in_strings(&text).map(|word| format!("'{word}"));
            let all = directives.chain(macros);
            all.for_each(|word| self.words.add(hash(&word), number));
        }
        if is_about_shaders {
            self.about_shaders.push(path.clone());
        }
        self.files.insert(path, number);
        length
    }

    /// Reads what the files declare for shaders.
    fn read_declared(&self, files: &dyn Files) -> DeclaredWords {
        let mut found = DeclaredWords::default();
        for path in &self.about_shaders {
            let (Ok(text), Some(number)) = (files.load(path), self.files.get(path)) else {
                continue;
            };
            let names = NamesForOthers::of(&path.to_string_lossy(), &text);
            for (words, all) in [
                (names.declared, &mut found.declared),
                (names.lacked, &mut found.lacked),
                (names.owned, &mut found.owned),
            ] {
                words.iter().for_each(|word| all.add(hash(word), *number));
            }
            found.writes_declarations |= names.writes_declarations;
        }
        found
    }

    /// Whether a word appears in a file other than this one.
    pub fn is_elsewhere(&self, word: &str, file: &Path) -> bool {
        self.words.is_elsewhere(word, self.files.get(file).copied())
    }

    /// Whether another file declares a name outside of complete shaders.
    pub fn is_declared(&self, name: &str, file: &Path, files: &dyn Files) -> bool {
        let own = self.files.get(file).copied();
        let found = self.declared.get_or_init(|| self.read_declared(files));
        self.is_elsewhere(name, file) && found.declared.is_elsewhere(name, own)
    }

    /// Whether complete shaders of other files declare an input or output of this name for themselves, and
    /// none lacks it.
    pub fn is_owned(&self, name: &str, file: &Path, files: &dyn Files) -> bool {
        let own = self.files.get(file).copied();
        let found = self.declared.get_or_init(|| self.read_declared(files));
        found.owned.is_elsewhere(name, own) && !found.lacked.is_elsewhere(name, own)
    }

    /// Whether another file may declare a name for a complete shader of this file: it declares the name
    /// outside of complete shaders, a program writes declarations and contains the name, or another
    /// complete shader lacks it too, so that somebody declares it for both.
    pub fn may_be_declared(&self, name: &str, file: &Path, files: &dyn Files) -> bool {
        if !self.is_elsewhere(name, file) {
            return false;
        }
        let own = self.files.get(file).copied();
        let found = self.declared.get_or_init(|| self.read_declared(files));
        let sources = [&found.declared, &found.lacked];
        found.writes_declarations || sources.iter().any(|all| all.is_elsewhere(name, own))
    }
}

impl std::fmt::Debug for RepositoryWords {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} words", self.words.0.len())
    }
}

/// The names of macros at the start of strings, with a value: `'LIGHTS ' + count`.
fn macros_in_strings(text: &str) -> impl Iterator<Item = &str> {
    let strings = text.split(['"', '\'', '`']).skip(1);
    strings.filter_map(|string| {
        let word = words(string).next()?;
        let has_value = string.strip_prefix(word)?.starts_with(' ');
        let is_macro = word.len() > 1 && !word.contains(|c: char| c.is_ascii_lowercase());
        (has_value && is_macro).then_some(word)
    })
}

/// Calls a function, which returns how many bytes it has read, for each file under a folder with one of some
/// extensions, except for dependencies and build output. Whether all were visited.
pub fn visit(
    root: &Path,
    files: &dyn Files,
    is_meant: impl Fn(&str) -> bool,
    read: &mut dyn FnMut(PathBuf) -> usize,
) -> bool {
    let mut folders = VecDeque::from([root.to_path_buf()]);
    let (mut names, mut bytes, mut count) = (0, 0, 0);
    while let Some(folder) = folders.pop_front() {
        let mut inside = files.names(&folder);
        inside.sort_unstable();
        let has_source = inside.iter().any(|n| n == "src");
        for name in &inside {
            names += 1;
            if names > MAX_NAMES || bytes > MAX_BYTES || count > MAX_FILES {
                return false;
            }
            let is_code = is_meant(&file_extension(name));
            let path = folder.join(name);
            if is_code && !name.contains(".min.") {
                bytes += read(path);
                count += 1;
            } else if !is_code
                && !is_passed_over(name, has_source)
                && files.entry(&path) == Some(FileType::Folder)
            {
                folders.push_back(path);
            }
        }
    }
    true
}

/// The root of the repository that contains a file: the folder with version control, otherwise the
/// outermost package in the current folder, otherwise the package, otherwise the current folder if it contains
/// the file.
pub fn top(file: &Path, files: &dyn Files) -> PathBuf {
    let folder = file.parent().unwrap_or(Path::new(""));
    let above = || folder.ancestors().take(MAX_ABOVE);
    let holds = |folder: &Path, name: &str| files.entry(&folder.join(name)).is_some();
    let here = plain(files.here());
    let packages = || above().filter(|f| holds(f, "package.json"));
    // The packages of a repository belong together.
    let outermost = || packages().filter(|f| f.starts_with(&here)).last();
    let top = above().find(|f| holds(f, ".git"));
    let top = top.or_else(outermost).or_else(|| packages().next());
    match top {
        Some(top) => top.to_path_buf(),
        None if folder.starts_with(&here) => here,
        None => folder.to_path_buf(),
    }
}

/// Whether a folder contains dependencies, or build output next to its source.
fn is_passed_over(name: &str, has_source: bool) -> bool {
    name.starts_with('.')
        || matches!(name, "node_modules" | "target" | "__pycache__")
        || has_source && matches!(name, "dist" | "build" | "out")
}

/// A hasher for keys that are hashes already.
#[derive(Default)]
struct HashedBefore(u64);

impl Hasher for HashedBefore {
    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&byte| self.write_u64(byte.into()));
    }

    fn write_u64(&mut self, hash: u64) {
        self.0 ^= hash;
    }

    fn finish(&self) -> u64 {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;
    use std::sync::Arc;

    #[test]
    fn words_are_found_in_other_files() {
        let texts = [
            ("/r/package.json", "{}"),
            ("/r/a.glsl", "uniform float one; float two;"),
            ("/r/b/c.js", "const two = { uThree: 1 }"),
            ("/r/node_modules/d/e.js", "four"),
            ("/r/src/x.js", ""),
            ("/r/dist/x.js", "five"),
        ];
        let files: BTreeMap<PathBuf, Arc<str>> =
            texts.iter().map(|(p, t)| (p.into(), (*t).into())).collect();
        let file = Path::new("/r/a.glsl");
        assert_eq!(top(file, &files), Path::new("/r"));
        let words = RepositoryWords::under(Path::new("/r"), &files);
        let beside = ["one", "two", "uThree", "four", "five"].map(|w| words.is_elsewhere(w, file));
        assert_eq!(beside, [false, true, true, false, false]);
        assert!(words.is_all);
    }
}
