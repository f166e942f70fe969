//! A misspelt entry function, in any text.

use crate::scratch::Scratch;

/// The findings of a shader in a file, in a script and in a document, without the lines before it.
#[track_caller]
fn check(shader: &str, expected: &[&str]) {
    let script = format!("const fs =\n`{shader}`;\ngl.shaderSource(s, fs);\n");
    let document = format!("\n```glsl\n{shader}```\n");
    for (name, text, lines) in [
        ("a.frag", shader.to_string(), 0),
        ("a.js", script, 1),
        ("a.md", document, 2),
    ] {
        let found = Scratch::new(&[(name, &text)]).places(&[name]);
        let found: Vec<String> = found.iter().map(|place| moved(place, lines)).collect();
        let expected = expected
            .iter()
            .filter(|e| name == "a.frag" || !e.contains("warning"));
        assert!(found.iter().eq(expected), "{name}: {found:?}\n{text}");
    }
}

/// A finding `line:column rule` without the column, as many lines earlier.
fn moved(place: &str, lines: usize) -> String {
    let (line, rest) = place.split_once(':').unwrap();
    let rule = rest.split_once(' ').unwrap().1;
    format!("{} {rule}", line.parse::<usize>().unwrap() - lines)
}

#[test]
fn an_entry_function_with_a_typo_is_an_error() {
    let body = "{\n    gl_FragColor = vec4(1.0);\n}\n";
    for header in ["void mian()", "void Main()", "void amin(void)"] {
        check(
            &format!("precision highp float;\n{header} {body}"),
            &["2 missing-main"],
        );
    }
    for name in ["mainimage", "mianImage"] {
        let shader = format!("void {name}(out vec4 c, in vec2 p) {{\n    c = p.xyxy;\n}}\n");
        check(&shader, &["1 missing-main"]);
    }
}

#[test]
fn capitals_and_other_languages_are_errors() {
    check(
        "#version 300 es\nprecision highp float;\nOut vec4 c;\nVoid main() {\n    Float x = 1.0;\n    c = vec4(x);\n}\n",
        &["3 syntax-error", "4 syntax-error", "5 unknown-type"],
    );
    check(
        "function mainImage(c, p) {\n    c = vec4(p, 0.0, 1.0);\n}\n",
        &["1 foreign-syntax"],
    );
    check(
        "Void mainImage(out vec4 c, in vec2 p) {\n    c = vec4(p, 0.0, 1.0);\n}\n",
        &["1 syntax-error"],
    );
}

#[test]
fn functions_of_shader_fragments_need_no_main() {
    for text in [
        "varying vec2 v;\nvoid rain() { gl_FragColor.rg += v; }\n",
        "varying vec2 v;\nvoid mian() { gl_FragColor.rg += v; }\nvoid other() { mian(); }\n",
        "float mian() { return 1.0; }\n",
    ] {
        let found = Scratch::new(&[("a.glsl", text)]).places(&["a.glsl"]);
        assert!(
            found.iter().all(|f| !f.contains("missing-main")),
            "{found:?}\n{text}"
        );
    }
}

#[test]
fn unknown_words_before_a_declaration_may_be_qualifiers_of_a_host() {
    let shader = "IN vec2 uv;\nUNI sampler2D map;\nvoid main() {\n    outColor = texture(map, uv);\n    float x = 1;\n}\n";
    let folder = Scratch::new(&[("a.frag", shader)]);
    assert_eq!(folder.places(&["a.frag"]), ["5:15 int-float-mix"]);
    let shown = folder.run(&["-v", "a.frag"]).err;
    assert!(
        shown.contains("names from the host: `IN`, `UNI`"),
        "{shown}"
    );
}
