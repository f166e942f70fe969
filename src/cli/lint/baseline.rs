//! `--write-baseline` and `--baseline`: findings that were there before, by fingerprint, so that
//! lines may move.

use super::super::config::Configs;
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
use std::collections::{BTreeMap, HashSet};
use std::fs;
use std::io;
use std::path::Path;

/// Findings that are left out.
pub struct Baseline {
    known: HashSet<String>,
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
        let prints = files.values().filter_map(Value::as_array).flatten();
        let prints = prints.filter_map(|f| f.get("fingerprint")?.as_str());
        Ok(Baseline {
            known: prints.map(str::to_string).collect(),
        })
    }

    /// Takes away the findings of one file that it knows.
    pub fn filter(&mut self, sources: &Sources, found: &mut Vec<Diagnostic>) {
        let mut prints = fingerprints(sources, found).into_iter();
        found.retain(|_| prints.next().is_none_or(|p| !self.known.contains(&p)));
    }
}

/// Writes the findings of all inputs into the file that the arguments name.
pub fn write(args: &Args, inputs: &[InputFile], configs: &Configs) -> io::Result<u8> {
    let Some(path) = &args.write_baseline else {
        return Ok(FAILED);
    };
    let mut files: BTreeMap<String, Vec<Value>> = BTreeMap::new();
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
                    files.insert(input.name.clone(), entries);
                }
            }
            Outcome::Skipped => {}
            Outcome::Failed(message) => {
                complain(&format!("{}: {message}", input.name));
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
