//! `--write-baseline` and `--baseline`: known findings, identified by file and fingerprint rather
//! than by line. Paths are relative to the folder of the baseline, not to the current folder.

use super::super::command::{CLEAN, FAILED, complain};
use super::super::config::absolute;
use super::super::global::{Talk, given};
use super::super::input::InputFile;
use super::super::output::{Overwrite, write as write_file};
use super::args::CheckArgs;
use super::inputs::{CheckMode, Outcome, check_all};
use crate::diagnostic::{Diagnostic, count};
use crate::engine::config::Configs;
use crate::report::fingerprints;
use crate::text::Sources;
use crate::text::path::slashed;
use serde_json::{Value, json};
use std::collections::{BTreeMap, HashSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Known findings, which are not reported again.
pub struct Baseline {
    folder: PathBuf,
    /// The findings of each file.
    known: BTreeMap<String, Vec<KnownFinding>>,
    /// How many findings of each file and rule no longer occur.
    stale: BTreeMap<(String, String), usize>,
}

struct KnownFinding {
    rule: String,
    fingerprint: String,
}

impl Baseline {
    /// Reads a baseline file.
    pub fn load(path: &Path) -> io::Result<Baseline> {
        let wrong = |message: &str| io::Error::other(format!("{}: {message}", path.display()));
        let text = fs::read_to_string(path).map_err(|e| wrong(&e.to_string()))?;
        let value: Value = serde_json::from_str(&text).map_err(|e| wrong(&e.to_string()))?;
        let files = value.get("files").and_then(Value::as_object);
        let files = files
            .ok_or_else(|| wrong("not a baseline file; use --write-baseline to create one"))?;
        let known = |entry: &Value| {
            let text = |key: &str| Some(entry.get(key)?.as_str()?.to_string());
            Some(KnownFinding {
                rule: text("rule").unwrap_or_default(),
                fingerprint: text("fingerprint")?,
            })
        };
        let all = |entries: &Value| -> Vec<KnownFinding> {
            let entries = entries.as_array().into_iter().flatten();
            entries.filter_map(known).collect()
        };
        let files = files.iter().map(|(file, e)| (file.clone(), all(e)));
        let mut baseline = Baseline {
            folder: folder_of(path),
            known: files.collect(),
            stale: BTreeMap::new(),
        };
        baseline.forget_files();
        Ok(baseline)
    }

    /// Marks the findings of deleted files as obsolete.
    fn forget_files(&mut self) {
        let folder = self.folder.clone();
        let known = std::mem::take(&mut self.known);
        let (here, removed) = known
            .into_iter()
            .partition(|(f, _)| folder.join(f).is_file());
        self.known = here;
        let removed: BTreeMap<String, Vec<KnownFinding>> = removed;
        for (file, all) in removed {
            all.into_iter().for_each(|k| self.note_stale(&file, k.rule));
        }
    }

    fn note_stale(&mut self, file: &str, rule: String) {
        *self.stale.entry((file.to_string(), rule)).or_default() += 1;
    }

    /// Removes the known findings of one file from `found`.
    pub fn filter(&mut self, file: &str, sources: &Sources, found: &mut Vec<Diagnostic>) {
        let name = named(&self.folder, file);
        let Some(known) = self.known.remove(&name) else {
            return;
        };
        let prints = fingerprints(sources, found);
        let old: HashSet<&str> = known.iter().map(|k| k.fingerprint.as_str()).collect();
        let mut of_found = prints.iter();
        found.retain(|_| of_found.next().is_none_or(|p| !old.contains(p.as_str())));
        let now: HashSet<&str> = prints.iter().map(String::as_str).collect();
        for removed in known
            .iter()
            .filter(|k| !now.contains(k.fingerprint.as_str()))
        {
            self.note_stale(&name, removed.rule.clone());
        }
    }

    /// Messages that list the obsolete entries.
    pub fn stale(&self) -> Vec<String> {
        let line = |((file, rule), count): (&(String, String), &usize)| {
            let times = match count {
                1 => String::new(),
                n => format!(" ({n} times)"),
            };
            format!("{file}: `{rule}` is in the baseline but no longer reported{times}")
        };
        let mut lines: Vec<String> = self.stale.iter().map(line).collect();
        if !lines.is_empty() {
            lines.push("use --write-baseline to remove obsolete entries".to_string());
        }
        lines
    }
}

/// The folder that paths in a baseline are relative to.
fn folder_of(baseline: &Path) -> PathBuf {
    let mut folder = absolute(baseline);
    folder.pop();
    folder
}

/// The path of a file as written in a baseline.
fn named(folder: &Path, file: &str) -> String {
    let path = absolute(Path::new(file));
    let path = path.strip_prefix(folder).unwrap_or(&path);
    slashed(path)
}

/// Writes the findings of all inputs to the baseline file. An existing baseline keeps its entries
/// for other files that still exist.
pub fn write(args: &CheckArgs, inputs: &[InputFile], configs: &Configs) -> io::Result<u8> {
    let Some(path) = &args.write_baseline else {
        return Ok(FAILED);
    };
    let mut old = match path.exists() {
        true => Some(Baseline::load(path)?),
        false => None,
    };
    let mut files: BTreeMap<String, Vec<Value>> = BTreeMap::new();
    let folder = folder_of(path);
    let mut all_well = true;
    let mut written = 0;
    check_all(
        inputs,
        configs,
        CheckMode::default(),
        &mut |input, outcome| {
            match outcome {
                Outcome::Checked(checked) => {
                    let mut report = checked.text.report;
                    let found = &mut report.diagnostics;
                    if let Ok(options) = configs.options(Path::new(&input.name)) {
                        found.retain(|d| options.settings.reports(d.rule));
                    }
                    let prints = fingerprints(&report.sources, found);
                    let entries = found.iter().zip(prints);
                    let entries = entries.map(|(d, p)| entry(d.rule, &p));
                    let entries: Vec<Value> = entries.collect();
                    written += entries.len();
                    if !entries.is_empty() {
                        files.insert(named(&folder, &input.name), entries);
                    }
                    if let Some(old) = &mut old {
                        old.filter(&input.name, &report.sources, found);
                    }
                }
                Outcome::Skipped(..) => {}
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
        },
    )?;
    let old = old.as_ref();
    for (file, known) in old.iter().flat_map(|o| &o.known) {
        let kept = known.iter().map(|k| entry(&k.rule, &k.fingerprint));
        files.insert(file.clone(), kept.collect());
    }
    let mut text = serde_json::to_string_pretty(&json!({"schema": 1, "files": files}))?;
    text.push('\n');
    write_file(path, text.as_bytes(), Overwrite::Allowed)?;
    if given().talk() >= Talk::Normal {
        for ((file, rule), _) in old.iter().flat_map(|o| &o.stale) {
            complain(&format!("{file}: removed `{rule}`"));
        }
        let findings = count(written, "finding");
        complain(&format!("wrote {findings} to {}", path.display()));
    }
    Ok(if all_well { CLEAN } else { FAILED })
}

/// The JSON entry of a finding.
fn entry(rule: &str, fingerprint: &str) -> Value {
    json!({"rule": rule, "fingerprint": fingerprint})
}
