//! Finding and reading input files.

use ignore::WalkBuilder;
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Largest file that is read, in bytes.
const MAX_FILE: u64 = 256 * 1024 * 1024;

/// What files a folder is searched for.
const EXTENSIONS: [&str; 13] = [
    "glsl",
    "frag",
    "vert",
    "fs",
    "vs",
    "shadertoy",
    "json",
    "html",
    "js",
    "ts",
    "jsx",
    "tsx",
    "md",
];

/// An input.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct InputFile {
    /// How it is shown, with forward slashes.
    pub name: String,
    /// Where to read it; `None` is standard input.
    pub path: Option<PathBuf>,
    /// Whether it was named itself, not found in a folder.
    pub is_explicit: bool,
}

/// The inputs that `paths` name, and what is wrong with them, a line each. Folders are searched, in
/// the order of names, leaving out what `.gitignore` leaves out.
pub fn collect(paths: &[PathBuf], stdin_name: Option<&str>) -> (Vec<InputFile>, Vec<String>) {
    let mut inputs = Vec::new();
    let mut problems = Vec::new();
    for path in paths {
        if path.as_os_str() == "-" {
            let name = stdin_name.unwrap_or("stdin.glsl").to_string();
            inputs.push(InputFile {
                name,
                path: None,
                is_explicit: true,
            });
        } else if path.is_dir() {
            folder(path, &mut inputs, &mut problems);
        } else if path.exists() {
            let name = shown(path);
            inputs.push(InputFile {
                name,
                path: Some(path.clone()),
                is_explicit: true,
            });
        } else {
            problems.push(format!("{}: there is no such file or folder", shown(path)));
        }
    }
    let mut seen = std::collections::HashSet::new();
    inputs.retain(|i| seen.insert(i.name.clone()));
    (inputs, problems)
}

fn folder(path: &Path, inputs: &mut Vec<InputFile>, problems: &mut Vec<String>) {
    let mut found = Vec::new();
    for entry in WalkBuilder::new(path).require_git(false).build() {
        match entry {
            Ok(entry) => {
                let is_file = entry.file_type().is_some_and(|t| t.is_file());
                if is_file && has_extension(entry.path()) {
                    found.push(InputFile {
                        name: shown(entry.path()),
                        path: Some(entry.into_path()),
                        is_explicit: false,
                    });
                }
            }
            Err(error) => problems.push(error.to_string()),
        }
    }
    found.sort();
    inputs.append(&mut found);
}

fn has_extension(path: &Path) -> bool {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or("");
    EXTENSIONS.contains(&extension)
}

/// A path as it is shown: with forward slashes, and without `./` in front.
fn shown(path: &Path) -> String {
    let text = path.to_string_lossy().replace('\\', "/");
    text.strip_prefix("./").map(str::to_string).unwrap_or(text)
}

/// How the bytes of a file were written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Encoding {
    /// As they should be.
    Utf8,
    /// UTF-8 up to this offset; what follows is read as a browser reads it, with U+FFFD in the
    /// place of bytes that mean nothing.
    Damaged(u32),
    /// UTF-16; nothing of it is read.
    Utf16,
    /// Neither; nothing of it is read.
    Binary,
}

/// What a file holds.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Content {
    /// Its text.
    pub text: String,
    /// How it was written.
    pub encoding: Encoding,
}

impl Content {
    /// Text that is well encoded.
    pub fn utf8(text: &str) -> Content {
        Content {
            text: text.to_string(),
            encoding: Encoding::Utf8,
        }
    }

    fn of(bytes: Vec<u8>) -> Content {
        let error = match String::from_utf8(bytes) {
            Ok(text) => {
                let encoding = Encoding::Utf8;
                return Content { text, encoding };
            }
            Err(error) => error,
        };
        let valid = error.utf8_error().valid_up_to() as u32;
        let bytes = error.as_bytes();
        let nothing = |encoding| Content {
            text: String::new(),
            encoding,
        };
        match bytes {
            [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => nothing(Encoding::Utf16),
            _ if bytes.contains(&0) => nothing(Encoding::Binary),
            _ => Content {
                text: String::from_utf8_lossy(bytes).into_owned(),
                encoding: Encoding::Damaged(valid),
            },
        }
    }
}

/// Reads an input.
pub fn read(input: &InputFile) -> Result<Content, String> {
    let bytes = match &input.path {
        Some(path) => {
            let size = fs::metadata(path).map_err(|e| e.to_string())?.len();
            if size > MAX_FILE {
                return Err(format!("the file has {size} bytes; {MAX_FILE} are allowed"));
            }
            fs::read(path).map_err(|e| e.to_string())?
        }
        None => {
            let mut bytes = Vec::new();
            let mut stdin = std::io::stdin().lock().take(MAX_FILE + 1);
            stdin.read_to_end(&mut bytes).map_err(|e| e.to_string())?;
            bytes
        }
    };
    Ok(Content::of(bytes))
}
