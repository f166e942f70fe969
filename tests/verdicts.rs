//! Small shaders and what Chromium says of them: `tests/verdicts.txt`. The browser's own step asks it
//! again.

use shaderlint::diagnostic::Severity;
use shaderlint::engine::{DialectChoice, NoFiles, Options, check};
use shaderlint::lint::Settings;

/// The whole shader that a line stands for, and the name of its file.
fn shader(kind: &str, code: &str) -> (String, &'static str) {
    let is_fragment = kind.contains('f');
    let (globals, body) = match code.split_once("@@") {
        Some((globals, body)) => (globals.trim(), format!("void main(){{{body}}}\n")),
        None => (code, String::new()),
    };
    let mut text = String::new();
    if kind.starts_with('3') {
        text.push_str("#version 300 es\n");
    }
    if is_fragment {
        text.push_str("precision highp float;\n");
        if kind.starts_with('3') && !kind.contains('O') {
            text.push_str("out vec4 o;\n");
        }
    }
    let name = if is_fragment { "a.frag" } else { "a.vert" };
    (format!("{text}{globals}\n{body}"), name)
}

#[test]
fn the_verdict_is_the_browsers() {
    let options = Options::new(DialectChoice::Auto, Settings::of_rules(&[]));
    let mut wrong = Vec::new();
    for line in include_str!("verdicts.txt").lines() {
        let Some((expected, rest)) = line.split_once(": ").filter(|_| !line.starts_with('#'))
        else {
            continue;
        };
        let (kind, code) = rest.split_once(' ').unwrap();
        let (text, name) = shader(kind, code);
        let report = check(name, &text, &options, &NoFiles);
        assert!(report.unread.is_none(), "{line} cannot be judged");
        let mut errors = report.diagnostics.iter();
        let found = errors.find(|d| d.severity == Severity::Error);
        let found = found.map_or("ok", |d| d.rule);
        if found != expected {
            wrong.push(format!("{found}, not {line}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
