//! `// shaderlint: allow(rule) reason`.

use crate::scratch::Scratch;

/// The findings in the body of a shader.
fn found(body: &str) -> Vec<String> {
    let code =
        format!("void mainImage(out vec4 c, in vec2 p) {{\nc = vec4(p, 0.0, 1.0);\n{body}\n}}\n");
    Scratch::new(&[("a.glsl", &code)]).places(&["a.glsl"])
}

const POW: &str = "c += pow(iTime - 9.0, 2.0);";

#[test]
fn a_trailing_comment_applies_to_its_line() {
    assert_eq!(found(POW), ["3:10 pow-negative-base"]);
    let allowed = format!("{POW} // shaderlint: allow(pow-negative-base) it is squared");
    assert_eq!(found(&allowed), [""; 0]);
    let next = format!("{allowed}\n{POW}");
    assert_eq!(found(&next), ["4:10 pow-negative-base"]);
    let block = format!("{POW} /* shaderlint: allow(pow-negative-base) */");
    assert_eq!(found(&block), [""; 0]);
}

#[test]
fn a_comment_on_its_own_line_applies_to_the_next_statement() {
    let over = format!("// shaderlint: allow(pow-negative-base)\n\n{POW}\n{POW}");
    assert_eq!(found(&over), ["6:10 pow-negative-base"]);
    let block =
        format!("// shaderlint: allow(numeric)\nif (p.x > 0.0) {{\n{POW}\n{POW}\n}}\n{POW}");
    assert_eq!(found(&block), ["8:10 pow-negative-base"]);
    let function = "// shaderlint: allow(pow-negative-base) known\nfloat f(float x) {\n    return pow(x - 9.0, 2.0);\n}\n\
        void mainImage(out vec4 c, in vec2 p) { c = vec4(f(iTime)); }\n";
    assert_eq!(
        Scratch::new(&[("a.glsl", function)]).places(&["a.glsl"]),
        [""; 0]
    );
}

#[test]
fn rules_can_be_allowed_for_a_file() {
    let file = format!("{POW}\n// shaderlint: allow-file(pow-negative-base) measured\n{POW}");
    assert_eq!(found(&file), [""; 0]);
}

#[test]
fn unused_suppressions_are_reported() {
    let unused = "c *= 2.0; // shaderlint: allow(pow-negative-base)";
    assert_eq!(found(unused), ["3:32 unused-allow"]);
    let one_of_two = format!("{POW} // shaderlint: allow(pow-negative-base, float-equality)");
    assert_eq!(found(&one_of_two), ["3:69 unused-allow"]);
    let misspelled = format!("{POW} // shaderlint: allow(pow-negativ-base)");
    assert_eq!(
        found(&misspelled),
        ["3:10 pow-negative-base", "3:50 unused-allow"]
    );
    for (order, place) in [
        ("shaderlint: alow(pow-negative-base)", "3:14 unused-allow"),
        ("shaderlint: allow pow-negative-base", "3:14 unused-allow"),
        ("shaderlint: allow()", "3:26 unused-allow"),
        ("shaderlint: allow", "3:14 unused-allow"),
        ("shaderlint: permit", "3:26 unused-allow"),
        ("shaderlint-disable-line", "3:14 unused-allow"),
        ("shaderlint allow(look)", "3:14 unused-allow"),
    ] {
        let lines = found(&format!("c *= 2.0; // {order}"));
        assert_eq!(lines, [place], "{order}");
    }
    assert_eq!(found("c *= 2.0; // eslint-disable-line"), [""; 0]);
}

