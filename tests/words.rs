//! How the product speaks: plain technical English in every text that a person reads. Each refused
//! word has the term of the field that replaces it.

mod test_names;

use super::tidy::code::{Token, tokens, without_tests};
use super::tidy::{files, root};
use regex::{Regex, RegexBuilder};
use std::fs;

/// Longest title of a finding, in characters: one line of a list of problems.
const MOST_TITLE: usize = 72;
/// Longest sentence of a label, note or help, in words.
const MOST_SENTENCE: usize = 30;

/// Refused in texts, and what to write. The patterns are regular expressions between word boundaries.
const TEXTS: &[(&str, &str)] = &[
    (
        r"(each|every|one|first|last|a|per|of|the|many|more|\d+) turns?",
        "iteration",
    ),
    (r"(loops?|it) turns", "runs, repeats"),
    (r"pictures?", "image, frame, output"),
    (
        r"told|tells? (of|that|what|how|which|by|whether)|is said|said (of|to)",
        "reported, shown, listed",
    ),
    (r"mend(s|ed|ing)?", "fix, repair"),
    (r"hangs? on", "depends on"),
    (r"(stand|stands|stood|standing)", "is, is declared, appears"),
    (
        r"(stands|text|line|file|name|comment|`[^`]*`) behind",
        "after",
    ),
    (
        r"ending of|its ending|the ending|file endings?",
        "extension",
    ),
    (
        r"words? of (HLSL|Metal|WGSL|C|other languages)",
        "HLSL type, HLSL function, keyword",
    ),
    (r"by (itself|themselves)", "implicitly"),
    (r"wants?", "expects, needs"),
    (
        r"takes (no|only|an?|one|two|three|\d+) (arguments?|index|constant|number|value|parameter)",
        "expects, accepts",
    ),
    (
        r"leaves? (something |it )?open",
        "cannot be resolved, was not checked",
    ),
    (r"middle form", "IR"),
    (r"register code", "bytecode"),
    (
        r"part(s|ed|ing)? (some )?pixels|pixels part|leave apart",
        "diverge",
    ),
    (r"personas?", "GPU profile"),
    (r"blessed", "golden image"),
    (
        r"whole (number|numbers|shader|shaders|text|texts)",
        "integer; complete shader",
    ),
    (
        r"(a|the|square) roots? (of|and|in|a) (a )?(negative|number|sine)",
        "square root",
    ),
    (
        r"(is|are|was|were|be) looked at|looks? at",
        "checks, analyses",
    ),
    (r"in the mean", "on average"),
    (r"the site('s)?", "ShaderToy"),
    (r"needless(ly)?", "unnecessary, redundant"),
    (
        r"nothing declares|nobody knows|nobody sets",
        "is not declared, is unknown",
    ),
    (
        r"(do|does) not go together|do not mix",
        "cannot multiply A by B",
    ),
    (r"(cannot|can not) become", "cannot assign A to B"),
    (r"(is|are) gone since", "was removed in"),
    (r"(`|this|it|that) is no [a-z]+", "is not a"),
    (
        r"what was read|known of|said of|can come to be|at hand",
        "name the cause",
    ),
    (r"beholders?|thereof|wherein|whereby|therein", "shorter"),
];

/// Refused in the names that the code declares, and what to write. Each is one word of a name.
const NAMES: &[(&str, &str)] = &[
    ("turn turns", "iteration, rotation"),
    ("picture pictures", "image, frame"),
    ("told tell tells said say says", "reported, message, output"),
    ("mend mends mended", "fix, repair"),
    ("ending endings", "extension"),
    ("parting", "divergence"),
    ("persona personas", "GPU profile"),
    ("blessed", "golden image"),
    ("settle settled settles", "resolve, infer"),
    ("doubt doubts doubtful", "candidate"),
    ("blame slip slips", "root cause, typo"),
    ("trial trials tried", "candidate, sample run"),
    ("needless", "redundant"),
    ("misspelt", "misspelled"),
    ("stands stood", "is, is declared"),
    ("wants wanted", "expects, expected"),
    ("gone", "removed"),
];

/// Names with a refused word: those of rules, which users have in their configurations, and what
/// other programs have named.
const ALLOWED_NAMES: &[&str] = &[
    "gpu_dependent_picture",
    "gray_picture",
    "needless_bool",
    "single_turn_loop",
    "static_picture",
    // The client's setting `shaderlint.pictures`.
    "pictures",
];

/// Phrases with a refused word that mean something else.
const ALLOWED: &[&str] = &[
    // Names.
    "gpu-dependent-picture",
    "gpu_dependent_picture",
    "gray-picture",
    "gray_picture",
    "needless-bool",
    "needless_bool",
    "static-picture",
    "static_picture",
    "contain `picture`",
    "`pictures`",
    "shaderlint.pictures",
    // A replacement for a missing file.
    "stand-in",
    "stands for",
    "stand for",
    "the site or library",
    "the base by itself",
    "you do not want",
    "it turns off",
    "it turns on",
    "is no longer",
    "is no more than",
    "is no greater",
    "is no less",
];

