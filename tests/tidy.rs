//! Rules for the code base: layers, cycles, pairs, pages, sizes, names, messages.

mod built_ins;
mod circles;
pub mod code;
mod copies;
mod messages;
mod names;
mod scripts;
mod sizes;

use super::scratch::Scratch;
use code::{Token, tokens, without_tests};
use shaderlint::diagnostic::ERRORS;
use shaderlint::lint::Page;
use shaderlint::rules::{RULES, error_page};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn walk(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            if path.file_name().is_some_and(|n| n != "node_modules") {
                walk(&path, found);
            }
        } else {
            found.push(path);
        }
    }
}

/// Files with this extension: paths relative to the repository, and contents.
pub fn files(folders: &[&str], extension: &str) -> Vec<(String, String)> {
    let mut paths = Vec::new();
    for folder in folders {
        walk(&root().join(folder), &mut paths);
    }
    paths.sort();
    paths
        .into_iter()
        .filter(|p| p.to_str().is_some_and(|p| p.ends_with(extension)))
        .map(|p| {
            let name = p
                .strip_prefix(root())
                .unwrap()
                .to_str()
                .unwrap()
                .to_string();
            (name, fs::read_to_string(&p).unwrap())
        })
        .collect()
}

/// The source folders of all crates; `src` contains the programs and all layers.
fn crates() -> Vec<String> {
    let manifest = fs::read_to_string(root().join("Cargo.toml")).unwrap();
    let members = manifest.split_once("members = [").unwrap().1;
    let members = members.split_once(']').unwrap().0.lines();
    let members = members.filter_map(|l| l.trim().strip_prefix('"')?.strip_suffix("\","));
    let with_root = |folder: &str| match root().join(folder).join("src").exists() {
        true => format!("{folder}/src"),
        false => folder.to_string(),
    };
    members.chain(["src"]).map(with_root).collect()
}

#[test]
fn rules_do_not_depend_on_each_other() {
    for (file, text) in files(&["rules"], ".rs") {
        let tokens = without_tests(&tokens(&text));
        let names_another = tokens.windows(2).any(|pair| {
            let [(first, _), (second, _)] = pair else {
                return false;
            };
            matches!(first, Token::Name("crate" | "super")) && *second == Token::Path
        });
        assert!(!names_another, "{file}");
    }
}

#[test]
fn every_rule_has_code_and_a_page() {
    let names = |extension: &str| -> BTreeSet<String> {
        let all = fs::read_dir(root().join("rules"))
            .unwrap()
            .map(|e| e.unwrap().path());
        all.filter(|p| p.extension().is_some_and(|e| e == extension))
            .map(|p| p.file_stem().unwrap().to_str().unwrap().replace('_', "-"))
            .filter(|n| n != "lib" && n != "errors" && n != "README")
            .collect()
    };
    let rules: BTreeSet<String> = RULES.iter().map(|r| r.name.to_string()).collect();
    assert_eq!(names("rs"), rules);
    assert_eq!(names("md"), rules);
    let sorted: Vec<&str> = rules.iter().map(String::as_str).collect();
    assert_eq!(
        RULES.iter().map(|r| r.name).collect::<Vec<_>>(),
        sorted,
        "the rules are sorted by name"
    );
}

#[test]
fn every_error_has_a_page() {
    let pages: BTreeSet<String> = fs::read_dir(root().join("rules/errors"))
        .unwrap()
        .map(|e| {
            e.unwrap()
                .path()
                .file_stem()
                .unwrap()
                .to_str()
                .unwrap()
                .to_string()
        })
        .collect();
    let errors: BTreeSet<String> = ERRORS.iter().map(|e| e.to_string()).collect();
    assert_eq!(pages, errors);
    for name in ERRORS {
        let page = fs::read_to_string(root().join(format!("rules/errors/{name}.md")));
        assert_eq!(error_page(name), page.ok().as_deref(), "{name}");
    }
}

/// `rules/new`, used as described in CONTRIBUTING.md.
#[cfg(unix)]
#[test]
fn rules_new_creates_a_sorted_rule_and_page() {
    let folder = Scratch::new(&[]);
    for file in ["rules/new", "rules/lib.rs", "src/lint/rule.rs"] {
        let to = folder.path(file);
        fs::create_dir_all(to.parent().unwrap()).unwrap();
        fs::copy(root().join(file), to).unwrap();
    }
    let new = |args: &[&str]| {
        let mut command = std::process::Command::new(folder.path("rules/new"));
        command.args(args).output().unwrap().status.success()
    };
    assert!(new(&["even-odds", "numeric"]));
    assert!(!new(&["even-odds"]), "the rule exists already");
    assert!(
        !new(&["other-odds", "groupless"]),
        "the group does not exist"
    );
    let read = |file: &str| folder.read(&format!("rules/{file}"));
    assert!(read("even_odds.rs").contains("rule! { even_odds, Numeric, "));
    assert!(Page::new(&read("even_odds.md")).name == "even-odds");
    let list = read("lib.rs");
    let words = list.split_once("\nrules! {").unwrap().1.split('}').next();
    let modules = list
        .lines()
        .filter_map(|l| l.strip_prefix("mod ")?.strip_suffix(';'));
    for names in [
        words.unwrap().split_whitespace().collect(),
        modules.collect::<Vec<&str>>(),
    ] {
        assert!(
            names.is_sorted() && names.contains(&"even_odds"),
            "{names:?}"
        );
    }
}
