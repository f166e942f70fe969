//! Small shaders and the browser's verdict on each: `corpus/verdicts`, whose README describes the
//! format. `tests/browser/verdicts.js` compares them with the browser.
//!
//! `INSTA_UPDATE=always cargo test` records the rule under which shaderlint rejects what the
//! browser rejects.

use super::recorded::accepts;
use shaderlint::diagnostic::Severity;
use shaderlint::engine::{DialectChoice, Options, check};
use shaderlint::lint::Settings;
use shaderlint::project::NoFiles;
use shaderlint::syntax::{EXTENSIONS, WebGl};
use std::fs;
use std::path::{Path, PathBuf};

/// The head of a case, and the lines after it.
struct Case<'a> {
    head: &'a str,
    /// `accepted`, `refused LINE` or `refused LINE RULE`.
    verdict: Vec<&'a str>,
    is_new: bool,
    is_fragment: bool,
    /// The context, if the head names one; otherwise WebGL2.
    webgl: Option<WebGl>,
    /// Whether all extensions of the context are enabled.
    has_extensions: bool,
    code: String,
}

/// What a head may say about a case.
const WORDS: [&str; 7] = [
    "100", "300", "vertex", "fragment", "webgl1", "webgl2", "extended",
];

/// Parses the head of a case, `//: VERDICT[, VERSION STAGE CONTEXT][: TITLE]`.
fn head(line: &str) -> Option<Case<'_>> {
    let message = line.strip_prefix("//: ")?;
    let message = message
        .split_once(": ")
        .map_or(message, |(message, _)| message);
    let (verdict, kind) = message.split_once(", ").unwrap_or((message, ""));
    assert!(
        kind.split_whitespace().all(|w| WORDS.contains(&w)),
        "{line}"
    );
    Some(Case {
        head: line,
        verdict: verdict.split(' ').collect(),
        is_new: !kind.contains("100"),
        is_fragment: !kind.contains("vertex"),
        webgl: match (kind.contains("webgl1"), kind.contains("webgl2")) {
            (true, _) => Some(WebGl::One),
            (_, true) => Some(WebGl::Two),
            _ => None,
        },
        has_extensions: kind.contains("extended"),
        code: String::new(),
    })
}

fn cases(text: &str) -> Vec<Case<'_>> {
    let mut found: Vec<Case> = Vec::new();
    for line in text.lines().filter(|l| !l.starts_with("//#")) {
        match (head(line), found.last_mut()) {
            (Some(case), _) => found.push(case),
            (None, Some(last)) => last.code.push_str(&format!("{line}\n")),
            (None, None) => {}
        }
    }
    found
}

/// The complete shader, and its file name.
fn shader(case: &Case) -> (String, &'static str) {
    let name = if case.is_fragment { "a.frag" } else { "a.vert" };
    let code = format!("{}\n", case.code.trim_end());
    let is_version = |line: &str| {
        let name = line.trim_start().strip_prefix('#').map(str::trim_start);
        name.is_some_and(|name| name.starts_with("version"))
    };
    if code.lines().any(is_version) {
        return (code, name);
    }
    let version = if case.is_new { "300 es" } else { "100" };
    let precision = if case.is_fragment {
        "precision highp float;\n"
    } else {
        ""
    };
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let has_main = code.split(|c| !is_word(c)).any(|w| w == "main");
    let main = if has_main { "" } else { "void main() {}\n" };
    // Directives for a context stand before all code.
    let is_directive = |line: &&str| case.webgl.is_some() && line.starts_with('#');
    let lines = code.split_inclusive('\n');
    let length: usize = lines.take_while(is_directive).map(str::len).sum();
    let (directives, code) = code.split_at(length);
    let code = format!("#version {version}\n{directives}{precision}{code}{main}");
    (code, name)
}

/// The rule of the first error that shaderlint reports.
fn judge(case: &Case) -> Option<&'static str> {
    let mut options = Options::new(DialectChoice::Auto, Settings::of_rules(&[]));
    let all = EXTENSIONS.iter().map(|facts| facts.extension);
    options.webgl = Some(case.webgl.unwrap_or(WebGl::Two));
    options.extensions = Some(all.filter(|_| case.has_extensions).collect());
    let (text, name) = shader(case);
    let report = check(name, &text, &options, &NoFiles);
    assert!(report.unread.is_none(), "unreadable case: {}", case.head);
    let mut all = report.diagnostics.iter();
    all.find(|d| d.severity == Severity::Error).map(|d| d.rule)
}

fn files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus/verdicts");
    let entries = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path());
    let mut found: Vec<PathBuf> = entries
        .filter(|p| p.extension().is_some_and(|e| e == "glsl"))
        .collect();
    found.sort();
    found
}

/// Writes the rules into the heads of the cases that both shaderlint and the browser reject.
fn record_rules() {
    for path in files() {
        let mut text = fs::read_to_string(&path).unwrap();
        let all = text.clone();
        for case in cases(&all) {
            if let (["refused", line, ..], Some(rule)) = (case.verdict.as_slice(), judge(&case)) {
                let verdict = format!("refused {line} {rule}");
                let head = case.head.replacen(&case.verdict.join(" "), &verdict, 1);
                let with = |head: &str| format!("{head}\n{}", case.code);
                text = text.replace(&with(case.head), &with(&head));
            }
        }
        fs::write(path, text).unwrap();
    }
}

#[test]
fn verdicts_match_the_browser() {
    if accepts() {
        record_rules();
    }
    let (mut accepted, mut refused) = (0, 0);
    let mut wrong = Vec::new();
    for path in files() {
        let text = fs::read_to_string(&path).unwrap();
        for case in cases(&text) {
            let found = judge(&case);
            let is_right = match (case.verdict.as_slice(), found) {
                (["accepted"], found) => found.is_none(),
                (["refused", _, rule], Some(found)) => *rule == found,
                _ => false,
            };
            accepted += usize::from(case.verdict[0] == "accepted");
            refused += usize::from(case.verdict[0] == "refused");
            if !is_right {
                let name = path.file_name().unwrap().display();
                let found = found.unwrap_or("accepted");
                wrong.push(format!(
                    "{name}: found {found}, expected {}\n{}",
                    case.head, case.code
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(
        accepted > 300 && refused > 300,
        "{accepted} accepted, {refused} refused"
    );
}
