//! Tables of code and the first problem that is found in it. The tests of `explain` read
//! `problems.txt` too: each of its problems has a message.

use super::*;
use crate::check_row;

/// The enums of problems, and the files that define them.
const SOURCES: [(&str, &str); 19] = [
    ("CallError", include_str!("calls.rs")),
    ("ArrayError", include_str!("declarations/array.rs")),
    ("DeclarationError", include_str!("declarations/declare.rs")),
    ("EntryError", include_str!("declarations/entry.rs")),
    ("FunctionError", include_str!("declarations/function.rs")),
    ("InterfaceError", include_str!("declarations/interface.rs")),
    ("LayoutError", include_str!("declarations/layout.rs")),
    ("OutputError", include_str!("declarations/output.rs")),
    ("QualifierError", include_str!("declarations/qualifier.rs")),
    ("RecordError", include_str!("declarations/record.rs")),
    ("ValueError", include_str!("expressions/assign.rs")),
    ("ArgumentError", include_str!("expressions/call.rs")),
    ("ExpressionError", include_str!("expressions/expression.rs")),
    ("PlaceError", include_str!("expressions/place.rs")),
    ("ForeignError", include_str!("foreign.rs")),
    ("NameError", include_str!("names.rs")),
    ("StatementError", include_str!("statement.rs")),
    ("SwitchError", include_str!("switch.rs")),
    ("Restriction", include_str!("webgl1.rs")),
];

#[test]
fn every_problem_is_found() {
    let tables = include_str!("problems.txt").split("# ").skip(1);
    let mut sources = SOURCES.into_iter();
    for table in tables {
        let (name, rows) = table.split_once('\n').unwrap();
        let (of, source) = sources.next().expect(name);
        assert_eq!(of, name);
        finds(source, name, rows);
    }
    assert_eq!(sources.next(), None);
}

/// Checks a table of lines `code => first problem`, and that each variant of the enum `name` in
/// `source` is found.
#[track_caller]
pub(super) fn finds(source: &str, name: &str, table: &str) {
    let mut all = Vec::new();
    for row in table.lines().map(str::trim).filter(|row| !row.is_empty()) {
        let (shader, expected) = check_row(row);
        let kind = |p: &Problem| {
            let shown = format!("{:?}", p.what);
            shown.split_once('(').map_or("", |(_, of)| of).to_string()
        };
        let found: Vec<String> = shader.problems.all.iter().map(kind).collect();
        let first = found.first().map(|f| variant(f));
        assert_eq!(first, Some(expected), "{row}: {found:?}");
        all.push(expected);
    }
    for one in variants(source, name) {
        assert!(all.contains(&one), "no code for `{name}::{one}`");
    }
}

/// The name of a variant, without its fields.
fn variant(debug: &str) -> &str {
    let end = debug.find(|c: char| !c.is_alphanumeric());
    &debug[..end.unwrap_or(debug.len())]
}

/// The variants of an enum, as its source lists them.
fn variants<'a>(source: &'a str, name: &str) -> Vec<&'a str> {
    let start = source.find(&format!("enum {name} {{")).expect(name);
    let lines = source[start..]
        .lines()
        .skip(1)
        .map_while(|line| (line != "}").then_some(line.strip_prefix("    ")?));
    lines
        .filter(|line| line.starts_with(char::is_uppercase))
        .map(variant)
        .collect()
}
