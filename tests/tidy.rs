//! The order of the house: layers, pairs, pages, sizes, words.

use shaderlint::diagnostic::ERRORS;
use shaderlint::lint::Page;
use shaderlint::rules::RULES;
use shaderlint::semantic::BuiltinId;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// What each layer may name, besides itself.
const LAYERS: [(&str, &[&str]); 13] = [
    ("text", &[]),
    ("host", &[]),
    ("diagnostic", &["text"]),
    ("syntax", &["text", "diagnostic"]),
    ("semantic", &["text", "diagnostic", "syntax"]),
    ("ir", &["text", "diagnostic", "syntax", "semantic"]),
    ("flow", &["text", "diagnostic", "syntax", "semantic", "ir"]),
    (
        "lint",
        &["text", "diagnostic", "syntax", "semantic", "ir", "flow"],
    ),
    (
        "rules",
        &[
            "text",
            "diagnostic",
            "syntax",
            "semantic",
            "ir",
            "flow",
            "lint",
        ],
    ),
    (
        "port",
        &["text", "diagnostic", "syntax", "semantic", "ir", "flow"],
    ),
    ("report", &["text", "diagnostic"]),
    (
        "engine",
        &[
            "text",
            "host",
            "diagnostic",
            "syntax",
            "semantic",
            "ir",
            "flow",
            "lint",
            "rules",
            "port",
        ],
    ),
    (
        "cli",
        &[
            "engine",
            "text",
            "host",
            "diagnostic",
            "syntax",
            "semantic",
            "ir",
            "flow",
            "lint",
            "rules",
            "port",
            "report",
        ],
    ),
];

/// Longest file, in lines.
const MAX_FILE: usize = 800;
/// Longest function, in lines.
const MAX_FUNCTION: usize = 80;

fn root() -> PathBuf {
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

/// Paths from the top of the repository, with contents.
fn files(folders: &[&str], ending: &str) -> Vec<(String, String)> {
    let mut paths = Vec::new();
    for folder in folders {
        walk(&root().join(folder), &mut paths);
    }
    paths.sort();
    paths
        .into_iter()
        .filter(|p| p.to_str().is_some_and(|p| p.ends_with(ending)))
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

fn layer_of(file: &str) -> Option<&'static (&'static str, &'static [&'static str])> {
    let folder = match file.strip_prefix("src/") {
        Some(rest) => rest.split('/').next()?,
        None => file.split('/').next()?,
    };
    LAYERS.iter().find(|(name, _)| *name == folder)
}

