//! What the formatter preserves in complete files: the tokens, the compiled result, and its own
//! output.
//!
//! `SHADERLINT_CASES=DIR cargo test --test all formatting` also reads the ShaderToy exports in
//! `DIR/shadertoy`.

use shaderlint::detect::kind::Claim;
use shaderlint::engine::{Options, analyze, format};
use shaderlint::format::{Brace, Indentation, Style};
use shaderlint::ir::print;
use shaderlint::project::NoFiles;
use shaderlint::syntax::{RawKind, tokenize};
use shaderlint::text::apply_edits;
use std::fs;
use std::path::{Path, PathBuf};

/// All shaders and exports in a folder.
fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let suffix = path.extension().and_then(|e| e.to_str()).unwrap_or("");
        match path.is_dir() {
            true => files(&path, found),
            false if ["glsl", "frag", "vert", "json"].contains(&suffix) => found.push(path),
            false => {}
        }
    }
}

/// The IR of each shader of a file; `None` for those with errors.
fn modules(name: &str, text: &str) -> Vec<Option<String>> {
    let report = analyze(name, text, &Options::default(), &NoFiles);
    // Source positions follow slashes; they change.
    let lines = |text: String| -> String {
        let shown = text.lines().map(|l| l.split(" // ").next().unwrap_or(l));
        shown.map(|l| l.trim_end().to_string() + "\n").collect()
    };
    let analyses = report.analyses.iter();
    let module = analyses.map(|a| (!a.has_errors).then(|| lines(print(&a.program, a.module()))));
    module.collect()
}

/// The tokens of a text, without white space.
fn tokens(text: &str) -> Vec<&str> {
    let raw = tokenize(text, 0);
    let is_shown = |kind| !matches!(kind, RawKind::Whitespace | RawKind::Newline);
    let shown = raw.into_iter().filter(|t| is_shown(t.kind));
    shown
        .map(|t| &text[t.span.start as usize..t.span.end as usize])
        .collect()
}

fn formatted(name: &str, text: &str, style: &Style) -> Option<String> {
    let formatting = format(name, text, Claim::None, style).ok()?;
    Some(apply_edits(text, 0, &formatting.edits).unwrap())
}

/// Checks a file with a style; returns whether it was formatted.
fn check(path: &Path, style: &Style) -> bool {
    let name = path.to_string_lossy();
    let Ok(text) = fs::read_to_string(path) else {
        return false;
    };
    let Some(once) = formatted(&name, &text, style) else {
        return false;
    };
    assert_eq!(
        formatted(&name, &once, style).as_ref(),
        Some(&once),
        "{name}: formatting is not idempotent"
    );
    // In an export the code is a string that contains the line breaks.
    if !name.ends_with(".json") {
        assert_eq!(tokens(&text), tokens(&once), "{name}: the tokens differ");
    }
    let (before, after) = (modules(&name, &text), modules(&name, &once));
    for (before, after) in before.iter().zip(&after) {
        // An error may disappear: blank lines before `#version` are removed.
        assert!(
            before.is_none() || before == after,
            "{name}: the IR differs"
        );
    }
    assert_eq!(before.len(), after.len(), "{name}");
    true
}

fn check_all(folder: &Path, at_least: usize) {
    let mut found = Vec::new();
    files(folder, &mut found);
    let narrow = Style {
        indent: Indentation::Tab(8),
        width: 60,
        brace: Brace::Next,
    };
    for style in [Style::default(), narrow] {
        let formatted = found.iter().filter(|path| check(path, &style)).count();
        assert!(
            formatted >= at_least,
            "only {formatted} files were formatted"
        );
    }
}

#[test]
fn formatting_preserves_the_corpus() {
    check_all(&Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus"), 60);
}

#[test]
fn formatting_preserves_exports() {
    if let Some(cases) = std::env::var_os("SHADERLINT_CASES") {
        check_all(&Path::new(&cases).join("shadertoy"), 300);
    }
}
