//! Where the messages of findings are, and how they are written.

use super::files;
use shaderlint::lint::Page;
use std::collections::BTreeSet;

/// The name of the enum that lists the kinds of problems.
const KINDS: &str = "ProblemKind";

/// Each problem enum of the checker is in one file, and its messages are in the file of the same
/// name.
#[test]
fn messages_are_in_the_file_of_their_problem() {
    let sources = files(&["src"], ".rs");
    let declaring = |name: &str| {
        let head = format!("enum {name} {{");
        let mut all = sources.iter();
        all.find(|(_, text)| text.contains(&head))
    };
    let place = |file: &str| {
        let bases = [
            "src/semantic/checker/",
            "src/semantic/",
            "src/explain/messages/",
        ];
        let mut all = bases.iter().filter_map(|base| file.strip_prefix(base));
        all.next().map(str::to_string)
    };
    let (_, kinds) = declaring(KINDS).unwrap();
    let (_, kinds) = kinds.split_once("\nkinds! {\n").unwrap();
    let (kinds, _) = kinds.split_once("\n}").unwrap();
    let kinds = kinds
        .lines()
        .map(|kind| kind.split(['(', ')']).nth(1).unwrap());
    let problems: BTreeSet<&str> = kinds.chain([KINDS]).collect();
    assert!(problems.len() > 10, "{problems:?}");
    let mut explained = BTreeSet::new();
    let mut wrong = Vec::new();
    for (file, text) in &sources {
        for rest in text.split("\nimpl Explain for ").skip(1) {
            let name = rest.split_once(' ').unwrap().0;
            explained.insert(name);
            if declaring(name).is_none_or(|(rules, _)| place(rules) != place(file)) {
                wrong.push(format!("{file}: {name}"));
            }
        }
    }
    assert_eq!(explained, problems, "each problem has messages");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The page of findings in files that are not UTF-8, as pages are.
const WITHOUT: &str = "rules/errors/invalid-encoding.md";

/// Messages start in lower case and have no full stop.
#[test]
fn messages_keep_their_style() {
    let mut wrong = Vec::new();
    let mut count = 0;
    for (file, text) in files(&["rules"], ".md") {
        let page = Page::new(&text);
        let before = count;
        for fence in &page.fences {
            for line in text[fence.range.clone()].lines() {
                let heads = ["error[", "warning[", "info["];
                let Some(rest) = heads.iter().find_map(|h| line.strip_prefix(h)) else {
                    continue;
                };
                count += 1;
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
        let is_of_finding = !file.ends_with("README.md") && !file.starts_with("rules/hosts/");
        if is_of_finding && (count > before) == (file == WITHOUT) {
            wrong.push(format!("{file}: {} messages", count - before));
        }
    }
    assert!(count > 250, "{count} messages");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
