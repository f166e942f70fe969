//! Whole shaders: what both tools say and write, beside the inputs.
//!
//! `INSTA_UPDATE=always cargo test` accepts what is said now.

use shaderlint::cli::document::{DialectChoice, check};
use shaderlint::cli::input::Content;
use shaderlint::lint::Settings;
use shaderlint::port::{Project, compose, glsl};
use shaderlint::report::render;
use shaderlint::rules::RULES;
use std::fs;
use std::path::{Path, PathBuf};

fn templates() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus/templates");
    let entries = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path());
    let mut found: Vec<PathBuf> = entries
        .filter(|p| p.extension().is_some_and(|e| e == "glsl"))
        .collect();
    found.sort();
    assert!(found.len() >= 3);
    found
}

/// Compares with the golden `NAME.KIND.snap` beside the input.
fn golden(input: &Path, kind: &str, content: String) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(input.parent().unwrap());
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let stem = input.file_stem().unwrap().to_str().unwrap();
    settings.bind(|| insta::assert_snapshot!(format!("{stem}.{kind}"), content));
}

#[test]
fn what_shaderlint_says() {
    for path in templates() {
        let text = fs::read_to_string(&path).unwrap();
        let name = path.file_name().unwrap().to_str().unwrap();
        let settings = Settings::new(RULES, &[], &[]).unwrap();
        let findings = check(name, Content::utf8(&text), DialectChoice::Auto, &settings);
        let findings = findings.unwrap_or_else(|_| panic!("{name} cannot be judged"));
        let said: Vec<String> = findings
            .diagnostics
            .iter()
            .map(|d| render(&findings.sources, d))
            .collect();
        golden(&path, "lint", said.join("\n"));
    }
}

#[test]
fn what_shaderport_writes() {
    for path in templates() {
        let text = fs::read_to_string(&path).unwrap();
        let stem = path.file_stem().unwrap().to_str().unwrap();
        let project = Project::from_shader(stem, &text).unwrap();
        let composed = compose(&project, stem).unwrap();
        let passes = glsl(&project, &composed);
        assert_eq!(passes.len(), 1);
        assert!(
            passes[0].fragment.ends_with(&text),
            "the user's text stays as it is"
        );
        golden(&path, "port", passes[0].fragment.clone());
    }
}