#[test]
fn layers_name_only_what_lies_below() {
    let mut wrong = Vec::new();
    for (file, text) in files(&["src", "rules"], ".rs") {
        let Some((layer, below)) = layer_of(&file) else {
            continue;
        };
        // Tests may look further.
        let code = text.split("#[cfg(test)]").next().unwrap();
        for part in code.split("crate::").skip(1) {
            let end = part
                .find(|c: char| !c.is_ascii_alphanumeric() && c != '_')
                .unwrap_or(part.len());
            let named = &part[..end];
            if LAYERS.iter().any(|(l, _)| *l == named) && named != *layer && !below.contains(&named)
            {
                wrong.push(format!("{file} names {named}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn no_rule_names_another() {
    for (file, text) in files(&["rules"], ".rs") {
        let is_list = file == "rules/mod.rs";
        assert!(is_list || !text.contains("crate::rules"), "{file}");
    }
}

#[test]
fn every_rule_is_a_pair() {
    let names = |ending: &str| -> BTreeSet<String> {
        let all = fs::read_dir(root().join("rules"))
            .unwrap()
            .map(|e| e.unwrap().path());
        all.filter(|p| p.extension().is_some_and(|e| e == ending))
            .map(|p| p.file_stem().unwrap().to_str().unwrap().replace('_', "-"))
            .filter(|n| n != "mod" && n != "README")
            .collect()
    };
    let rules: BTreeSet<String> = RULES.iter().map(|r| r.name.to_string()).collect();
    assert_eq!(names("rs"), rules);
    assert_eq!(names("md"), rules);
    let sorted: Vec<&str> = rules.iter().map(String::as_str).collect();
    assert_eq!(
        RULES.iter().map(|r| r.name).collect::<Vec<_>>(),
        sorted,
        "the rules stand by name"
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
}

#[test]
fn modules_say_what_they_are_and_stay_small() {
    let mut wrong = Vec::new();
    for (file, text) in files(&["src", "rules", "tests"], ".rs") {
        if !text.starts_with("//! ") {
            wrong.push(format!("{file} does not start with `//!`"));
        }
        if text.lines().count() > MAX_FILE {
            wrong.push(format!("{file} has {} lines", text.lines().count()));
        }
    }
    for (file, text) in files(&["src"], ".js") {
        if !text.starts_with("// ") {
            wrong.push(format!("{file} does not start with a comment"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn functions_fit_a_screen() {
    let mut wrong = Vec::new();
    for (file, text) in files(&["src", "rules"], ".rs") {
        let mut open: Option<(usize, String, String)> = None;
        for (number, line) in text.lines().enumerate() {
            let indent: String = line.chars().take_while(|c| *c == ' ').collect();
            let is_function = line.contains("fn ") && line.trim_end().ends_with('{');
            if open.is_none() && is_function && !line.trim_start().starts_with("//") {
                open = Some((number, indent, line.trim().to_string()));
            } else if let Some((start, own, name)) = &open
                && line == format!("{own}}}")
            {
                if number - start > MAX_FUNCTION {
                    wrong.push(format!("{file}: {} lines: {name}", number - start));
                }
                open = None;
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// What a built-in function does is told by its row in the table and by its number, never by its name
/// or how the name begins.
#[test]
fn no_built_in_is_told_by_its_name() {
    // Below these layers nothing knows of functions; `port` speaks of textures and how they wrap.
    let folders = ["src/semantic", "src/lint", "rules", "src/port/naga"];
    let later = ["src/ir", "src/flow", "src/exec"];
    let later = later.iter().filter(|f| root().join(f).exists());
    let folders: Vec<&str> = folders.iter().chain(later).copied().collect();
    let mut wrong = Vec::new();
    for (file, text) in files(&folders, ".rs") {
        if file == "src/semantic/builtins/table.rs" {
            continue;
        }
        let code = text.split("#[cfg(test)]").next().unwrap();
        for (number, line) in code.lines().enumerate() {
            if compares_a_built_in(line) {
                wrong.push(format!("{file}:{}: {}", number + 1, line.trim()));
            }
        }
    }
    // What selects all rules.
    wrong.retain(|w| !w.contains("\"all\" => Some(Reach::All)"));
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Whether the name of a built-in function, or the beginning of one, stands on a line where it is
/// compared with something: beside `==`, in a pattern, or as what a text starts with or holds.
fn compares_a_built_in(line: &str) -> bool {
    let parts: Vec<&str> = line.split('"').collect();
    (1..parts.len()).step_by(2).any(|i| {
        let (before, word) = (parts[..i].join("\"").trim_end().to_string(), parts[i]);
        let after = parts[i + 1..].join("\"").trim_start().to_string();
        let is_word = !word.is_empty() && word.chars().all(char::is_alphanumeric);
        let is_part = ["starts_with(", "ends_with(", "strip_prefix(", "contains("]
            .iter()
            .any(|p| before.ends_with(p));
        let begins = |id: &BuiltinId| match is_part {
            true => word.len() > 2 && id.name().contains(word),
            false => id.name() == word,
        };
        let is_compared = ["==", "!=", "|"]
            .iter()
            .any(|op| before.ends_with(op) || after.starts_with(op))
            || after.contains("=>")
            || before.contains("matches!")
            || before.ends_with("contains(&")
            || before
                .rsplit("let ")
                .next()
                .is_some_and(|rest| rest.len() < before.len() && !rest.contains('='));
        is_word && (is_part || is_compared) && BuiltinId::ALL.iter().any(begins)
    })
}

/// Messages are lower case and without a full stop, as every page prints them.
#[test]
fn messages_keep_their_style() {
    let mut wrong = Vec::new();
    for (file, text) in files(&["rules"], ".md") {
        let page = Page::new(&text);
        for fence in &page.fences {
            for line in text[fence.range.clone()].lines() {
                let heads = ["error[", "warning[", "note["];
                let Some(rest) = heads.iter().find_map(|h| line.strip_prefix(h)) else {
                    continue;
                };
                let message = rest.split_once("]: ").map_or("", |(_, m)| m);
                let first = message.chars().next().unwrap_or(' ');
                let is_word = |w: &str| message.starts_with(w);
                let is_name = ["GLSL", "WebGL", "ShaderToy", "NUL"]
                    .iter()
                    .any(|w| is_word(w));
                if (first.is_uppercase() && !is_name)
                    || message.ends_with('.')
                    || message.is_empty()
                {
                    wrong.push(format!("{file}: {message}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
