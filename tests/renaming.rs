//! Renaming preserves the meaning of a shader: the IR is the same except for names.
//!
//! `SHADERLINT_CASES=DIR cargo test --test all renaming` also reads the ShaderToy exports in
//! `DIR/shadertoy`; `SHADERLINT_RENAMED=N` renames N names of each file instead of four.

use shaderlint::engine::{Options, analyze};
use shaderlint::ide::{Document, NameUse, may_rename, rename};
use shaderlint::ir::print;
use shaderlint::lint::Settings;
use shaderlint::project::NoFiles;
use shaderlint::text::apply_edits;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The new name for everything; no shader contains it.
const NEW: &str = "renamedByTest";

/// Keywords of the printed IR, which cannot be distinguished from names in it.
const WORDS: [&str; 25] = [
    "bits",
    "call",
    "column",
    "global",
    "head",
    "line",
    "local",
    "loop",
    "name",
    "number",
    "product",
    "returned",
    "returns",
    "select",
    "splat",
    "step",
    "symbol",
    "temporary",
    "test",
    "text",
    "undefined",
    "unknown",
    "unnamed",
    "value",
    "word",
];

/// All shaders and exports in a folder, sorted by name.
fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let extension = path.extension().and_then(|e| e.to_str()).unwrap_or("");
        match path.is_dir() {
            true => files(&path, found),
            false if ["glsl", "frag", "vert", "json"].contains(&extension) => found.push(path),
            false => {}
        }
    }
    found.sort();
}

/// Two forms of a printed IR, neither of which depends on the renamed name.
#[derive(PartialEq, Debug)]
struct Meaning {
    /// With the old name substituted for the new one. A second variable of the same name in a
    /// function has a number, which is omitted.
    renamed_back: String,
    /// By function: each name replaced by the number of its first appearance, so that variables
    /// with the same name are distinguished.
    numbered: String,
}

/// The role of a word in the printed IR.
#[derive(PartialEq)]
enum WordUse {
    /// Not a name.
    None,
    /// A function or a member.
    Other,
    Variable,
}

/// Calls `visit` with each word of a text, and with the text between words.
fn each_word<'t>(text: &'t str, mut visit: impl FnMut(&'t str, WordUse)) {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '\'';
    let mut rest = text;
    while let Some(start) = rest.find(is_word) {
        let (before, from) = rest.split_at(start);
        let end = from.find(|c| !is_word(c)).unwrap_or(from.len());
        let (word, after) = from.split_at(end);
        visit(before, WordUse::None);
        visit(
            word,
            match () {
                () if word.starts_with(|c: char| c.is_ascii_digit()) => WordUse::None,
                () if after.starts_with('(') || before.ends_with('.') => WordUse::Other,
                () => WordUse::Variable,
            },
        );
        rest = after;
    }
    visit(rest, WordUse::None);
}

fn meaning(printed: &str, old: &str) -> Meaning {
    let (mut renamed_back, mut numbered) = (String::new(), String::new());
    let mut numbers: BTreeMap<&str, usize> = BTreeMap::new();
    for line in printed.lines() {
        // A line without indentation begins an item; source positions follow slashes; they change.
        if !line.starts_with(' ') {
            numbers.clear();
        }
        let message = line.split(" // ").next().unwrap_or(line).trim_end();
        each_word(message, |word, of| {
            if of == WordUse::None {
                renamed_back.push_str(word);
                return numbered.push_str(word);
            }
            let plain = word.split('\'').next().unwrap_or(word);
            let plain = if plain == NEW { old } else { plain };
            renamed_back.push_str(plain);
            if of == WordUse::Other {
                return numbered.push_str(plain);
            }
            let next = numbers.len();
            numbered.push_str(&format!("n{}", numbers.entry(word).or_insert(next)));
        });
        renamed_back.push('\n');
        numbered.push('\n');
    }
    Meaning {
        renamed_back,
        numbered,
    }
}

/// Options that only compile: no rule runs, so that no shader is drawn.
fn without_rules() -> Options {
    Options {
        settings: Arc::new(Settings::of_rules(&[])),
        ..Options::default()
    }
}

