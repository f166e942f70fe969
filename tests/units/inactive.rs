//! Code that `#if` excludes, and words that a version reserves.

use shaderlint::diagnostic::{Severity, error};
use shaderlint::engine::{Options, check};
use shaderlint::project::NoFiles;

/// The lines and last notes of the warnings about excluded code.
fn found(text: &str) -> Vec<(u32, String)> {
    let report = check("a.glsl", text, &Options::default(), &NoFiles);
    let noted = report.diagnostics.iter().filter_map(|d| {
        let note = d.notes.iter().find(|n| n.starts_with("an error if"))?;
        let file = report.sources.file_at(d.span.start)?;
        Some((file.position(d.span.start).line, note.clone()))
    });
    noted.collect()
}

#[track_caller]
fn check_found(text: &str, expected: &[(u32, &str)]) {
    let expected: Vec<(u32, String)> = expected
        .iter()
        .map(|(line, of)| (*line, format!("an error if {of}")))
        .collect();
    assert_eq!(found(text), expected, "{text}");
}

#[test]
fn mistakes_in_inactive_branches_are_reported() {
    check_found(
        "float f(vec3 a) {\n#ifdef TINT\n  vec2 b = a;\n#endif\n  return a.x;\n}\n",
        &[(3, "`TINT` is defined")],
    );
    check_found(
        "float f(vec3 a) {\n#ifndef PLAIN\n  return a.x;\n#else\n  return a.y\n#endif\n}\n",
        &[(5, "`PLAIN` is defined")],
    );
    check_found(
        "float f(vec3 a) {\n#if defined(A)\n#if MODE == 2\n  return a.xyw.x;\n#elif MODE == 3\n  return a;\n#endif\n#endif\n  return a.x;\n}\n",
        &[
            (4, "`A` is defined and `MODE` is 2"),
            (6, "`A` is defined and `MODE` is 3"),
        ],
    );
    // A shader may leave a switch to its users.
    check_found(
        "//#define ANIMATE\nvoid mainImage(out vec4 c, in vec2 p) {\n#ifdef ANIMATE\n  p += sin(0 + p);\n#endif\n  c = vec4(p, 0, 1);\n}\n",
        &[(4, "`ANIMATE` is defined")],
    );
}

#[test]
fn inactive_code_that_may_be_valid_is_not_reported() {
    for text in [
        // What the macro stands for is unknown.
        "float f(vec3 a) {\n#ifdef TINT\n  vec2 b = TINT(a) TINT;\n#endif\n  return a.x;\n}\n",
        "float f(vec3 a) {\n#if SIZE > 2\n  vec2 b = SIZE;\n#endif\n  return a.x;\n}\n",
        // Another group decides on the type.
        "#ifdef WIDE\n#define T vec3\n#else\n#define T vec2\n#endif\nfloat f(T a) {\n#ifdef TINT\n  return a.z;\n#endif\n  return a.x;\n}\n",
        "float f() {\n#ifdef WIDE\n  vec3 a = vec3(1);\n#else\n  vec2 a = vec2(1);\n#endif\n#ifdef TINT\n  return a.z;\n#endif\n  return a.x;\n}\n",
        // Code that nobody compiles, and an error on purpose.
        "float f(vec3 a) {\n#if 0\n  vec2 b = a;\n#endif\n  return a.x;\n}\n",
        "float f(vec3 a) {\n#ifdef OLD\n#error OLD is gone\n#endif\n  return a.x;\n}\n",
        // The compiler defines such names.
        "float f(vec3 a) {\n#ifdef GL_other\n  vec2 b = a;\n#endif\n  return a.x;\n}\n",
    ] {
        check_found(text, &[]);
    }
}

#[track_caller]
fn reserved_word(head: &str, word: &str) -> Severity {
    let text = format!(
        "{head}precision highp float;\nin vec2 v;\nout vec4 c;\nuniform sampler2D t;\n\
         void main() {{ vec4 {word} = texture(t, v); c = {word}; }}\n"
    );
    let report = check("a.frag", &text, &Options::default(), &NoFiles);
    let mut found = report.diagnostics.iter();
    let found = found.find(|d| d.is(error::RESERVED_WORD));
    found.map(|d| d.severity).expect("the word is reserved")
}

#[test]
fn words_reserved_in_one_version_only_are_warnings() {
    assert_eq!(reserved_word("", "sample"), Severity::Warning);
    assert_eq!(
        reserved_word("#version 300 es\n", "sample"),
        Severity::Error
    );
    // Both versions reserve it.
    assert_eq!(reserved_word("", "cast"), Severity::Error);
}
