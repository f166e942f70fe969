//! The scripts of the player: each is inserted into pages or modules, and each of its declarations is used
//! by what the converter writes.

use super::{files, root};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;

/// A declaration or statement at the top level of a script.
struct Item<'a> {
    file: &'a str,
    text: Vec<&'a str>,
    /// What it declares or registers; empty for other statements, which run when the script is loaded.
    names: Vec<&'a str>,
}

/// The words of a text, as names are.
fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_')
}

/// The names that the first line of an item declares, or registers in a table of parts.
fn names(line: &str) -> Vec<&str> {
    let registered = line.strip_prefix("parts.");
    if let Some(rest) = registered.or(line.strip_prefix("pageParts.")) {
        return words(rest).take(1).collect();
    }
    if let Some(rest) = line.strip_prefix("Object.assign(parts, {") {
        let pairs = rest.split(',').map(|pair| words(pair.trim()).next());
        return pairs.flatten().collect();
    }
    let line = line.strip_prefix("async ").unwrap_or(line);
    let kinds = ["function* ", "function ", "class ", "const ", "let "];
    let declared = kinds.iter().find_map(|kind| line.strip_prefix(kind));
    declared
        .into_iter()
        .flat_map(|d| words(d).take(1))
        .collect()
}

/// The items of a script, without comments.
fn items<'a>(file: &'a str, text: &'a str) -> Vec<Item<'a>> {
    let mut items: Vec<Item> = Vec::new();
    for line in text.lines() {
        let line = line.split(" // ").next().unwrap();
        if ["//", "/*", "*"]
            .iter()
            .any(|c| line.trim_start().starts_with(c))
        {
            continue;
        }
        match items.last_mut() {
            Some(item) if !line.starts_with(char::is_alphabetic) => item.text.push(line),
            _ => items.push(Item {
                file,
                text: vec![line],
                names: names(line),
            }),
        }
    }
    items.retain(|item| !item.text.concat().is_empty());
    items
}

/// What is not reached from the given names and from the statements of scripts.
fn unused(scripts: &[(String, String)], entries: &[&str]) -> Vec<String> {
    let items: Vec<Item> = scripts.iter().flat_map(|(f, t)| items(f, t)).collect();
    let mut by_name: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for (i, item) in items.iter().enumerate() {
        for name in &item.names {
            by_name.entry(name).or_default().push(i);
        }
    }
    let is_entry = |i: &Item| i.names.is_empty() || i.names.iter().any(|n| entries.contains(n));
    let mut open: Vec<usize> = (0..items.len()).filter(|i| is_entry(&items[*i])).collect();
    let mut reached: BTreeSet<usize> = open.iter().copied().collect();
    while let Some(i) = open.pop() {
        for word in items[i].text.iter().flat_map(|line| words(line)) {
            let found = by_name.get(word).into_iter().flatten();
            open.extend(found.copied().filter(|at| reached.insert(*at)));
        }
    }
    let left = items
        .iter()
        .enumerate()
        .filter(|(i, _)| !reached.contains(i));
    left.map(|(_, item)| format!("{}: {}", item.file, item.names.join(", ")))
        .collect()
}

#[test]
fn every_script_of_the_player_is_used() {
    let port: String = files(&["src/port"], ".rs")
        .into_iter()
        .map(|f| f.1.replace("\"../player/", "\"player/"))
        .collect();
    let mut scripts = files(&["src/port/player"], ".js");
    scripts.retain(|(path, _)| !path.contains("/min/") && !path.ends_with("/types.js"));
    assert!(scripts.len() > 60);
    for (path, _) in &scripts {
        let name = path.trim_start_matches("src/port/player/");
        let piece = format!("script!(\"{}\")", name.trim_end_matches(".js"));
        let files = [
            format!("\"player/{name}\""),
            format!("\"player/min/{name}\""),
        ];
        let is_inserted = port.contains(&piece) || files.iter().any(|f| port.contains(f));
        assert!(is_inserted, "{path} is not inserted into any page");
    }
    let minify = fs::read_to_string(root().join("tests/browser/minify.js")).unwrap();
    let written = minify.split("const RESERVED = [").nth(1).unwrap();
    let written = written.split(']').next().unwrap().split(", ");
    let written: Vec<&str> = written.map(|name| name.trim_matches('\'')).collect();
    assert!(written.contains(&"openPage"), "{written:?}");
    let unused = unused(&scripts, &written);
    assert!(unused.is_empty(), "not used by any page: {unused:?}");
}

#[test]
fn unused_declarations_of_scripts_are_found() {
    let script = |name: &str, text: &str| (name.to_string(), text.to_string());
    let scripts = [
        script(
            "a.js",
            "function open() {\n  parts.Used(LEFT);\n}\nfunction lost() {\n  lost();\n}\n",
        ),
        script(
            "b.js",
            "const LEFT = 1;\nclass Used {}\nparts.Used = Used;\nparts.Lost = 2;\n",
        ),
        script(
            "c.js",
            "// open, lost\nasync function later() {} // later\nopeners.video = () => LEFT;\n",
        ),
    ];
    let expected = ["a.js: lost", "b.js: Lost", "c.js: later"];
    assert_eq!(unused(&scripts, &["open"]), expected);
}