fn refused(table: &[(&str, &'static str)]) -> Vec<(Regex, &'static str)> {
    let build = |(pattern, instead): &(&str, &'static str)| {
        let pattern = format!(r"\b(?:{pattern})(?:\b|$|\W)");
        let regex = RegexBuilder::new(&pattern).case_insensitive(true).build();
        (regex.unwrap(), *instead)
    };
    table.iter().map(build).collect()
}

/// A text that a person reads, with the place where it is written.
struct Text {
    place: String,
    text: String,
}

/// The strings of a Rust file that hold words, tests left out.
fn of_rust(path: &str, text: &str, found: &mut Vec<Text>) {
    for (token, line) in without_tests(&tokens(text)) {
        let Token::Text(text) = token else { continue };
        let text = joined(text);
        if text.split_whitespace().count() > 1 {
            let place = format!("{path}:{line}");
            found.push(Text { place, text });
        }
    }
}

/// A string without its line breaks.
fn joined(text: &str) -> String {
    let mut lines = text.split("\\\n");
    let first = lines.next().unwrap_or("").to_string();
    lines.fold(first, |text, line| text + line.trim_start())
}

/// The comments that the help of a program is made from.
fn of_help(path: &str, text: &str, found: &mut Vec<Text>) {
    for (number, line) in text.lines().enumerate() {
        if let Some(text) = line.trim().strip_prefix("/// ") {
            found.push(Text {
                place: format!("{path}:{}", number + 1),
                text: text.to_string(),
            });
        }
    }
}

/// The lines of a page outside its fences of code.
fn of_page(path: &str, text: &str, found: &mut Vec<Text>) {
    let mut is_code = false;
    for (number, line) in text.lines().enumerate() {
        if line.trim_start().starts_with("```") {
            is_code = !is_code;
        } else if !is_code {
            found.push(Text {
                place: format!("{path}:{}", number + 1),
                text: line.to_string(),
            });
        }
    }
}

/// The strings of a script that hold words.
fn of_script(path: &str, text: &str, found: &mut Vec<Text>) {
    let strings = Regex::new(r#"'(?:\\.|[^'\\\n])*'|"(?:\\.|[^"\\\n])*"|`[^`]*`"#).unwrap();
    for (number, line) in text.lines().enumerate() {
        if line.trim_start().starts_with("//") {
            continue;
        }
        for string in strings.find_iter(line) {
            if string.as_str().trim().contains(' ') {
                found.push(Text {
                    place: format!("{path}:{}", number + 1),
                    text: string.as_str().to_string(),
                });
            }
        }
    }
}

/// Every text that a person reads.
fn texts() -> Vec<Text> {
    let mut found = Vec::new();
    for (path, text) in files(&["src", "rules"], ".rs") {
        if path.ends_with("tests.rs") {
            continue;
        }
        of_rust(&path, &text, &mut found);
        if path.starts_with("src/cli/") && path.ends_with("args.rs") {
            of_help(&path, &text, &mut found);
        }
    }
    for (path, text) in files(
        &[
            "src",
            "rules",
            "docs",
            "corpus",
            "editors",
            "benches",
            "site/pages",
        ],
        ".md",
    ) {
        of_page(&path, &text, &mut found);
    }
    for path in ["README.md", "CONTRIBUTING.md"] {
        let text = fs::read_to_string(root().join(path)).unwrap();
        of_page(path, &text, &mut found);
    }
    for (path, text) in files(&["src/port/player", "editors/vscode"], ".js") {
        // The bundle of the extension holds its libraries.
        if !path.contains("/dist/") {
            of_script(&path, &text, &mut found);
        }
    }
    for (path, text) in files(&["src/ide"], ".txt") {
        of_page(&path, &text, &mut found);
    }
    for (path, text) in files(&["editors"], "package.json") {
        of_script(&path, &text, &mut found);
    }
    found
}

/// The refused words of a text.
fn complaints(text: &str, refused: &[(Regex, &'static str)]) -> Vec<String> {
    let mut text = text.to_string();
    for allowed in ALLOWED {
        text = text.replace(allowed, "");
    }
    let found = refused.iter().filter_map(|(regex, instead)| {
        let hit = regex.find(&text)?;
        Some(format!("`{}` -> {instead}", hit.as_str().trim()))
    });
    found.collect()
}

#[test]
fn texts_have_no_refused_words() {
    let refused = refused(TEXTS);
    let mut problems = Vec::new();
    for Text { place, text } in texts() {
        for complaint in complaints(&text, &refused) {
            problems.push(format!("{place}: {complaint}: {}", text.trim()));
        }
    }
    let count = problems.len();
    assert!(problems.is_empty(), "{count}:\n{}", problems.join("\n"));
}

/// The names that a text declares, tests left out.
fn declared(text: &str) -> Vec<(&str, usize)> {
    const BEFORE: &[&str] = &[
        "fn", "struct", "enum", "trait", "type", "mod", "const", "static", "let", "mut",
    ];
    let all = tokens(text);
    let tokens = without_tests(&all);
    let mut found = Vec::new();
    for three in tokens.windows(3) {
        let [(before, _), (Token::Name(name), line), (after, _)] = three else {
            continue;
        };
        let is_declared = matches!(before, Token::Name(word) if BEFORE.contains(word));
        // A field, a parameter or a variant.
        let is_listed = matches!(before, Token::Mark('{' | '(' | ',') | Token::Name("pub"))
            && matches!(after, Token::Mark(':' | ',' | '(' | '{' | '}'));
        if (is_declared || is_listed) && *name != "mut" {
            found.push((*name, *line));
        }
    }
    found
}

/// The words of a name, in lower case.
fn parts(name: &str) -> Vec<String> {
    let mut parts: Vec<String> = vec![String::new()];
    let mut is_lower = false;
    for c in name.chars() {
        if !c.is_alphabetic() || (c.is_uppercase() && is_lower) {
            parts.push(String::new());
        }
        is_lower = c.is_lowercase();
        if let Some(part) = parts.last_mut().filter(|_| c.is_alphabetic()) {
            part.extend(c.to_lowercase());
        }
    }
    parts
}

/// What to write instead of a refused word of a name.
fn better_name(name: &str) -> Option<&'static str> {
    if ALLOWED_NAMES.contains(&name) {
        return None;
    }
    let parts = parts(name);
    let is_refused = |words: &str| words.split(' ').any(|w| parts.iter().any(|p| p == w));
    NAMES.iter().find(|n| is_refused(n.0)).map(|n| n.1)
}

#[test]
fn names_in_code_have_no_refused_words() {
    let mut problems = Vec::new();
    let mut count = 0;
    for (path, text) in files(&["src", "rules", "fuzz"], ".rs") {
        let file = path.rsplit('/').next().unwrap_or(&path);
        let file = file.trim_end_matches(".rs");
        let names = declared(&text);
        count += names.len();
        for (name, line) in names.into_iter().chain([(file, 1)]) {
            if let Some(better) = better_name(name) {
                problems.push(format!("{path}:{line}: `{name}` -> {better}"));
            }
        }
    }
    assert!(count > 10_000, "{count}");
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

/// What the pages and the corpus print: the titles, and the lines after them.
fn printed() -> Vec<(String, String)> {
    let mut found = Vec::new();
    for (path, text) in files(&["rules"], ".md") {
        let fences = text.split("```text\n").skip(1);
        let printed = fences.filter_map(|f| f.split("\n```").next());
        found.extend(printed.map(|p| (path.clone(), p.to_string())));
    }
    found.extend(files(&["corpus/mistakes", "corpus/pitfalls"], ".txt"));
    found
}

#[test]
fn titles_fit_into_a_line() {
    let mut problems = Vec::new();
    for (path, text) in printed() {
        for line in text.lines() {
            if let Some(title) = title_of(line)
                && title.chars().count() > MOST_TITLE
            {
                problems.push(format!("{path}: {}: {title}", title.chars().count()));
            }
        }
    }
    problems.sort();
    problems.dedup();
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

/// The title of a finding as it is printed.
fn title_of(line: &str) -> Option<&str> {
    let (head, title) = line.split_once("]: ")?;
    let severity = head.split('[').next()?;
    ["error", "warning", "info"]
        .contains(&severity)
        .then_some(title)
}

#[test]
fn sentences_of_findings_are_short() {
    let mut problems = Vec::new();
    for (path, text) in printed() {
        for line in text.lines() {
            let Some((_, note)) = line.split_once(" = ") else {
                continue;
            };
            for sentence in note.split(['.', ';', ':']) {
                let words = sentence.split_whitespace().count();
                if words > MOST_SENTENCE {
                    problems.push(format!("{path}: {words} words: {note}"));
                }
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

#[test]
fn the_guards_find_what_they_refuse() {
    let refused = refused(TEXTS);
    for bad in [
        "nothing declares `x`",
        "the picture hangs on digits",
        "a loop that runs in every turn",
        "`int` cannot become `float` by itself",
        "9 things were mended",
        "a mistake in a whole shader",
        "`cast` is no function",
    ] {
        assert!(!complaints(bad, &refused).is_empty(), "{bad}");
    }
    for good in [
        "`x` is not declared",
        "turn it off",
        "there is no output",
        "it turns off",
    ] {
        assert!(complaints(good, &refused).is_empty(), "{good}");
    }
    let text = "pub fn told(turns: u8) { let mut x = 1; } struct S { isGone: u8 }\n\
        #[cfg(test)]\nmod tests { fn f() {} }";
    let names: Vec<&str> = declared(text).into_iter().map(|(name, _)| name).collect();
    assert_eq!(names, ["told", "turns", "x", "S", "isGone"]);
    let refused: Vec<&str> = names
        .into_iter()
        .filter(|n| better_name(n).is_some())
        .collect();
    assert_eq!(refused, ["told", "turns", "isGone"]);
    assert_eq!(better_name("return_type"), None);
    assert_eq!(title_of("error[a-b]: `x` is bad"), Some("`x` is bad"));
    assert_eq!(title_of("  = note]: x"), None);
    assert_eq!(joined("a \\\n    b"), "a b");
}
