//! Sizes: of files, functions, folders and of the whole.

use super::code::{Token, end_of_item, tokens};
use super::{files, root, walk};
use std::collections::BTreeMap;
use std::fs;
use std::io::{Write, stdout};

/// Maximum length of a file, in lines.
const MAX_FILE: usize = 800;
/// Maximum length of a function, in lines, with its signature and its closing brace.
const MAX_FUNCTION: usize = 80;
/// Most files in a folder of `src`, without those in folders in it.
const MAX_FOLDER: usize = 25;
/// Most lines of Rust in `src` and `rules`, as `wc -l` counts them.
const MAX_LINES: usize = 195_600;

#[test]
fn modules_are_documented_and_stay_small() {
    let mut wrong = Vec::new();
    for (file, text) in files(&["src", "rules", "tests"], ".rs") {
        if !text.starts_with("//! ") {
            wrong.push(format!("{file} does not start with `//!`"));
        }
        if text.lines().count() > MAX_FILE {
            wrong.push(format!("{file} has {} lines", text.lines().count()));
        }
    }
    let scripts = [
        "src",
        "site/.vitepress/markdown",
        "site/.vitepress/theme",
        "tests/site",
    ];
    for (file, text) in files(&scripts, ".js") {
        // Generated files have no comments.
        if !file.contains("/min/") && !text.starts_with("// ") {
            wrong.push(format!("{file} does not start with a comment"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Adds the functions of a Rust file that are too long, with their first lines.
fn long_functions(file: &str, text: &str, long: &mut Vec<String>) -> usize {
    let tokens = tokens(text);
    let mut count = 0;
    for (at, pair) in tokens.windows(2).enumerate() {
        let [(Token::Name("fn"), first), (Token::Name(name), _)] = pair else {
            continue;
        };
        let last = tokens[end_of_item(&tokens, at) - 1].1;
        count += 1;
        report(file, name, *first, last, long);
    }
    count
}

/// Adds a function from one line to another if it is too long.
fn report(file: &str, name: &str, first: usize, last: usize, long: &mut Vec<String>) {
    let lines = last + 1 - first;
    if lines > MAX_FUNCTION {
        long.push(format!("{file}:{first}: {name} has {lines} lines"));
    }
}

/// Adds the functions of a Python file that are too long: each ends before the next line that is
/// not indented more, except those of brackets and texts.
fn long_python_functions(file: &str, text: &str, long: &mut Vec<String>) -> usize {
    let mut open: Vec<(usize, String, usize, usize)> = Vec::new();
    let mut count = 0;
    let mut is_text = false;
    for (number, line) in (1..).zip(text.lines()) {
        let code = line.trim_start();
        let indent = line.len() - code.len();
        let is_inside = is_text || code.is_empty() || code.starts_with([')', ']', '}']);
        is_text ^= line.matches("\"\"\"").count() % 2 == 1;
        while !is_inside && let Some(function) = open.pop_if(|function| function.0 >= indent) {
            report(file, &function.1, function.2, function.3, long);
        }
        let declared = code.strip_prefix("async ").unwrap_or(code);
        if let Some(name) = declared.strip_prefix("def ").filter(|_| !is_inside) {
            let name = name.split('(').next().unwrap_or(name).to_string();
            open.push((indent, name, number, number));
            count += 1;
        }
        for function in open.iter_mut().filter(|_| !code.is_empty()) {
            function.3 = number;
        }
    }
    for (_, name, first, last) in open {
        report(file, &name, first, last, long);
    }
    count
}

/// The Python files in these folders: many scripts have no extension.
fn python_files(folders: &[&str]) -> Vec<(String, String)> {
    let mut paths = Vec::new();
    for folder in folders {
        walk(&root().join(folder), &mut paths);
    }
    let is_script = |text: &str| {
        let first = text.lines().next().unwrap_or("");
        first.starts_with("#!") && first.ends_with("python3")
    };
    let read = paths.into_iter().filter_map(|path| {
        let text = String::from_utf8(fs::read(&path).unwrap()).ok()?;
        let name = path.strip_prefix(root()).unwrap().display().to_string();
        (name.ends_with(".py") || is_script(&text)).then_some((name, text))
    });
    read.collect()
}

#[test]
fn functions_fit_a_screen() {
    let mut wrong = Vec::new();
    let mut count = 0;
    for (file, text) in files(&["src", "rules", "tests", "fuzz", "benches"], ".rs") {
        count += long_functions(&file, &text, &mut wrong);
    }
    assert!(count > 9_000, "{count} functions in Rust");
    count = 0;
    for (file, text) in python_files(&["tests", "benches", "packaging", "rules", "site"]) {
        count += long_python_functions(&file, &text, &mut wrong);
    }
    assert!(count > 400, "{count} functions in Python");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn folders_of_src_have_at_most_25_files() {
    let mut paths = Vec::new();
    walk(&root().join("src"), &mut paths);
    let mut counts: BTreeMap<_, usize> = BTreeMap::new();
    for folder in paths.iter().filter_map(|path| path.parent()) {
        *counts.entry(folder).or_default() += 1;
    }
    assert!(counts.len() > 50, "{} folders", counts.len());
    counts.retain(|_, count| *count > MAX_FOLDER);
    assert!(counts.is_empty(), "too many files in a folder: {counts:?}");
}

/// It prints the number whether or not the output of tests is shown, for `tests/run`.
#[test]
fn src_and_rules_have_at_most_195_600_lines_of_rust() {
    let texts = files(&["src", "rules"], ".rs");
    let count: usize = texts
        .iter()
        .map(|(_, text)| text.matches('\n').count())
        .sum();
    let line = format!("\nlines of Rust in src and rules: {count}\n");
    stdout().write_all(line.as_bytes()).unwrap();
    assert!(count <= MAX_LINES, "{count} of at most {MAX_LINES} lines");
}