/// The IR of each shader of a file; `None` for those with errors.
fn modules(name: &str, text: &str) -> Vec<Option<String>> {
    let report = analyze(name, text, &without_rules(), &NoFiles);
    let analyses = report.analyses.iter();
    let module = analyses.map(|a| (!a.has_errors).then(|| print(&a.program, a.module())));
    module.collect()
}

/// Declarations of renameable names, spread over the document.
fn places(document: &Document, count: usize) -> Vec<u32> {
    let mut found = BTreeSet::new();
    for (_, index) in document.shaders() {
        let declared = index.all.iter().filter(|o| o.access == NameUse::Defined);
        let places = declared.filter_map(|o| document.report.in_input(o.span));
        found.extend(places.map(|span| span.start));
    }
    let can_be = |at: &u32| {
        may_rename(document, *at, &NoFiles).is_ok_and(|(_, name)| !WORDS.contains(&name.as_str()))
    };
    let found: Vec<u32> = found.into_iter().filter(can_be).collect();
    let step = found.len().div_ceil(count).max(1);
    found.into_iter().step_by(step).collect()
}

/// Renames names of a file; returns how many were renamed, and the reasons for the others.
fn check(path: &Path, count: usize) -> (usize, Vec<String>) {
    let name = path.to_string_lossy();
    let Ok(text) = fs::read_to_string(path) else {
        return (0, Vec::new());
    };
    let options = Arc::new(without_rules());
    let document = Document::new(&name, text.as_str().into(), options, &NoFiles);
    let mut before = modules(&name, &text);
    let alternatives = document.alternatives(&NoFiles).iter();
    before.extend(alternatives.flat_map(|other| modules(&name, &other.text)));
    // If all shaders have errors, there is nothing to compare.
    if before.iter().all(Option::is_none) {
        return (0, Vec::new());
    }
    let places = places(&document, count);
    let (mut renamed, mut refused) = (0, Vec::new());
    for place in places {
        let renaming = match rename(&[&document], &document, place, NEW, &NoFiles) {
            Ok(renaming) => renaming,
            Err(refusal) => {
                refused.push(format!("{name}, byte {place}: {refusal}"));
                continue;
            }
        };
        let edits = &renaming.edits[&*name];
        let after = apply_edits(&text, 0, edits).unwrap();
        let (_, old) = may_rename(&document, place, &NoFiles).unwrap();
        let mut now = modules(&name, &after);
        let document = Document::new(&name, after.into(), Arc::new(without_rules()), &NoFiles);
        let alternatives = document.alternatives(&NoFiles).iter();
        now.extend(alternatives.flat_map(|other| modules(&name, &other.text)));
        assert_eq!(now.len(), before.len(), "{name} at {place}");
        for (before, now) in before.iter().zip(&now) {
            // An error may disappear: the old name was reserved.
            let Some(before) = before else {
                continue;
            };
            let now = now.as_ref().map(|now| meaning(now, &old));
            assert!(
                now == Some(meaning(before, &old)),
                "{name}: the IR differs after renaming `{old}` at {place}"
            );
        }
        renamed += 1;
    }
    (renamed, refused)
}

fn check_all(folder: &Path, at_least: usize) {
    let mut found = Vec::new();
    files(folder, &mut found);
    let asked = std::env::var("SHADERLINT_RENAMED").ok();
    let count = asked.and_then(|n| n.parse().ok()).unwrap_or(4);
    let (mut renamed, mut refused) = (0, Vec::new());
    for path in &found {
        let (done, others) = check(path, count);
        renamed += done;
        refused.extend(others);
    }
    println!("{renamed} names renamed, {} refused:", refused.len());
    refused.iter().for_each(|why| println!("  {why}"));
    assert!(renamed >= at_least, "only {renamed} names were renamed");
    assert!(refused.len() * 50 <= renamed, "{refused:#?}");
}

#[test]
fn renaming_preserves_the_corpus() {
    check_all(&Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus"), 100);
}

#[test]
fn renaming_preserves_exports() {
    if let Some(cases) = std::env::var_os("SHADERLINT_CASES") {
        check_all(&Path::new(&cases).join("shadertoy"), 1_000);
    }
}
