//! `--write-baseline` and `--baseline`: findings that were there before, by file and fingerprint, so
//! that lines may move. Files are named from the folder of the baseline, whatever folder the command
//! runs in.

use super::super::config::{Configs, absolute};
use super::super::input::InputFile;
use super::super::output::{Overwrite, write as write_file};
use super::super::{CLEAN, FAILED};
use super::args::Args;
use super::complain;
use super::examine::{Outcome, examine_all};
use crate::diagnostic::Diagnostic;
use crate::report::fingerprints;
use crate::text::Sources;
use serde_json::{Value, json};
use std::collections::{BTreeMap, HashMap, HashSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Findings that are left out.
pub struct Baseline {
    folder: PathBuf,
    /// By file.
    known: HashMap<String, HashSet<String>>,
}

impl Baseline {
    /// Reads the file.
    pub fn load(path: &Path) -> io::Result<Baseline> {
        let wrong = |message: &str| io::Error::other(format!("{}: {message}", path.display()));
        let text = fs::read_to_string(path).map_err(|e| wrong(&e.to_string()))?;
        let value: Value = serde_json::from_str(&text).map_err(|e| wrong(&e.to_string()))?;
        let files = value.get("files").and_then(Value::as_object);
        let files =
            files.ok_or_else(|| wrong("this is no baseline; --write-baseline writes one"))?;
        let prints = |entries: &Value| -> HashSet<String> {
            let entries = entries.as_array().into_iter().flatten();
            let prints = entries.filter_map(|e| e.get("fingerprint")?.as_str());
            prints.map(str::to_string).collect()
        };
        let known = files.iter().map(|(file, e)| (file.clone(), prints(e)));
        Ok(Baseline {
            folder: folder_of(path),
            known: known.collect(),
        })
    }

    /// Takes away the findings of one file that it knows.
    pub fn filter(&self, file: &str, sources: &Sources, found: &mut Vec<Diagnostic>) {
        let Some(known) = self.known.get(&named(&self.folder, file)) else {
            return;
        };
        let mut prints = fingerprints(sources, found).into_iter();
        found.retain(|_| prints.next().is_none_or(|p| !known.contains(&p)));
    }
}

/// The folder that the files of a baseline are named from.
fn folder_of(baseline: &Path) -> PathBuf {
    let mut folder = absolute(baseline);
    folder.pop();
    folder
}

/// The name of a file in a baseline.
fn named(folder: &Path, file: &str) -> String {
    let path = absolute(Path::new(file));
    let path = path.strip_prefix(folder).unwrap_or(&path);
    path.to_string_lossy().replace('\\', "/")
}

/// Writes the findings of all inputs into the file that the arguments name.
pub fn write(args: &Args, inputs: &[InputFile], configs: &Configs) -> io::Result<u8> {
    let Some(path) = &args.write_baseline else {
        return Ok(FAILED);
    };
    let mut files: BTreeMap<String, Vec<Value>> = BTreeMap::new();
    let folder = folder_of(path);
    let mut all_well = true;
    let mut count = 0;
    examine_all(inputs, configs, None, &mut |input, outcome| {
        match outcome {
            Outcome::Checked(findings, _) => {
                let prints = fingerprints(&findings.sources, &findings.diagnostics);
                let entries = findings.diagnostics.iter().zip(prints);
                let entries = entries.map(|(d, p)| json!({"rule": d.rule, "fingerprint": p}));
                let entries: Vec<Value> = entries.collect();
                count += entries.len();
                if !entries.is_empty() {
                    files.insert(named(&folder, &input.name), entries);
                }
            }
            Outcome::Skipped => {}
            Outcome::Failed(message) => {
                complain(&format!("{}: {message}", input.name));
                all_well = false;
            }
            Outcome::Misconfigured(message) => {
                complain(&message);
                all_well = false;
            }
        }
        Ok(())
    })?;
    let mut text = serde_json::to_string_pretty(&json!({"schema": 1, "files": files}))?;
    text.push('\n');
    write_file(path, text.as_bytes(), Overwrite::Allowed)?;
    let noun = if count == 1 { "finding" } else { "findings" };
    complain(&format!("{count} {noun} written to {}", path.display()));
    Ok(if all_well { CLEAN } else { FAILED })
}
