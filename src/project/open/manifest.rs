//! Files of other tools beside passes that say what the passes are and what they read.
//!
//! Tools that play ShaderToy code from folders each have a file of their own, in JSON or TOML.
//! They differ in structure, but name passes, channels and files alike: `image`, `Buffer A`,
//! `iChannel0`. A file is read if it connects a channel of a pass to a pass or to a file.

use super::channels::{CHANNELS, GivenOrder, placed};
use crate::files::{FileType, Files};
use crate::{ChannelName, ChannelOrder, ChannelSource, PassRole};
use serde_json::{Map, Value};
use shaderlint_semantic::channel;
use shaderlint_text::path::slashed;
use std::path::{Path, PathBuf};

/// Size limit in bytes of files that are read.
const MAX_MANIFEST: usize = 1024 * 1024;
/// Maximum number of files that are read.
const MAX_FILES: usize = 16;

/// What a file says about passes.
#[derive(Default)]
pub(super) struct Manifest {
    /// The files of passes.
    pub passes: Vec<(PassRole, PathBuf)>,
    /// What channels read.
    pub orders: Vec<GivenOrder>,
    /// What was read, or was not.
    pub notes: Vec<String>,
    /// The files that were read.
    pub read: Vec<PathBuf>,
}

/// Reads the files of other tools in a folder of passes.
pub(super) fn manifest(folder: &Path, files: &dyn Files) -> Manifest {
    let mut names = files.names(folder);
    names.retain(|name| name.ends_with(".json") || name.ends_with(".toml"));
    names.retain(|name| !name.ends_with(CHANNELS));
    names.sort();
    let mut found = Manifest::default();
    for name in names.iter().take(MAX_FILES) {
        let path = folder.join(name);
        let text = files
            .load(&path)
            .ok()
            .filter(|text| text.len() <= MAX_MANIFEST);
        let Some(value) = text.and_then(|text| parsed(name, &text)) else {
            continue;
        };
        let mut reader = ManifestReader {
            path: &path,
            files,
            passes: Vec::new(),
            orders: Vec::new(),
            names_passes: false,
        };
        reader.value(&value, None);
        let ManifestReader {
            passes,
            orders,
            names_passes,
            ..
        } = reader;
        if !orders.is_empty() && found.read.is_empty() {
            let shown: Vec<String> = orders.iter().map(|(_, shown)| shown.clone()).collect();
            found
                .notes
                .push(format!("{} (from {name})", shown.join(", ")));
            let orders = orders.into_iter().map(|(order, _)| GivenOrder {
                by: slashed(&path),
                order,
            });
            (found.orders, found.passes) = (orders.collect(), passes);
            found.read.push(path);
        } else if names_passes {
            found
                .notes
                .push(format!("{name} names passes, but was not understood"));
        }
    }
    found
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
    path: &'a Path,
    files: &'a dyn Files,
    passes: Vec<(PassRole, PathBuf)>,
    /// The orders, with how they are shown.
    orders: Vec<(ChannelOrder, String)>,
    names_passes: bool,
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
                    self.names_passes = true;
                    self.value(value, Some(pass));
                }
                (Some(pass), _, _, Value::String(file)) => {
                    let file = self.path.with_file_name(file.trim_start_matches("./"));
                    let is_shader = crate::files::passes::is_shader(&slashed(&file));
                    if is_shader && self.files.entry(&file) == Some(FileType::File) {
                        self.passes.push((pass, file));
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
            let file = self.path.with_file_name(word);
            match pass_of(word) {
                Some(role) => Some(ChannelSource::Pass(role)),
                None if self.files.entry(&file) == Some(FileType::File) => {
                    Some(ChannelSource::File((*word).to_string()))
                }
                None => None,
            }
        });
        let Some(source) = source.filter(|_| number < 4) else {
            return;
        };
        let shown = match &source {
            ChannelSource::Pass(role) => role.name().to_string(),
            ChannelSource::File(file) => file.clone(),
            _ => return,
        };
        let order = ChannelOrder {
            pass: Some(pass),
            channel: ChannelName::Number(number),
            source,
            filter: None,
            wrap: None,
            vflip: None,
        };
        if let Ok(order) = placed(order, self.path, self.files) {
            let shown = format!("{}.{number} = {shown}", pass.name());
            self.orders.push((order, shown));
        }
    }
}

/// The pass that a name, or the path of a shader, denotes.
fn pass_of(word: &str) -> Option<PassRole> {
    let name = word.rsplit('/').next().unwrap_or(word);
    let stem = match name.rsplit_once('.') {
        Some((stem, _)) if crate::files::passes::is_shader(name) => stem,
        Some(_) => return None,
        None => name,
    };
    PassRole::of_name(stem).filter(|_| word.len() < 256)
}
