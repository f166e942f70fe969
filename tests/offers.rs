//! Every fix that the examples of the pages and the corpus are offered, applied alone: the result has
//! no new error, and after a safe fix no new finding that is left to the author.

use super::pages::choice;
use shaderlint::diagnostic::{Applicability, Diagnostic, Fix, Severity};
use shaderlint::engine::{Options, Report, check};
use shaderlint::lint::{FenceKind, Page, Settings};
use shaderlint::project::NoFiles;
use shaderlint::rules::RULES;
use shaderlint::text::apply_edits;
use std::fs;
use std::path::{Path, PathBuf};

/// File name and text of an example.
type Example = (String, String);

fn files(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let entries = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path());
    let mut files: Vec<PathBuf> = entries.filter(|path| path.is_file()).collect();
    files.sort();
    files
}

fn examples() -> Vec<Example> {
    let mut found = Vec::new();
    for page in [files("rules"), files("rules/errors")].concat() {
        if page.extension().is_none_or(|e| e != "md") || page.ends_with("README.md") {
            continue;
        }
        let text = fs::read_to_string(&page).unwrap();
        let page = Page::new(&text);
        let bad = page.fences.iter().filter(|f| f.kind == FenceKind::Bad);
        found.extend(bad.map(|f| (f.file.to_string(), text[f.range.clone()].to_string())));
    }
    for folder in ["corpus/mistakes", "corpus/pitfalls", "corpus/templates"] {
        for path in files(folder) {
            let name = path.file_name().unwrap().to_str().unwrap().to_string();
            let is_output = [".txt", ".md", ".snap", ".png"];
            if !is_output.iter().any(|end| name.ends_with(end)) {
                found.push((name, fs::read_to_string(&path).unwrap()));
            }
        }
    }
    found
}

fn errors(report: &Report) -> usize {
    let all = report.diagnostics.iter();
    all.filter(|d| d.severity == Severity::Error).count()
}

/// The findings that only the author can resolve.
fn left(report: &Report) -> usize {
    let is_safe = |fix: &Fix| fix.applicability == Applicability::Safe;
    let all = report.diagnostics.iter();
    all.filter(|d| !d.fix.as_ref().is_some_and(is_safe)).count()
}

/// What is wrong with a fix, if anything.
fn trouble(example: &Example, before: &Report, found: &Diagnostic, fix: &Fix) -> Option<String> {
    let (name, text) = example;
    let base = before.sources.file(before.file?)?.base;
    let fixed = match apply_edits(text, base, &fix.edits) {
        Ok(fixed) => fixed,
        Err(e) => return Some(format!("{e:?}")),
    };
    let after = check(name, &fixed, &options(example), &NoFiles);
    let mended = usize::from(found.severity == Severity::Error);
    if errors(&after) + mended > errors(before) {
        let all = after.diagnostics.iter();
        let all: Vec<_> = all
            .filter(|d| d.severity == Severity::Error)
            .map(|d| &d.message)
            .collect();
        return Some(format!("{} errors became {all:?}", errors(before)));
    }
    // Rules run only where there is no error.
    let is_safe = mended == 0 && fix.applicability == Applicability::Safe;
    if is_safe && left(&after) > left(before) {
        let all: Vec<_> = after
            .diagnostics
            .iter()
            .map(|d| (d.rule, &d.message))
            .collect();
        return Some(format!("new findings: {all:?}"));
    }
    None
}

fn options(example: &Example) -> Options {
    let all = Settings::new(RULES, &["all".to_string()], &[]).unwrap();
    Options::new(choice(&example.0, &example.1), all)
}

#[test]
fn offered_fixes_remove_their_finding() {
    let (mut tried, mut problems) = (0, Vec::new());
    for example in examples() {
        let report = check(&example.0, &example.1, &options(&example), &NoFiles);
        for found in &report.diagnostics {
            let Some(fix) = &found.fix else { continue };
            tried += 1;
            if let Some(trouble) = trouble(&example, &report, found, fix) {
                problems.push(format!(
                    "{}: {}: {}: {trouble}\n{}",
                    found.rule, found.message, fix.title, example.1
                ));
            }
        }
    }
    println!("{tried} fixes");
    assert!(
        problems.is_empty(),
        "{} of {tried}:\n{}",
        problems.len(),
        problems.join("\n----\n")
    );
}
