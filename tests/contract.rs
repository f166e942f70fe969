//! What scripts set, compared with what their shaders declare: small programs for each library, each correct, and
//! changes of them with the findings that they cause.
//!
//! A file of `tests/contract` is a program: after `--- NAME` the text of a file, the first is checked. Then follow
//! changes: `=== OLD` and `=> NEW` (empty to remove), and the findings as `FILE:LINE RULE MESSAGE`.

use super::tidy::files;
use shaderlint::diagnostic::Severity;
use shaderlint::engine::{DialectChoice, Options, check};
use shaderlint::lint::Settings;
use shaderlint::rules::RULES;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

type Program = Vec<(String, String)>;

/// The findings in a program.
fn found(program: &Program) -> Vec<String> {
    let settings = Settings::new(RULES, &[], &[]).unwrap();
    let options = Options::new(DialectChoice::Auto, settings);
    let all: BTreeMap<PathBuf, Arc<str>> = program
        .iter()
        .map(|(name, text)| (PathBuf::from(format!("/{name}")), text.as_str().into()))
        .collect();
    let (name, text) = &program[0];
    let report = check(name, text, &options, &all);
    let findings = report.diagnostics.iter();
    let findings = findings.filter(|d| d.severity != Severity::Info);
    let lines = findings.map(|d| {
        let file = report.sources.file_at(d.span.start).unwrap();
        let line = file.position(d.span.start).line;
        format!(
            "{}:{line} {} {}",
            file.path.trim_start_matches('/'),
            d.rule,
            d.message
        )
    });
    lines.collect()
}

struct Change {
    old: String,
    new: String,
    expected: Vec<String>,
}

fn parse(text: &str) -> (Program, Vec<Change>) {
    let (files, changes) = text.split_once("\n=== ").unwrap_or((text, ""));
    let program = files.split("--- ").skip(1).map(|file| {
        let (name, text) = file.split_once('\n').unwrap();
        (name.to_string(), text.to_string())
    });
    let changes = changes
        .split("\n=== ")
        .filter(|c| !c.is_empty())
        .map(|change| {
            let (old, rest) = change
                .split_once("\n=> ")
                .or(change.split_once("\n=>"))
                .unwrap();
            let (new, expected) = rest.split_once('\n').unwrap_or((rest, ""));
            Change {
                old: old.to_string(),
                new: new.to_string(),
                expected: expected
                    .lines()
                    .filter(|l| !l.is_empty())
                    .map(str::to_string)
                    .collect(),
            }
        });
    (program.collect(), changes.collect())
}

#[test]
fn scripts_are_compared_with_their_shaders() {
    let mut wrong = Vec::new();
    for (name, text) in files(&["tests/contract"], ".txt") {
        let (program, changes) = parse(&text);
        for line in found(&program) {
            wrong.push(format!("{name}: {line}"));
        }
        for change in changes {
            let mut changed = program.clone();
            let file = changed
                .iter_mut()
                .find(|(_, text)| text.contains(&change.old));
            let (_, text) = file.unwrap_or_else(|| panic!("{name} has no `{}`", change.old));
            *text = text.replacen(&change.old, &change.new, 1);
            let lines = found(&changed);
            if lines != change.expected {
                let what = format!("=== {}\n=> {}", change.old, change.new);
                wrong.push(format!("{name}\n{what}\n{}", lines.join("\n")));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}
