//! Diagnostics and fixes of single statements.

use super::explain;
use crate::analyze_fragment;
use shaderlint_semantic::check_row;
use shaderlint_text::{apply_edits, each_case};

const HEAD: &str = "#version 300 es\nprecision highp float;\nout vec4 color;\n\
                    uniform vec3 size;\nfloat own(vec2 p, float k) { return p.x * k; }\n\
                    void main() {\n    color = vec4(1);\n    int i = 1; float f = 2.; vec2 v = vec2(f);\n";

/// Checks the diagnostics of a statement: `message`, or `message => the statement with the fix
/// applied`.
#[track_caller]
fn check(statement: &str, expected: &str) {
    let text = format!("{HEAD}{statement}\n}}\n");
    let found = analyze_fragment(&text);
    let all: Vec<String> = found
        .diagnostics
        .iter()
        .map(|d| match &d.fix {
            Some(fix) => {
                let repaired = apply_edits(&text, 0, &fix.edits).unwrap();
                let repaired = repaired.strip_prefix(HEAD).unwrap_or(&repaired);
                let repaired = repaired.strip_suffix("\n}\n").unwrap_or(repaired);
                format!("{} => {repaired}", d.message)
            }
            None => d.message.clone(),
        })
        .collect();
    assert_eq!(all.join("; "), expected, "{statement}");
}

/// A statement, and what `check` compares it with; `↵` is a line break.
#[test]
fn statements_have_the_expected_messages_and_fixes() {
    each_case(include_str!("cases.txt"), check);
}

/// A missing brace has no position for an edit.
#[test]
fn unclosed_initializer_lists_have_no_fix() {
    let text = format!("{HEAD}float x = {{ f\n");
    for found in analyze_fragment(&text).diagnostics {
        let edits = found.fix.map_or(Vec::new(), |fix| fix.edits);
        assert!(apply_edits(&text, 0, &edits).is_ok(), "{}", found.message);
        assert!(found.rule != "initializer-list" || edits.is_empty());
    }
}

/// Applies the first fix of each shader: `before ⇒ after`, or `none` if there is no fix. After `only:`
/// the shader has one finding.
#[test]
fn fixes_make_complete_shaders_valid() {
    const VERSION: &str = "#version 300 es\nprecision highp float;\n";
    each_case(include_str!("shaders.txt"), |before, expected| {
        let text = |code: &str| format!("{VERSION}{}", code);
        let only = before.strip_prefix("only: ");
        let before = text(only.unwrap_or(before));
        let found = analyze_fragment(&before).diagnostics;
        assert!(only.is_none() || found.len() == 1, "{before}: {found:?}");
        let fix = found.iter().find_map(|d| d.fix.as_ref());
        let after = fix.map(|f| apply_edits(&before, 0, &f.edits).unwrap());
        let expected = Some(expected).filter(|e| *e != "none").map(text);
        assert_eq!(after, expected, "{before}");
        if let Some(after) = after {
            let left = analyze_fragment(&after).diagnostics;
            assert!(left.is_empty(), "{after}: {left:?}");
        }
    });
}

/// Every problem in the checker's table of tests has a message of one line without a full stop.
#[test]
fn problems_of_the_checker_have_messages_of_one_line() {
    let rows = include_str!("../../semantic/checker/problems.txt").lines();
    for row in rows.filter(|row| !row.starts_with("# ")) {
        let (shader, expected) = check_row(row);
        for d in explain(&shader.program, &shader.problems) {
            let ends_well = !d.message.is_empty() && !d.message.ends_with('.');
            assert!(ends_well && !d.message.contains('\n'), "{d:?}");
        }
        let mut problems = shader.problems.all.iter();
        let is_found = problems.any(|p| format!("{:?}", p.what).contains(&format!("({expected}")));
        assert!(is_found, "{row}");
    }
}
