//! Names of tests: each is a claim that a reader understands without the body of the test.

use super::super::tidy::code::{Token, tokens};
use super::super::tidy::files;
use super::{TEXTS, better_name, complaints, refused};
use regex::Regex;

/// Refused in names of tests, in addition to what texts must not contain, and what to write.
const CLAIMS: &[(&str, &str)] = &[
    // A clause as the subject does not say what the test is about.
    (
        r"(?:^|: )(?:what|who|whoever)",
        "the noun: `invalid uniforms are reported`",
    ),
    (r"^(?:it|they)", "the noun"),
    // Idioms.
    (
        r"comes? (?:round|back|together|to light)",
        "is loop-carried, is restored, converges, is uncovered",
    ),
    (
        r"as (?:it|they) (?:is|are|was|were|may|can|stands?)|stays? (?:as|what|where)",
        "is kept, is not changed",
    ),
    (r"need not", "may lack, can be omitted"),
    (r"where (?:it|they) (?:can|may|must)", "if possible"),
    (r"(?:is|are) no", "is not a"),
    (r"(?:is|are|has|have|makes?|leaves?) none", "has no NOUN"),
    (r"(?:is|are)(?: only)? known", "is found, is recognised"),
    (
        r"hears?|speaks?|believed|understood",
        "is notified, indicates, is accepted",
    ),
    (
        r"however|whoever|wherever|whatever",
        "at any depth, in every spelling",
    ),
    (r"all the same", "still"),
    (r"lies?", "is in"),
    (r"gives? back", "restores, returns"),
    (
        r"goes? (?:away|around|back|before|on)",
        "is removed, is inserted, is restored, continues",
    ),
    (r"alone", "only, without NOUN"),
    (
        r"passed over|made of|put together|taken away",
        "is skipped, is computed from, is joined, is removed",
    ),
];
/// Fewest words of a function's name: a subject, a verb and what it states.
const FEWEST_WORDS: usize = 3;

/// The name of a test, with the file that declares it.
struct TestName {
    path: String,
    name: String,
    /// A function, whose name has underscores for spaces; other names are titles.
    is_function: bool,
}

/// The names of the functions with `#[test]`.
fn of_rust(text: &str) -> Vec<String> {
    let tokens: Vec<Token> = tokens(text).into_iter().map(|(token, _)| token).collect();
    let marked = tokens.windows(3).enumerate().filter_map(|(at, three)| {
        matches!(
            three,
            [Token::Mark('['), Token::Name("test"), Token::Mark(']')]
        )
        .then_some(at)
    });
    let named = marked.filter_map(|at| {
        let rest = &tokens[at..];
        let declared = rest.iter().position(|t| *t == Token::Name("fn"))?;
        match rest.get(declared + 1) {
            Some(Token::Name(name)) => Some(name.to_string()),
            // The parameter of a macro.
            _ => None,
        }
    });
    named.collect()
}

/// The names that pytest collects.
fn of_python(text: &str) -> Vec<String> {
    let declared = Regex::new(r"(?m)^\s*(?:async )?def test_(\w+)").unwrap();
    declared
        .captures_iter(text)
        .map(|c| c[1].to_string())
        .collect()
}

/// The titles of `node:test`: of calls, of rows for the suite of a browser, and of named steps.
fn of_script(text: &str) -> Vec<String> {
    let declared = [
        r#"\btest\(\s*(?:'([^'\n]+)'|"([^"\n]+)"|`([^`]+)`)"#,
        r#"\{ name: (?:'([^'\n]+)'|"([^"\n]+)"|`([^`]+)`),[^\n]*\brun\b"#,
        r#"(?m)^  (?:'([^'\n]+ [^'\n]+)'|"([^"\n]+ [^"\n]+)"): (?:\(|\w+,)"#,
    ];
    let mut found = Vec::new();
    for pattern in declared {
        let pattern = Regex::new(pattern).unwrap();
        let titles = pattern.captures_iter(text);
        found.extend(
            titles.filter_map(|c| Some(c.iter().skip(1).flatten().next()?.as_str().to_string())),
        );
    }
    found
}

