//! Rules for the code base: layers, cycles, pairs, pages, sizes, names, messages.

mod circles;
pub mod code;
mod names;
mod scripts;

use code::{Token, tokens, without_tests};
use shaderlint::diagnostic::ERRORS;
use shaderlint::lint::Page;
use shaderlint::rules::{RULES, error_page};
use shaderlint::semantic::BuiltinId;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Maximum length of a file, in lines.
const MAX_FILE: usize = 800;
/// Maximum length of a function, in lines.
const MAX_FUNCTION: usize = 80;

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

/// Functions that are too long, with their signatures.
fn long_functions(text: &str) -> Vec<String> {
    let mut long = Vec::new();
    let mut open: Option<(usize, String, String)> = None;
    for (number, line) in text.lines().enumerate() {
        let indent: String = line.chars().take_while(|c| *c == ' ').collect();
        let is_function = line.contains("fn ") && !line.trim_start().starts_with("//");
        if let Some((start, own, name)) = &open {
            let is_prototype = line.starts_with(&format!("{own})")) && line.ends_with(';');
            if line == format!("{own}}}") || is_prototype {
                if number - start > MAX_FUNCTION {
                    long.push(format!("{} lines: {name}", number - start));
                }
                open = None;
            }
        } else if is_function && line.ends_with(['{', '(', '<']) {
            open = Some((number, indent, line.trim().to_string()));
        }
    }
    long
}

#[test]
fn functions_fit_a_screen() {
    let mut wrong = Vec::new();
    for (file, text) in files(&["src", "rules"], ".rs") {
        let long = long_functions(&text);
        wrong.extend(long.iter().map(|name| format!("{file}: {name}")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let body = "    a();\n".repeat(MAX_FUNCTION);
    let wrapped = format!("fn f(\n    a: u32,\n) -> u32\nwhere\n    u32: Copy,\n{{\n{body}}}\n");
    assert_eq!(long_functions(&wrapped).len(), 1);
}

/// Code identifies a built-in function by its row in the table and its id, never by its name or a
/// prefix of its name.
#[test]
fn built_ins_are_not_identified_by_name() {
    // The layers below do not know functions; `port` uses names of textures and wrap modes.
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
    // The name of the group with all rules.
    wrong.retain(|w| !w.contains("\"all\" => Some(Reach::All)"));
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Whether a line compares something with the name of a built-in function or a part of one: with
/// `==`, in a pattern, or in `starts_with`, `contains` and the like.
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

/// Each problem enum of the checker is in one file, and its messages are in the file of the same
/// name.
#[test]
fn messages_are_in_the_file_of_their_problem() {
    let mut wrong = Vec::new();
    for (file, text) in files(&["src/semantic/explain"], ".rs") {
        for rest in text.split("\nimpl Explain for ").skip(1) {
            let name = rest.split_once(' ').unwrap().0;
            let rules = root().join(file.replace("/explain/", "/checker/"));
            let rules = fs::read_to_string(rules).unwrap_or_default();
            if !rules.contains(&format!("enum {name} {{")) {
                wrong.push(format!("{file}: {name}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Messages start in lower case and have no full stop.
#[test]
fn messages_keep_their_style() {
    let mut wrong = Vec::new();
    for (file, text) in files(&["rules"], ".md") {
        let page = Page::new(&text);
        for fence in &page.fences {
            for line in text[fence.range.clone()].lines() {
                let heads = ["error[", "warning[", "info["];
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

/// `rules/new`, used as described in CONTRIBUTING.md.
#[cfg(unix)]
#[test]
fn rules_new_creates_a_sorted_rule_and_page() {
    let folder = tempfile::tempdir().unwrap();
    for file in ["rules/new", "rules/lib.rs", "src/lint/rule.rs"] {
        let to = folder.path().join(file);
        fs::create_dir_all(to.parent().unwrap()).unwrap();
        fs::copy(root().join(file), to).unwrap();
    }
    let new = |args: &[&str]| {
        let mut command = std::process::Command::new(folder.path().join("rules/new"));
        command.args(args).output().unwrap().status.success()
    };
    assert!(new(&["even-odds", "numeric"]));
    assert!(!new(&["even-odds"]), "the rule exists already");
    assert!(
        !new(&["other-odds", "groupless"]),
        "the group does not exist"
    );
    let read = |file: &str| fs::read_to_string(folder.path().join("rules").join(file)).unwrap();
    assert!(read("even_odds.rs").contains("group: Group::Numeric,"));
    assert!(Page::new(&read("even_odds.md")).name == "even-odds");
    let list = read("lib.rs");
    for (before, after) in [("    &", "::RULE,"), ("mod ", ";")] {
        let names = list
            .lines()
            .filter_map(|l| l.strip_prefix(before)?.strip_suffix(after));
        let names: Vec<&str> = names.collect();
        assert!(
            names.is_sorted() && names.contains(&"even_odds"),
            "{names:?}"
        );
    }
}