#[test]
fn misspelled_suppressions_are_fixed() {
    let code = |first: &str, second: &str| {
        format!(
            "void mainImage(out vec4 c, in vec2 p) {{\n    c = vec4(pow(iTime - 9.0, 2.0)); // {first}\n    \
             // {second}\n    c *= p.x * 0.1 == 0.3 ? 1.0 : 2.0;\n}}\n"
        )
    };
    let wrong = code(
        "shaderlint-disable-line",
        "shaderlint ignore(float_equality) known",
    );
    let scratch = Scratch::new(&[("a.glsl", &wrong)]);
    let ran = scratch.run(&["-q", "--fix", "a.glsl"]);
    assert_eq!((ran.code, ran.out.as_str()), (0, ""));
    let right = code(
        "shaderlint: allow(pow-negative-base)",
        "shaderlint: allow(float-equality) known",
    );
    assert_eq!(scratch.read("a.glsl"), right);
}

#[test]
fn suppressions_of_disabled_rules_are_not_unused() {
    let code = "// shaderlint: allow-file(unused-parameter, pow-negative-base)\n\
        void mainImage(out vec4 c, in vec2 p) { c = vec4(pow(iTime - 9.0, 2.0)); }\n";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    assert_eq!(scratch.places(&["a.glsl"]), [""; 0]);
    assert_eq!(scratch.places(&["--ignore", "numeric", "a.glsl"]), [""; 0]);
    assert_eq!(
        scratch
            .places(&["--select", "unused-parameter", "a.glsl"])
            .len(),
        1
    );
}

#[test]
fn compile_errors_cannot_be_allowed() {
    let body = "float x = 1; // shaderlint: allow(int-float-mix)";
    assert!(
        found(body).contains(&"3:11 int-float-mix".to_string()),
        "{:?}",
        found(body)
    );
    let body = "c *= 2.0; // shaderlint: allow(int-float-mix)";
    assert_eq!(found(body), ["3:32 unused-allow"]);
}

#[test]
fn suppressions_work_in_pages_and_exports() {
    let line = "void mainImage(out vec4 c, in vec2 p) { c = vec4(pow(iTime - 9.0, 2.0)); }";
    let allow = "// shaderlint: allow(pow-negative-base) known";
    let page = |line: &str| format!("const s = /* glsl */ `\n{line}\n`;\n");
    let export = |line: &str| {
        let pass = serde_json::json!({"type": "image", "name": "Image", "code": line, "inputs": [], "outputs": []});
        serde_json::json!({"info": {"name": "x"}, "renderpass": [pass]}).to_string()
    };
    let allowed = format!("{line} {allow}");
    let scratch = Scratch::new(&[
        ("a.js", &page(line)),
        ("b.js", &page(&allowed)),
        ("a.json", &export(line)),
        ("b.json", &export(&allowed)),
    ]);
    for (file, count) in [("a.js", 1), ("b.js", 0), ("a.json", 1), ("b.json", 0)] {
        assert_eq!(scratch.places(&[file]).len(), count, "{file}");
    }
}

#[test]
fn the_fix_removes_unused_suppressions() {
    let code = "// kept\n// shaderlint: allow(pow-negative-base) once\n\
        void mainImage(out vec4 c, in vec2 p) {\n    c = vec4(1.0); // shaderlint: allow(numeric)\n}\n";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    assert_eq!(scratch.run(&["--fix", "a.glsl"]).code, 0);
    let fixed = "// kept\nvoid mainImage(out vec4 c, in vec2 p) {\n    c = vec4(1.0);\n}\n";
    assert_eq!(scratch.read("a.glsl"), fixed);
}

#[test]
fn expected_errors_are_not_reported() {
    let expected = "c = vec4(q); // shaderlint: expect(undeclared-name) this tests the compiler";
    assert_eq!(found(expected), [""; 0]);
    let over = "// shaderlint: expect(undeclared-name)\nc = vec4(q);\nc = vec4(r);";
    assert_eq!(found(over), ["5:10 undeclared-name"]);
    let removed = "c = vec4(1.0); // shaderlint: expect(undeclared-name)";
    assert_eq!(found(removed), ["3:38 unused-allow"]);
    let file = "// shaderlint: expect-file(undeclared-name)\nc = vec4(q) + vec4(r);";
    assert_eq!(found(file), [""; 0]);
}
