//! Each name has a single meaning: types, and the names of hosts.

use super::code::{Token, tokens, without_tests};
use super::{files, root};
use std::collections::{BTreeMap, BTreeSet};

/// Type names that are declared more than once, and how often. This list must only become shorter,
/// and its numbers smaller.
const SHARED: &[(&str, usize)] = &[
    ("Bound", 2),
    ("Function", 2),
    ("Spot", 2),
    ("Value", 3),
    ("Variable", 2),
];

/// The types that a text declares, public or private.
fn types(text: &str) -> Vec<&str> {
    let all = tokens(text);
    let tokens = without_tests(&all);
    let mut depth = 0_usize;
    let mut found = Vec::new();
    for pair in tokens.windows(2) {
        match [pair[0].0, pair[1].0] {
            [Token::Mark('{'), _] => depth += 1,
            [Token::Mark('}'), _] => depth -= 1,
            [
                Token::Name("struct" | "enum" | "trait" | "union"),
                Token::Name(name),
            ] => {
                found.push(name);
            }
            // Inside an impl it is an associated type.
            [Token::Name("type"), Token::Name(name)] if depth == 0 => found.push(name),
            _ => {}
        }
    }
    found
}

/// A type name identifies a single type.
#[test]
fn type_names_are_unique() {
    let mut places: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for (file, text) in files(&["src", "rules"], ".rs") {
        for name in types(&text) {
            let place = places.entry(name.to_string()).or_default();
            place.push(file.clone());
        }
    }
    assert!(places.len() > 800, "{}", places.len());
    let shared: BTreeMap<&str, usize> = SHARED.iter().copied().collect();
    assert!(SHARED.is_sorted() && shared.len() == SHARED.len());
    let mut wrong = Vec::new();
    for (name, files) in &places {
        let most = shared.get(name.as_str()).copied().unwrap_or(1);
        if files.len() > most {
            wrong.push(format!("{name} is already used: {}", files.join(" ")));
        }
    }
    for (name, listed) in SHARED {
        let count = places.get(*name).map_or(0, Vec::len);
        if count < *listed {
            wrong.push(format!(
                "{name} is listed with {listed} declarations but has {count}"
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_kind_of_type_declaration_is_found() {
    let text = "pub(crate) struct A;\nenum B<'a> { C(&'a str) }\nfn f() { struct D; }\n\
        impl E for A { type Output = u8; }\ntype F = u8; // struct G;\n#[cfg(test)]\nmod tests { struct H; }";
    assert_eq!(types(text), ["A", "B", "D", "F"]);
}

/// Files and folders that still identify hosts by name. This list must only become shorter.
const NAME_HOSTS: &[&str] = &[
    "src/project/files/scan.rs",
    "src/project/include/find.rs",
    "src/project/include/mod.rs",
    "src/project/dialect/",
    // The name of a canvas context is also the name of a host.
    "src/detect/embed/context.rs",
    "src/detect/embed/webgl.rs",
    "src/contract/targets.rs",
    "src/engine/options.rs",
    "src/detect/embed/markdown.rs",
    "src/detect/kind/mod.rs",
];

/// Hosts are identified by the host table, not by a name in the code.
#[test]
fn hosts_are_not_identified_by_name() {
    let hosts = files(&["src/host"], ".glsl").into_iter();
    let stem = |file: String| {
        let name = file.rsplit('/').next().unwrap().to_string();
        name.trim_end_matches(".glsl").to_string()
    };
    let mut names: BTreeSet<String> = hosts.map(|(file, _)| stem(file)).collect();
    assert!(names.len() > 25 && names.contains("shadertoy") && names.contains("three"));
    names.extend(["bonzomatic", "glsl-sandbox", "isf", "kodelife", "twigl"].map(str::to_string));
    let mut met = BTreeSet::new();
    let mut wrong = Vec::new();
    for (file, text) in files(&["src"], ".rs") {
        if file.starts_with("src/host/") {
            continue;
        }
        for (token, line) in without_tests(&tokens(&text)) {
            let Token::Text(name) = token else { continue };
            if !names.contains(name) {
                continue;
            }
            match NAME_HOSTS.iter().find(|place| file.starts_with(**place)) {
                Some(place) => drop(met.insert(*place)),
                None => wrong.push(format!("{file}:{line}: {name}")),
            }
        }
    }
    for place in NAME_HOSTS.iter().filter(|place| !met.contains(*place)) {
        wrong.push(format!(
            "{place} no longer identifies a host by name; remove it"
        ));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(root().join("src/host/presets").exists());
}
