//! A mistake of the text or of a declaration is one error, and its fix leaves none.

use super::super::tests::{check, main_with};

const TOP: &str = "float half_of(float x) { return 0.5 * x; }";

/// Code before `main`, or before the last statement of `main`, with `↵` for a line break.
#[test]
fn mistakes_of_texts_and_declarations_are_one_error_each() {
    let tables = [
        include_str!("cases.txt"),
        include_str!("../declarations.txt"),
    ];
    let cases = tables.iter().flat_map(|table| table.lines());
    for case in cases.filter(|case| !case.starts_with("# ")) {
        let (code, expected) = case.rsplit_once(" ⇒ ").unwrap();
        let code = code.replace('↵', "\n");
        let in_main = |code: &str| format!("float d = 0.5;\n    {code}\n    color = vec4(d);");
        let shader = match code.strip_prefix("in main: ") {
            Some(code) => main_with(TOP, &in_main(code)),
            None => main_with(code.strip_prefix("at top: ").unwrap(), "color = vec4(0.5);"),
        };
        check(&shader, expected);
    }
}

/// A word alone on a line is an undeclared name unless a brace is missing.
#[test]
fn names_are_not_taken_for_braces() {
    let code = "#version 300 es\nprecision highp float;\nout vec4 color;\nvoid main() {\n    \
                color = vec4(mix(\n        1.0,\n        2.0,\n        progress\n    ));\n}\n";
    let found = crate::analyze_fragment(code).diagnostics;
    let messages: Vec<&str> = found.iter().map(|d| d.message.as_str()).collect();
    assert_eq!(messages, ["`progress` is not declared"]);
}
