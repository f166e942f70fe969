//! What `src/text` has for all: escapers, writers of numbers and of paths are not written again.

use super::code::{tokens, without_tests};
use super::files;
use regex::Regex;
use std::collections::BTreeSet;

/// A line of code that looks like a copy: what it is, and the file that has it for all.
const SIGNS: &[(&str, &str, &str)] = &[
    (
        r#"(replace|push_str|=>|write!).*"(&|&#)(amp|lt|gt|quot|apos|39|34|60);"#,
        "an escaper",
        "src/text/markup.rs",
    ),
    (r"\\u\{\w*:04x", "an escaper", "src/text/markup.rs"),
    (
        r#"trim_end_matches\('0'\)|push_str\("\.0"\)"#,
        "a writer of numbers",
        "src/text/number.rs",
    ),
    (
        r#"\{[^{}]*\.[^{}]*\} ?%[ "]"#,
        "a writer of percentages",
        "src/text/number.rs",
    ),
    (
        r#"replace\((MAIN_SEPARATOR|'\\\\'|"\\\\"), ?('/'|"/")"#,
        "a writer of paths",
        "src/text/path.rs",
    ),
];

/// Files with a line that only looks like one. This list must only become shorter.
const ALLOWED: &[(&str, &str)] = &[
    // Markdown, in which only `<` starts an element.
    ("src/ide/hover.rs", "an escaper"),
    // JSON in ASCII, from which `escape_json` differs in what it may escape.
    ("src/text/json.rs", "an escaper"),
];

#[test]
fn escapers_and_writers_are_not_copied() {
    let signs: Vec<_> = SIGNS
        .iter()
        .map(|(pattern, what, home)| (Regex::new(pattern).unwrap(), *what, *home))
        .collect();
    let (mut met, mut wrong) = (BTreeSet::new(), Vec::new());
    for (file, text) in files(&["src", "rules"], ".rs") {
        if file.ends_with("tests.rs") || !signs.iter().any(|(sign, ..)| sign.is_match(&text)) {
            continue;
        }
        let all = tokens(&text);
        let code: BTreeSet<usize> = without_tests(&all).iter().map(|(_, line)| *line).collect();
        for (number, line) in (1..).zip(text.lines()) {
            let copy = signs.iter().find(|(sign, ..)| sign.is_match(line));
            let Some((_, what, home)) = copy.filter(|_| code.contains(&number)) else {
                continue;
            };
            let place = match ALLOWED.iter().find(|(f, w)| *f == file && w == what) {
                Some((file, what)) => (*file, *what),
                None => (*home, *what),
            };
            if place.0 == file {
                met.insert(place);
            } else {
                wrong.push(format!("{file}:{number}: {what}; {home} has one"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    // Each sign is seen where it belongs, and each exception where it is allowed.
    let homes = SIGNS.iter().map(|(_, what, home)| (*home, *what));
    for place in homes.chain(ALLOWED.iter().copied()) {
        assert!(met.contains(&place), "{place:?} is no longer met");
    }
}
