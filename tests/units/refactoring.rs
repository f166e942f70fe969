//! Refactorings of a selection `«...»`, or at a position `|`.

use shaderlint::engine::Options;
use shaderlint::ide::{Document, refactorings};
use shaderlint::project::NoFiles;
use shaderlint::text::{Span, apply_edits};
use std::sync::Arc;

const HEAD: &str = "#version 300 es\nprecision highp float;\nout vec4 color;\nuniform float time;\nuniform sampler2D image;\n";

/// The document of a text without its marks, and the selection.
fn marked(name: &str, text: &str) -> (Document, Span) {
    let plain = text.replace(['«', '»', '|'], "");
    let start = text.find(['«', '|']).expect("a mark");
    let end = text.find('»').map_or(start, |end| end - '«'.len_utf8());
    let document = Document::new(name, plain.into(), Arc::new(Options::default()), &NoFiles);
    (document, Span::new(start as u32, end as u32))
}

/// The refactorings, by title: the changed text with the new name in «», and the new file.
fn offered_in(name: &str, text: &str) -> Vec<(String, String)> {
    let (document, selection) = marked(name, text);
    let all = refactorings(&document, &NoFiles, selection, |_| true);
    all.into_iter()
        .map(|r| {
            let mut text = apply_edits(&document.text, 0, &r.edits).unwrap();
            if let Some(at) = r.name {
                text.insert(at as usize, '¦');
            }
            let file = r.creates.map(|f| format!("--- {}\n{}", f.path, f.text));
            (r.title, text + &file.unwrap_or_default())
        })
        .collect()
}

fn offered(text: &str) -> Vec<(String, String)> {
    let all = offered_in("/a.frag", &format!("{HEAD}{text}"));
    let own = |text: String| text.strip_prefix(HEAD).unwrap_or(&text).to_string();
    all.into_iter()
        .map(|(title, text)| (title, own(text)))
        .collect()
}

#[track_caller]
fn check(text: &str, title: &str, expected: &str) {
    let all = offered(text);
    let found = all.iter().find(|(t, _)| t == title);
    assert_eq!(
        found.map(|(_, text)| text.as_str()),
        Some(expected),
        "{all:#?}"
    );
}

/// Checks that no refactoring with one of these words in its title is offered.
#[track_caller]
fn check_none(text: &str, words: &str) {
    let all = offered(text);
    assert!(
        all.iter().all(|(title, _)| !title.contains(words)),
        "{all:#?}"
    );
}

fn in_main(body: &str) -> String {
    format!("void main() {{\n    vec2 p = gl_FragCoord.xy;\n    {body}\n}}\n")
}

#[test]
fn unsuitable_selections_are_not_refactored() {
    let cases = include_str!("../../src/ide/refactor/none.txt").lines();
    for case in cases.filter(|case| !case.starts_with("# ")) {
        let (text, words) = case.split_once(" ‖ ").unwrap();
        let text = text.replace('↵', "\n");
        match text.strip_prefix("main: ") {
            Some(body) => check_none(&in_main(body), words),
            None => check_none(&text, words),
        }
    }
}

#[test]
fn selections_are_refactored() {
    let cases = include_str!("../../src/ide/refactor/cases.txt").lines();
    for case in cases.filter(|case| !case.starts_with("# ")) {
        let (before, rest) = case.split_once(" ‖ ").unwrap();
        let (title, after) = rest.split_once(" ⇒ ").unwrap();
        let [before, after] = [before, after].map(|text| text.replace('↵', "\n"));
        match before.strip_prefix("main: ") {
            Some(body) => check(&in_main(body), title, &in_main(&after)),
            None => check(&before, title, &after),
        }
    }
}

#[test]
fn webgl1_shaders_are_converted() {
    let old = "precision highp float;\nuniform sampler2D image;\n|void main() { gl_FragColor = texture2D(image, gl_FragCoord.xy / 64.0); }\n";
    let all = offered_in("/a.frag", old);
    let found = all
        .iter()
        .find(|(title, _)| title == "Convert to GLSL ES 3.00");
    let text = &found.expect("an offer").1;
    assert!(
        text.starts_with("#version 300 es\n") && text.contains("texture(image"),
        "{text}"
    );
}

/// Shaders in scripts and in exports.
#[test]
fn embedded_shaders_are_edited_in_place() {
    let script = "const text = `#version 300 es\nprecision highp float;\nout vec4 c;\nvoid main() {\n    c = vec4(«gl_FragCoord.x * 2.0»);\n}\n`;\n";
    let all = offered_in("/a.js", script);
    let found = all.iter().find(|(title, _)| title == "Extract to variable");
    let expected = "    float value = gl_FragCoord.x * 2.0;\n    c = vec4(¦value);\n";
    assert!(
        found.is_some_and(|(_, text)| text.contains(expected)),
        "{all:#?}"
    );
}

/// The text after a number became a uniform.
fn with_uniform(name: &str, text: &str) -> Option<String> {
    let all = offered_in(name, text);
    let is_it = |(title, _): &&(String, String)| title == "Extract to uniform with slider";
    all.iter().find(is_it).map(|(_, text)| text.clone())
}

#[test]
fn numbers_become_uniforms_that_the_host_sets() {
    let toy = |line: &str, number: &str| {
        format!(
            "#iChannel0 \"a.png\"\n{line}void mainImage(out vec4 c, in vec2 p) {{\n    c = vec4({number});\n}}\n"
        )
    };
    assert_eq!(
        with_uniform("/a.glsl", &toy("", "|0.3")),
        Some(toy(
            "#iUniform float value = 0.3 in { 0.0, 0.6 }\n",
            "¦value"
        ))
    );
    let isf = |inputs: &str, number: &str| {
        format!(
            "/*{{\n    \"ISFVSN\": \"2\",\n    \"INPUTS\": [{inputs}]\n}}*/\nvoid main() {{ gl_FragColor = vec4({number}); }}\n"
        )
    };
    let input = "\n        { \"NAME\": \"value\", \"TYPE\": \"float\", \"DEFAULT\": 0.3, \"MIN\": 0, \"MAX\": 0.6 }\n    ";
    assert_eq!(
        with_uniform("/a.fs", &isf("", "|0.3")),
        Some(isf(input, "¦value"))
    );
    // Other hosts leave the uniform at zero; an array size must be constant.
    assert_eq!(
        with_uniform(
            "/a.frag",
            "precision highp float;\nvoid main() { gl_FragColor = vec4(|0.3); }\n"
        ),
        None
    );
    let size = isf("", "1.0").replace("{ gl", "{ float b[|9]; gl");
    assert_eq!(with_uniform("/a.fs", &size), None);
}
