//! Refactorings of a selection `«...»`, or at a position `|`.

use super::*;
use shaderlint_engine::Options;
use shaderlint_project::NoFiles;
use shaderlint_text::apply_edits;
use std::sync::Arc;

const HEAD: &str = "#version 300 es\nprecision highp float;\nout vec4 color;\nuniform float time;\nuniform sampler2D image;\n";

/// The document of a text without its marks, and the selection.
pub(super) fn marked(name: &str, text: &str) -> (Document, Span) {
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
fn selections_are_refactored() {
    let cases = include_str!("cases.txt").lines();
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
fn expressions_whose_value_would_change_are_not_extracted() {
    let none = |body: &str| check_none(&in_main(body), "to variable");
    // Changes in the loop.
    none(
        "float t = 0.0; for (int i = 0; i < int(«t * 2.0» + 4.0); i++) t += 1.0; color = vec4(t);",
    );
    // Short circuit, and derivatives in a branch.
    none("int n = 0; bool b = p.x > 1.0 && «n++» > 0; color = vec4(b) * float(n);");
    none("color = p.x > 1.0 ? «texture(image, p)» : vec4(0);");
    // Written before the expression is evaluated.
    none("float t = 1.0; color = vec4((t += 1.0) + «t * 2.0»);");
    // A part of the operands, and the target of an assignment.
    none("color = vec4(p.x + «p.y + time»);");
    none("vec3 v = vec3(1.0); «v.x» = 2.0; color = v.xyzz;");
    // In the body of a macro, and a part of a call.
    check_none(
        &format!(
            "#define TWICE(x) («x * 2.0»)\n{}",
            in_main("color = vec4(TWICE(p.x));")
        ),
        "Extract",
    );
}

#[test]
fn extracted_constants_are_global() {
    check(
        &format!("// The entry.\n{}", in_main("color = vec4(«2.0 * 3.0»);")),
        "Extract to constant",
        &format!(
            "const float VALUE = 2.0 * 3.0;\n// The entry.\n{}",
            in_main("color = vec4(¦VALUE);")
        ),
    );
    check(
        &in_main("color = vec4(«0.25»);"),
        "Extract to constant with slider",
        &format!(
            "const float VALUE = 0.25; // (0~0.5)\n{}",
            in_main("color = vec4(¦VALUE);")
        ),
    );
    check_none(&in_main("color = vec4(«time * 2.0»);"), "constant");
}

#[test]
fn code_is_extracted_to_functions() {
    check(
        &in_main("color = vec4(«sin(p.x * time)»);"),
        "Extract to function",
        &format!(
            "float extracted(vec2 p) {{\n    return sin(p.x * time);\n}}\n\n{}",
            in_main("color = vec4(¦extracted(p));")
        ),
    );
    check(
        &in_main(
            "float t = 0.0;\n    «for (int i = 0; i < 4; i++) {\n        if (p.x > 2.0) break;\n        t += p.y;\n    }\n    p *= 2.0;»\n    color = vec4(t, p, 1);",
        ),
        "Extract to function",
        &format!(
            "void extracted(inout vec2 p, inout float t) {{\n    for (int i = 0; i < 4; i++) {{\n        if (p.x > 2.0) break;\n        t += p.y;\n    }}\n    p *= 2.0;\n}}\n\n{}",
            in_main("float t = 0.0;\n    ¦extracted(p, t);\n    color = vec4(t, p, 1);")
        ),
    );
    check(
        &in_main("«float a = p.x;\n    a *= time;»\n    color = vec4(a);"),
        "Extract to function",
        &format!(
            "float extracted(vec2 p) {{\n    float a = p.x;\n    a *= time;\n    return a;\n}}\n\n{}",
            in_main("float a = ¦extracted(p);\n    color = vec4(a);")
        ),
    );
    // A value that the next iteration reads.
    check(
        &in_main("float t = 0.0; for (int i = 0; i < 4; i++) { color = vec4(t); «t += p.x;» }"),
        "Extract to function",
        &format!(
            "void extracted(inout float t, vec2 p) {{\n    t += p.x;\n}}\n\n{}",
            in_main(
                "float t = 0.0; for (int i = 0; i < 4; i++) { color = vec4(t); ¦extracted(t, p); }"
            )
        ),
    );
    // Several results.
    check(
        &in_main("«float a = p.x;\n    float b = a * time;»\n    color = vec4(a, b, 1, 1);"),
        "Extract to function",
        &format!(
            "void extracted(vec2 p, out float a, out float b) {{\n    a = p.x;\n    b = a * time;\n}}\n\n{}",
            in_main(
                "float a;\n    float b;\n    ¦extracted(p, a, b);\n    color = vec4(a, b, 1, 1);"
            )
        ),
    );
    // Jumps out of the code, and results of one declaration.
    let none = |body: &str| check_none(&in_main(body), "to function");
    none("for (int i = 0; i < 4; i++) { «if (p.x > 1.0) break;» color = vec4(i); }");
    none("«if (p.x > 1.0) return;»\n    color = vec4(1);");
    none("«float a = p.x, b = p.y;» color = vec4(a, b, 1, 1);");
    none("color = vec4(«p.x += 1.0»);");
}

#[test]
fn variables_functions_and_macros_are_inlined() {
    check(
        &in_main("float |a = p.x + 1.0;\n    color = vec4(a, a * 2.0, 1, 1);"),
        "Inline variable `a`",
        &in_main("color = vec4(p.x + 1.0, (p.x + 1.0) * 2.0, 1, 1);"),
    );
    check(
        &format!(
            "float twice(float x) {{ return x + x; }}\n{}",
            in_main("color = vec4(|twice(p.x * 2.0) * 3.0);")
        ),
        "Inline call of `twice`",
        &format!(
            "float twice(float x) {{ return x + x; }}\n{}",
            in_main("color = vec4((p.x * 2.0 + p.x * 2.0) * 3.0);")
        ),
    );
    check(
        &format!(
            "float |twice(float x) {{ return x + x; }}\n{}",
            in_main("color = vec4(twice(p.x), twice(p.y), 1, 1);")
        ),
        "Inline function `twice`",
        &in_main("color = vec4(p.x + p.x, p.y + p.y, 1, 1);"),
    );
    // Parentheses where the order of operations needs them.
    check(
        &in_main("float |a = p.x - 1.0;\n    color = vec4(2.0 - a, a - 2.0, -a, a * 2.0);"),
        "Inline variable `a`",
        &in_main(
            "color = vec4(2.0 - (p.x - 1.0), p.x - 1.0 - 2.0, -(p.x - 1.0), (p.x - 1.0) * 2.0);",
        ),
    );
    let none = |body: &str| check_none(&in_main(body), "Inline");
    // Its operand changes, it is written, or it is evaluated elsewhere.
    none("float |a = p.x + 1.0; p.x = 2.0; color = vec4(a);");
    none("float |a = p.x; a += 1.0; color = vec4(a);");
    none("vec4 |a = texture(image, p); if (p.x > 1.0) color = a;");
    // A name of the function is another one at the call.
    check_none(
        &format!(
            "float k = 2.0; float f(float x) {{ return x * k; }}\n{}",
            in_main("float k = 3.0; color = vec4(|f(p.x) + k);")
        ),
        "Inline",
    );
    // An argument with a side effect.
    check_none(
        &format!(
            "float f(float x) {{ return x * x; }}\n{}",
            in_main("color = vec4(|f(p.x++), p, 1);")
        ),
        "Inline",
    );
}

#[test]
fn macros_and_constants_convert_into_each_other() {
    check(
        &format!(
            "#define |SPEED 0.5 // (0~1)\n{}",
            in_main("color = vec4(SPEED);")
        ),
        "Convert macro `SPEED` to a constant",
        &format!(
            "const float SPEED = 0.5; // (0~1)\n{}",
            in_main("color = vec4(SPEED);")
        ),
    );
    check(
        &format!(
            "const float |SPEED = 0.5 + 1.0;\n{}",
            in_main("color = vec4(SPEED * 2.0);")
        ),
        "Convert constant `SPEED` to a macro",
        &format!(
            "#define SPEED (0.5 + 1.0)\n{}",
            in_main("color = vec4(SPEED * 2.0);")
        ),
    );
    // A part of an expression, and a test of the preprocessor.
    check_none(
        &format!("#define |SUM 0.5 +\n{}", in_main("color = vec4(SUM 1.0);")),
        "Convert",
    );
    check_none(
        &format!(
            "#define |HIGH 1\n#if HIGH\n#define SIZE 2.0\n#endif\n{}",
            in_main("color = vec4(SIZE * float(HIGH));")
        ),
        "Convert",
    );
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

#[test]
fn functions_move_to_new_files() {
    check(
        &format!(
            "// Twice.\nfloat |twice(float x) {{\n    return x * 2.0;\n}}\n{}",
            in_main("color = vec4(twice(p.x));")
        ),
        "Move `twice` to `twice.glsl`",
        &format!(
            "#include \"twice.glsl\"\n{}--- /twice.glsl\n// Twice.\nfloat twice(float x) {{\n    return x * 2.0;\n}}\n",
            in_main("color = vec4(twice(p.x));")
        ),
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
