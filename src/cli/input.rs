//! Finds and reads input files.

use super::config::absolute;
use super::usage::missing;
use crate::detect::kind::{Claim, is_script, is_searched, made};
use crate::engine::config::Configs;
use crate::text::Content;
use crate::text::path::slashed;
use ignore::WalkBuilder;
use serde::de::DeserializeOwned;
use std::collections::BTreeSet;
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

/// Size limit of input files in bytes.
const MAX_FILE: u64 = 256 * 1024 * 1024;

/// An input file or standard input.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct InputFile {
    /// Name in messages, with forward slashes.
    pub name: String,
    /// Path of the file; `None` is standard input.
    pub path: Option<PathBuf>,
    /// Whether it is named on the command line rather than found in a folder.
    pub is_explicit: bool,
    /// Whether the configuration lists it as a shader.
    pub claim: Claim,
}

/// The inputs that paths resolve to.
pub struct Collected {
    /// The inputs, without duplicates.
    pub inputs: Vec<InputFile>,
    /// Messages about paths that cannot be read.
    pub problems: Vec<String>,
    /// Files and folders that were skipped.
    pub passed_over: PassedOver,
}

/// Files and folders that were skipped.
#[derive(Default)]
pub struct PassedOver {
    /// Files that the configuration excludes.
    pub excluded: Vec<String>,
    /// Folders of dependencies and build output.
    pub folders: Vec<String>,
    /// Generated scripts, each with the evidence.
    pub made: Vec<(String, &'static str)>,
    /// Number of files with other extensions.
    pub others: usize,
    /// Some of these extensions.
    pub extensions: BTreeSet<String>,
}

impl PassedOver {
    /// Maximum number of extensions that are kept.
    const MAX_EXTENSIONS: usize = 12;

    fn add(&mut self, path: &Path) {
        if is_searched(&path.to_string_lossy()) {
            self.excluded.push(shown(path));
            return;
        }
        self.others += 1;
        let extension = path.extension().and_then(|e| e.to_str());
        if self.extensions.len() < PassedOver::MAX_EXTENSIONS {
            let extension = extension.map_or("no extension".to_string(), |e| format!(".{e}"));
            self.extensions.insert(extension);
        }
    }
}

/// The inputs that `paths` resolve to. Folders are searched in order of names, without files that
/// `.gitignore` or the configuration excludes, and without build output.
pub fn collect(paths: &[PathBuf], stdin_name: Option<&str>, configs: &Configs) -> Collected {
    let mut inputs = Vec::new();
    let mut problems = Vec::new();
    let mut passed_over = PassedOver::default();
    for path in paths {
        if path.as_os_str() == "-" {
            let name = stdin_name.unwrap_or("stdin.glsl").to_string();
            inputs.push(InputFile {
                name,
                path: None,
                is_explicit: true,
                claim: Claim::None,
            });
        } else if path.is_dir() {
            let found = folder(path, configs, &mut problems, &mut passed_over);
            inputs.extend(found);
        } else if path.exists() {
            if configs.leaves_out(path) {
                passed_over.excluded.push(shown(path));
            } else {
                inputs.push(InputFile {
                    name: shown(path),
                    path: Some(path.clone()),
                    is_explicit: true,
                    claim: claim(path, configs),
                });
            }
        } else {
            problems.push(format!("{}: {}", shown(path), missing(path)));
        }
    }
    let mut seen = std::collections::HashSet::new();
    inputs.retain(|i| seen.insert(i.name.clone()));
    Collected {
        inputs,
        problems,
        passed_over,
    }
}

fn folder(
    path: &Path,
    configs: &Configs,
    problems: &mut Vec<String>,
    passed_over: &mut PassedOver,
) -> Vec<InputFile> {
    let mut found = Vec::new();
    let left_out = Arc::new(Mutex::new(Vec::new()));
    let mut walk = WalkBuilder::new(path);
    let folders = left_out.clone();
    walk.require_git(false).filter_entry(move |entry| {
        let is_folder = entry.file_type().is_some_and(|t| t.is_dir());
        let name = entry.file_name().to_str().unwrap_or("");
        let is_left_out = entry.depth() > 0 && is_folder && BUILT.contains(&name);
        if let (true, Ok(mut folders)) = (is_left_out, folders.lock()) {
            folders.push(shown(entry.path()));
        }
        !is_left_out
    });
    for entry in walk.build() {
        match entry {
            Ok(entry) => {
                let is_file = entry.file_type().is_some_and(|t| t.is_file());
                if is_file && !is_taken(entry.path(), configs) {
                    passed_over.add(entry.path());
                } else if is_file {
                    let claim = claim(entry.path(), configs);
                    if let Some(reason) = made_by_a_program(entry.path(), claim) {
                        passed_over.made.push((shown(entry.path()), reason));
                        continue;
                    }
                    found.push(InputFile {
                        name: shown(entry.path()),
                        claim,
                        path: Some(entry.into_path()),
                        is_explicit: false,
                    });
                }
            }
            Err(error) => problems.push(error.to_string()),
        }
    }
    if let Ok(mut folders) = left_out.lock() {
        folders.sort();
        passed_over.folders.append(&mut folders);
    }
    passed_over.made.sort();
    found.sort();
    found
}

/// Folders of dependencies and build output, which are skipped even if git tracks them.
const BUILT: [&str; 2] = ["node_modules", "dist"];

/// The evidence that a script found in a folder is generated; `None` if the configuration lists it.
fn made_by_a_program(path: &Path, claim: Claim) -> Option<&'static str> {
    if claim == Claim::Shader || !is_script(&path.to_string_lossy()) {
        return None;
    }
    let size = fs::metadata(path).ok()?.len();
    let bytes = (size <= MAX_FILE).then(|| fs::read(path).ok()).flatten()?;
    made(&String::from_utf8_lossy(&bytes))
}

/// Whether the configuration lists a file as a shader.
fn claim(path: &Path, configs: &Configs) -> Claim {
    match configs.config(path) {
        Ok(Some(config)) if config.names(&absolute(path)) => Claim::Shader,
        _ => Claim::None,
    }
}

/// Whether a file found in a folder is checked. Errors in its configuration are reported when it is
/// checked.
fn is_taken(path: &Path, configs: &Configs) -> bool {
    let is_known = is_searched(&path.to_string_lossy());
    match configs.config(path) {
        Ok(Some(config)) => config.takes(&absolute(path), is_known),
        Ok(None) | Err(_) => is_known,
    }
}

/// Two requests in a JSON file, as the MCP server writes them.
pub fn requests<A, B>(path: &Path) -> Result<(A, B), String>
where
    A: DeserializeOwned,
    B: DeserializeOwned,
{
    let text = fs::read_to_string(path).map_err(|e| e.to_string())?;
    let first = serde_json::from_str(&text);
    let both = first.and_then(|first| Ok((first, serde_json::from_str(&text)?)));
    both.map_err(|e| e.to_string())
}

/// A path for messages: with forward slashes, and without a leading `./`.
fn shown(path: &Path) -> String {
    let text = slashed(path);
    text.strip_prefix("./").map(str::to_string).unwrap_or(text)
}

pub fn read(input: &InputFile) -> Result<Content, String> {
    let bytes = match &input.path {
        Some(path) => {
            let size = fs::metadata(path).map_err(|e| e.to_string())?.len();
            if size > MAX_FILE {
                return Err(format!(
                    "the file has {size} bytes; the limit is {MAX_FILE}"
                ));
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
    let bytes = super::inflate::inflate(&bytes).unwrap_or(Ok(bytes))?;
    Ok(Content::of(bytes))
}
