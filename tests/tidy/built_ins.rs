//! Code identifies a built-in function by its row in the table and its id, never by its name or a
//! part of its name.

use super::code::{Token, tokens, without_tests};
use super::{crates, files};
use shaderlint::semantic::BuiltinId;
use std::collections::BTreeSet;

/// The layers that know no functions.
const BELOW: &[&str] = &[
    "src/detect",
    "src/diagnostic",
    "src/format",
    "src/host",
    "src/math",
    "src/syntax",
    "src/text",
];

/// Folders where the same words are wrap modes, kinds of inputs, or functions of other languages.
const HOMONYMS: &[&str] = &[
    "src/cli/",
    "src/contract/",
    "src/play/",
    "src/port/",
    "src/project/",
    "src/reflect/",
    "src/script/",
];

/// Words that mean something else, by file. This list must only become shorter.
const ALLOWED: &[(&str, &[&str])] = &[
    ("src/commands/run/loops.rs", &["max"]),
    ("src/commands/run/trace.rs", &["step"]),
    ("src/dap/adapter/motion.rs", &["step"]),
    // The group of all rules.
    ("src/engine/config/read/schema.rs", &["all"]),
    ("src/lint/rule.rs", &["all"]),
    ("src/engine/options.rs", &["any"]),
    // The method of arrays.
    ("src/ide/complete/expected.rs", &["length"]),
    ("src/semantic/typing/member.rs", &["length"]),
    // What a text has to contain for a closer look.
    ("src/semantic/dialect.rs", &["texture"]),
    // `#pragma STDGL invariant(all)`.
    ("src/explain/upgrade/edits.rs", &["all"]),
];

#[test]
fn built_ins_are_not_identified_by_name() {
    let layers = crates();
    for below in BELOW {
        assert!(
            layers.iter().any(|layer| layer == below),
            "{below} is no layer"
        );
    }
    let is_out = |file: &str| {
        let is_below = BELOW.iter().any(|below| file.starts_with(below));
        // The tables of all functions, and of the old ones with their replacements.
        let is_table = ["table.rs", "mod.rs"].map(|name| format!("src/semantic/builtins/{name}"));
        let is_table = is_table.iter().any(|table| table == file) || file.ends_with("tests.rs");
        let is_homonym = HOMONYMS.iter().any(|folder| file.starts_with(folder));
        is_below || is_table || is_homonym && !file.contains("/naga/")
    };
    let (mut met, mut wrong) = (BTreeSet::new(), Vec::new());
    let mut count = 0;
    for (file, text) in files(&["src", "rules"], ".rs") {
        if is_out(&file) {
            continue;
        }
        let all = tokens(&text);
        let kept = without_tests(&all);
        count += kept.len();
        for (line, word) in built_ins(&kept) {
            let allowed = ALLOWED
                .iter()
                .find(|(f, words)| *f == file && words.contains(&word));
            match allowed {
                Some((file, _)) => drop(met.insert((*file, word.to_string()))),
                None => wrong.push(format!("{file}:{line}: {word}")),
            }
        }
    }
    assert!(count > 500_000, "{count} tokens");
    for (file, words) in ALLOWED {
        let left = words
            .iter()
            .filter(|word| !met.contains(&(*file, word.to_string())));
        wrong.extend(left.map(|word| format!("{file} no longer names {word}; remove it")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The texts that are the name of a built-in function, or that code searches for in a name and are
/// a part of one.
fn built_ins<'a>(tokens: &[(Token<'a>, usize)]) -> Vec<(usize, &'a str)> {
    let mut found = Vec::new();
    for (at, (token, line)) in tokens.iter().enumerate() {
        let Token::Text(word) = token else { continue };
        let before = at.checked_sub(2).map(|at| tokens[at].0);
        let is_part = matches!(
            before,
            Some(Token::Name(
                "starts_with" | "ends_with" | "strip_prefix" | "strip_suffix" | "contains"
            ))
        );
        let is_word = word.len() > 2 && word.chars().all(char::is_alphanumeric);
        let is_named = |id: &BuiltinId| match is_part && is_word {
            true => id.name().contains(word),
            false => id.name() == *word,
        };
        if BuiltinId::ALL.iter().any(is_named) {
            found.push((*line, *word));
        }
    }
    found
}