/// The names of all tests in a language.
fn names(folders: &[&str], extension: &str, read: fn(&str) -> Vec<String>) -> Vec<TestName> {
    let of_file = |(path, text): (String, String)| {
        let named = read(&text).into_iter();
        let named = named.map(move |name| TestName {
            path: path.clone(),
            name,
            is_function: !extension.ends_with("js"),
        });
        named.collect::<Vec<_>>()
    };
    files(folders, extension)
        .into_iter()
        .flat_map(of_file)
        .collect()
}

/// What is refused in the name of a test.
fn faults(test: &TestName, refused: &[(Regex, &'static str)]) -> Vec<String> {
    let text = test.name.replace('_', " ");
    let mut found = complaints(&text, refused);
    let words = text.split(|c: char| !c.is_alphanumeric());
    found.extend(words.filter_map(better_name).map(str::to_string));
    if test.is_function && text.split_whitespace().count() < FEWEST_WORDS {
        found.push("a claim of at least three words".to_string());
    }
    found
}

#[test]
fn test_names_are_claims_without_refused_words() {
    let refused = [refused(TEXTS), refused(CLAIMS)].concat();
    let mut problems = Vec::new();
    for (extension, folders, read, fewest) in [
        (
            ".rs",
            &["src", "rules", "tests", "fuzz", "benches"][..],
            of_rust as fn(&str) -> Vec<String>,
            800,
        ),
        (".py", &["tests"], of_python, 180),
        (".js", &["tests"], of_script, 180),
        (".mjs", &["tests"], of_script, 8),
    ] {
        let all = names(folders, extension, read);
        assert!(all.len() >= fewest, "{} names in *{extension}", all.len());
        for test in &all {
            let faults = faults(test, &refused).into_iter();
            problems.extend(faults.map(|fault| format!("{}: {}: {fault}", test.path, test.name)));
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

#[test]
fn test_names_are_read_in_every_language() {
    let rust = "#[test]\nfn a_is_b() {}\nfn no() {}\n#[test]\n#[ignore]\nfn c_is_d() {}\n\
        macro_rules! m { () => { #[test] fn $name() {} } }\n// #[test]\nfn no() {}\n";
    assert_eq!(of_rust(rust), ["a_is_b", "c_is_d"]);
    let python =
        "def test_a_is_b(case):\n    pass\nasync def test_c_is_d():\n    def testing(): pass\n";
    assert_eq!(of_python(python), ["a_is_b", "c_is_d"]);
    let script = "test(\"a's b\", () => {});\n  await t.test('c is d', run);\ntest(`${e}: f`, () => {});\n\
        const all = [\n  { name: 'g is h', run: go, context },\n  { name: 'no' },\n];\n\
        const STEPS = {\n  'i is j': go,\n  'k': go,\n  'l is m': () => go(),\n};\n";
    let titles = ["a's b", "c is d", "${e}: f", "g is h", "i is j", "l is m"];
    assert_eq!(of_script(script), titles);
}

#[test]
fn translated_names_are_refused() {
    let refused = [refused(TEXTS), refused(CLAIMS)].concat();
    let is_refused = |name: &str, is_function| {
        let test = TestName {
            path: String::new(),
            name: name.to_string(),
            is_function,
        };
        !faults(&test, &refused).is_empty()
    };
    for bad in [
        "what_comes_round_in_a_loop_is_bounded",
        "a_text_stays_as_it_stands_where_it_can",
        "faults_need_not_look_at_every_number",
        "truth_values_are_no_numbers",
        "pictures_are_drawn_twice",
        "values_said_by_hosts",
        "assignments",
    ] {
        assert!(is_refused(bad, true), "{bad}");
    }
    assert!(is_refused("page: what is dropped", false));
    assert!(!is_refused(
        "loop_carried_variables_have_bounded_ranges",
        true
    ));
    assert!(!is_refused("remount: a page", false));
}
