//! Errors in macros and directives are reported at the cause, and their fixes work.

use crate::{Checked, analyze_fragment};
use shaderlint_text::{apply_edits, each_case};

const HEAD_LINE: &str = "#version 300 es\n";
const HEAD: &str = "#version 300 es\nprecision highp float;\nout vec4 color;\n";

/// The findings in `code`, each as `line:column rule` with lines counted in `code`, and the code
/// with the first fix applied.
pub(super) fn found(code: &str) -> (Vec<String>, String) {
    let head = if code.starts_with(HEAD_LINE) {
        ""
    } else {
        HEAD
    };
    let text = format!("{head}{code}");
    let Checked {
        program,
        diagnostics,
        ..
    } = analyze_fragment(&text);
    let reported = diagnostics.iter().map(|d| {
        let file = program.sources.file_at(d.span.start).unwrap();
        let at = file.position(d.span.start);
        format!("{}:{} {}", at.line - 3, at.column, d.rule)
    });
    let reported = reported.collect();
    let fix = diagnostics.first().and_then(|d| d.fix.as_ref());
    let fixed = fix.map_or(text.clone(), |f| apply_edits(&text, 0, &f.edits).unwrap());
    let code = fixed.strip_prefix(HEAD).unwrap_or(&fixed);
    (reported, code.to_string())
}

/// Checks that `code` has exactly this error and that its fix leaves none.
#[track_caller]
pub(super) fn check(code: &str, expected: &str) {
    let (reported, fixed) = found(code);
    assert_eq!(reported, [expected], "{code}");
    assert_eq!(found(&fixed).0, [""; 0], "{fixed}");
}

/// A shader with these definitions and this body of `main`.
pub(super) fn main_with(definitions: &str, body: &str) -> String {
    format!("{definitions}\nvoid main() {{\n    {body}\n}}\n")
}

/// Definitions and directives, and the body of `main` after them.
#[test]
fn faulty_directives_are_reported_once_at_their_cause() {
    each_case(include_str!("directives.txt"), |code, expected| {
        let (head, body) = code.split_once(" ‖ ").unwrap();
        check(&main_with(head, body), expected);
    });
}

/// Complete shaders without their head, and the places and names of their errors.
#[test]
fn errors_of_complete_shaders_are_found() {
    each_case(include_str!("complete.txt"), |code, expected| {
        let reported = found(code).0.join(", ");
        assert_eq!(reported, expected.replace("none", ""), "{code}");
    });
}

#[test]
fn a_stray_hash_is_not_a_misspelled_directive() {
    let code = "void main() {\n    color = vec4(1.0);\n    if (color.x > 0.5) {\n        color.y = 2.0;\n#    }\n}\n";
    let (reported, fixed) = found(code);
    assert_eq!(reported, ["4:23 unclosed-delimiter", "5:1 bad-directive"]);
    assert!(!fixed.contains("#if"), "{fixed}");
}

#[test]
fn rechecks_of_a_long_text_are_limited_by_a_budget() {
    let reported = |comment: usize| {
        let comment = format!("/*{}*/", "*".repeat(comment));
        let (reported, _) = found(&main_with(
            "#define N 64.0;",
            &format!("color = vec4(N + 1.0); {comment}"),
        ));
        reported
    };
    assert_eq!(reported(10), ["1:15 faulty-macro"]);
    let long = reported(13_000_000);
    assert!(!long.is_empty() && long != reported(10), "{long:?}");
}

/// Several mistakes in one statement, also if a word starts with a keyword or a type. After a syntax
/// error, names and types of the same statement are not reported.
#[test]
fn every_mistake_of_a_statement_is_reported() {
    for case in include_str!("several.txt").lines() {
        let (statement, expected) = case.rsplit_once(" => ").unwrap();
        let body = format!("float d = 0.5;\n{statement}\ncolor = vec4(d);");
        let reported = found(&main_with("", &body)).0;
        assert_eq!(reported.join(", "), expected, "{statement}");
    }
}

/// The rest is checked with the declarations: the second error is in an expression with `fbm`.
#[test]
fn missing_names_that_everybody_knows_are_declared() {
    let (reported, fixed) = found(&main_with("", "color = vec4(fbm(vec2(0.5)) * 2);"));
    assert_eq!(reported, ["3:18 undeclared-name", "3:35 int-float-mix"]);
    assert!(fixed.contains("float noise(vec2 p)"), "{fixed}");
    let body = "color = vec4(uSize.xy * SURF_DIST, 0, 0);";
    let declared = analyze_fragment(&format!("{HEAD}{}", main_with("", body)));
    let fixes = declared.diagnostics.iter().filter_map(|d| d.fix.as_ref());
    let titles: Vec<&str> = fixes.map(|fix| fix.title.as_str()).collect();
    let expected = ["uniform vec2 uSize;", "const float SURF_DIST = 0.001;"];
    assert_eq!(titles, expected.map(|line| format!("declare it: `{line}`")));
}
