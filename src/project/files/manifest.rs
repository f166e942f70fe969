//! Files of other tools beside passes that say what the passes are and what they read.
//!
//! Tools that play ShaderToy code from folders each have a file of their own, in JSON or TOML.
//! They differ in structure, but name passes, channels and files alike: `image`, `Buffer A`,
//! `iChannel0`. A file is understood if it connects a channel of a pass to a pass or to a file.

use super::pass_name::is_shader;
use super::{FileType, Files};
use crate::{ChannelSource, PassRole};
use serde_json::{Map, Value};
use shaderlint_semantic::channel;
use shaderlint_text::path::slashed;
use std::path::{Component, Path, PathBuf};

/// The ending of files of orders, which are not of other tools.
pub const CHANNELS: &str = "channels.toml";
/// Size limit in bytes of files that are read.
const MAX_MANIFEST: usize = 1024 * 1024;
/// Maximum number of files that are read.
const MAX_FILES: usize = 16;

/// What a file of another tool says about passes.
#[derive(Debug)]
pub struct Manifest {
    /// The file.
    pub path: PathBuf,
    /// The files of passes.
    pub passes: Vec<(PassRole, PathBuf)>,
    /// What channels read: a pass, its channel, and the source.
    pub channels: Vec<(PassRole, u8, ChannelSource)>,
    /// Whether it names passes, understood or not.
    pub names_passes: bool,
}

impl Manifest {
    /// Reads the files of other tools among the names in a folder.
    pub fn among(names: &[String], folder: &Path, files: &dyn Files) -> Vec<Manifest> {
        let is_data = |name: &&String| name.ends_with(".json") || name.ends_with(".toml");
        let named = names.iter().filter(is_data);
        let named = named.filter(|name| !name.ends_with(CHANNELS));
        let read = |name: &String| {
            let path = folder.join(name);
            let text = files.load(&path).ok();
            let text = text.filter(|text| text.len() <= MAX_MANIFEST)?;
            let mut reader = ManifestReader {
                files,
                manifest: Manifest {
                    path,
                    passes: Vec::new(),
                    channels: Vec::new(),
                    names_passes: false,
                },
            };
            reader.value(&parsed(name, &text)?, None);
            Some(reader.manifest)
        };
        named.take(MAX_FILES).filter_map(read).collect()
    }
}

fn parsed(name: &str, text: &str) -> Option<Value> {
    match name.ends_with(".json") {
        true => serde_json::from_str(text).ok(),
        #[cfg(feature = "cli")]
        false => toml::from_str(text).ok(),
        #[cfg(not(feature = "cli"))]
        false => None,
    }
}

struct ManifestReader<'a> {
    files: &'a dyn Files,
    manifest: Manifest,
}

impl ManifestReader<'_> {
    /// Reads a value that is about a pass, if that is known.
    fn value(&mut self, value: &Value, pass: Option<PassRole>) {
        match value {
            Value::Array(all) => all.iter().for_each(|value| self.value(value, pass)),
            Value::Object(map) => self.table(map, pass),
            _ => {}
        }
    }

    fn table(&mut self, map: &Map<String, Value>, pass: Option<PassRole>) {
        let named = || map.values().find_map(|value| pass_of(value.as_str()?));
        let pass = pass.or_else(named);
        if let (Some(pass), Some(number)) = (pass, map.get("channel").and_then(Value::as_u64)) {
            let number = u8::try_from(number).unwrap_or(u8::MAX);
            self.channel(pass, number, &Value::Object(map.clone()));
            return;
        }
        for (key, value) in map {
            let number = channel(key).or_else(|| key.parse().ok());
            match (pass, number, pass_of(key), value) {
                (Some(pass), Some(number), ..) => self.channel(pass, number, value),
                (_, _, Some(pass), Value::Object(_) | Value::Array(_)) => {
                    self.manifest.names_passes = true;
                    self.value(value, Some(pass));
                }
                (Some(pass), _, _, Value::String(file)) => {
                    let relative = Path::new(file.trim_start_matches("./"));
                    let mut parts = relative.components();
                    let is_inside = parts.all(|part| part != Component::ParentDir);
                    let file = self.manifest.path.with_file_name(relative);
                    let is_shader = is_shader(&slashed(&file));
                    if is_inside && is_shader && self.files.entry(&file) == Some(FileType::File) {
                        self.manifest.passes.push((pass, file));
                    }
                }
                _ => self.value(value, pass),
            }
        }
    }

    /// Reads what a channel reads: a name, or a table in which one value is a name.
    fn channel(&mut self, pass: PassRole, number: u8, value: &Value) {
        let words: Vec<&str> = match value {
            Value::String(word) => vec![word],
            Value::Object(map) => map.values().filter_map(Value::as_str).collect(),
            _ => Vec::new(),
        };
        let source = words.iter().find_map(|word| {
            let file = self.manifest.path.with_file_name(word);
            match pass_of(word) {
                Some(role) => Some(ChannelSource::Pass(role)),
                None if self.files.entry(&file) == Some(FileType::File) => {
                    Some(ChannelSource::File((*word).to_string()))
                }
                None => None,
            }
        });
        if let Some(source) = source.filter(|_| number < 4) {
            self.manifest.channels.push((pass, number, source));
        }
    }
}

/// The pass that a name, or the path of a shader, denotes.
fn pass_of(word: &str) -> Option<PassRole> {
    let name = word.rsplit('/').next().unwrap_or(word);
    let stem = match name.rsplit_once('.') {
        Some((stem, _)) if is_shader(name) => stem,
        Some(_) => return None,
        None => name,
    };
    PassRole::of_name(stem).filter(|_| word.len() < 256)
}
