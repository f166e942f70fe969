//! Complete shaders with the diagnostics and output of both tools next to the inputs.
//!
//! `INSTA_UPDATE=always cargo test` accepts the current output.

use super::recorded::stale;
use shaderlint::engine::{Options, analyze, check};
use shaderlint::ir::{print, verify};
use shaderlint::port::glsl;
use shaderlint::project::NoFiles;
use shaderlint::project::{Project, compose};
use shaderlint::report::render;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

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

/// Compares with the snapshot `NAME.KIND.snap` next to the input.
fn golden(input: &Path, kind: &str, content: String) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(input.parent().unwrap());
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let stem = input.file_stem().unwrap().to_str().unwrap();
    settings.bind(|| insta::assert_snapshot!(format!("{stem}.{kind}"), content));
}

#[test]
fn templates_have_recorded_findings() {
    for path in templates() {
        let text = fs::read_to_string(&path).unwrap();
        let name = path.file_name().unwrap().to_str().unwrap();
        let report = check(name, &text, &Options::default(), &NoFiles);
        assert!(report.unread.is_none(), "{name} cannot be checked");
        let messages: Vec<String> = report
            .diagnostics
            .iter()
            .map(|d| render(&report.sources, d))
            .collect();
        golden(&path, "lint", messages.join("\n"));
    }
}

#[test]
fn templates_have_recorded_ports() {
    for path in templates() {
        let text = fs::read_to_string(&path).unwrap();
        let stem = path.file_stem().unwrap().to_str().unwrap();
        let project = Project::from_shader(stem, &text).unwrap();
        let composed = compose(&project, stem).unwrap();
        let passes = glsl(&project, &composed);
        assert_eq!(passes.len(), 1);
        assert!(
            passes[0].text.ends_with(&text),
            "the user's text is unchanged"
        );
        golden(&path, "port", passes[0].text.clone());
    }
}

#[test]
fn templates_have_recorded_ir() {
    for path in templates() {
        let text = fs::read_to_string(&path).unwrap();
        let name = path.file_name().unwrap().to_str().unwrap();
        let report = analyze(name, &text, &Options::default(), &NoFiles);
        let printed = report.analyses.iter().map(|analysis| {
            let (program, module) = (&analysis.program, analysis.module());
            assert_eq!(verify(program, module), []);
            print(program, module)
        });
        golden(&path, "ir", printed.collect());
    }
}

/// The shaders in a folder of the corpus, sorted by name; fails if there are fewer than `least`.
fn shaders(folder: &str, least: usize) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("corpus")
        .join(folder);
    let entries = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path());
    let mut found: Vec<PathBuf> = entries
        .filter(|p| p.extension().is_some_and(|e| e != "txt" && e != "md"))
        .collect();
    found.sort();
    assert!(found.len() >= least);
    found
}

/// Exit code and human-readable output for a file, without colours.
fn printed(path: &Path, args: &[&str]) -> (Option<i32>, String) {
    let folder = path.parent().unwrap();
    let done = Command::new(env!("CARGO_BIN_EXE_shaderlint"))
        .current_dir(folder)
        .args(["--no-config", "--info", "--color", "never"])
        .args(args)
        .arg(path.file_name().unwrap())
        .output()
        .unwrap();
    let text = String::from_utf8(done.stdout).unwrap();
    (done.status.code(), text)
}

/// Each mistake, the output for it in a file next to it, and a table of all of them.
#[test]
fn mistakes_have_recorded_output() {
    let mut table = String::from(
        "# Mistakes\n\nShaders with one typical mistake each, and the output of `shaderlint`.\n\n\
         | file | first line of the output |\n|---|---|\n",
    );
    let mut outdated = Vec::new();
    for path in shaders("mistakes", 40) {
        let name = path.file_name().unwrap().to_str().unwrap().to_string();
        let (code, text) = printed(&path, &[]);
        assert_eq!(code, Some(1), "{name} has no error");
        let first = text.lines().next().unwrap_or("").replace('|', "\\|");
        table.push_str(&format!(
            "| [{name}]({name}), [output]({name}.txt) | {first} |\n"
        ));
        outdated.extend(stale(&path.with_file_name(format!("{name}.txt")), &text));
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus/mistakes");
    outdated.extend(stale(&folder.join("README.md"), &table));
    assert!(outdated.is_empty(), "{}", outdated.join("\n\n"));
}

/// A rule reports each pitfall, the output is in a file next to it, and the fixed twin has no
/// findings.
#[test]
fn pitfalls_have_recorded_output_and_a_fixed_twin() {
    let mut table = String::from(
        "# Pitfalls\n\nShaders that compile but do not draw what they should, the output of `shaderlint`, \
         and a fixed version without findings.\n\n\
         | file | fixed | first line of the output |\n|---|---|---|\n",
    );
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus/pitfalls");
    let mut outdated = Vec::new();
    for path in shaders("pitfalls", 20) {
        let name = path.file_name().unwrap().to_str().unwrap().to_string();
        let (code, text) = printed(&path, &["--select", "runtime"]);
        assert_eq!(code, Some(0), "{name} has errors");
        if name.ends_with(".fixed.glsl") {
            assert!(text.starts_with("All checks passed ("), "{name}: {text}");
            continue;
        }
        let fixed = name.replace(".glsl", ".fixed.glsl");
        assert!(folder.join(&fixed).is_file(), "{name} has no fixed twin");
        let first = text.lines().next().unwrap_or("");
        assert!(first.contains("]: "), "no finding for {name}");
        table.push_str(&format!(
            "| [{name}]({name}), [output]({name}.txt) | [{fixed}]({fixed}) | {first} |\n"
        ));
        outdated.extend(stale(&path.with_file_name(format!("{name}.txt")), &text));
    }
    outdated.extend(stale(&folder.join("README.md"), &table));
    assert!(outdated.is_empty(), "{}", outdated.join("\n\n"));
}
