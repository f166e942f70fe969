//! A mistake of the text is one error, and its fix leaves none.

use super::super::tests::{check, found, main_with};

const TOP: &str = "float half_of(float x) { return 0.5 * x; }";

/// A shader with this code before the last statement of `main`.
#[track_caller]
fn in_main(code: &str, expected: &str) {
    let body = format!("float d = 0.5;\n    {code}\n    color = vec4(d);");
    check(&main_with(TOP, &body), expected);
}

/// A shader with this code before `main`.
#[track_caller]
fn at_top(code: &str, expected: &str) {
    check(&main_with(code, "color = vec4(0.5);"), expected);
}

#[test]
fn missing_spaces_are_found() {
    in_main("vec2p = vec2(d); d = p.x;", "4:5 syntax-error");
    in_main("floatk; k = d; d = k;", "4:5 syntax-error");
    in_main("if (d > 1.0) d = 0.0; elsed = 1.0;", "4:27 syntax-error");
    at_top("float f(float x) { returnx; }", "1:20 syntax-error");
    at_top("constvec2 A = vec2(0.0);", "1:1 syntax-error");
    at_top("float f(vec2p) { return p.x; }", "1:9 syntax-error");
    at_top(
        "structRay { vec3 o; };\nfloat f(Ray r) { return r.o.x; }",
        "1:1 syntax-error",
    );
}

#[test]
fn names_of_macros_are_not_calls() {
    let code = "#define abs absent_of\nfloat f(float x) { return abs(x); }";
    let found = found(&main_with(code, "color = vec4(0.5);"));
    assert_eq!(found.0, ["1:13 undeclared-name"]);
}

#[test]
fn html_entities_are_found() {
    in_main(
        "if (d &lt; 1.0 &amp;&amp; d &gt; 0.5) d = 0.0;",
        "4:11 invalid-character",
    );
    in_main(
        "for (int i = 0; i &lt; 4; i++) d += 0.1;",
        "4:23 invalid-character",
    );
    in_main(
        "if (d &gt;= 1.0) d = 0.0; // &quot;",
        "4:11 invalid-character",
    );
}

#[test]
fn comments_without_delimiters_are_found() {
    at_top("/ half of the value", "1:1 syntax-error");
    at_top("half of the given value", "1:1 syntax-error");
    at_top("* Half of the value,\n * rounded.\n */", "1:1 syntax-error");
    at_top("/* a /* b */ still here */", "1:25 syntax-error");
    at_top(
        "/* Half of the value\nfloat f(float x) { return x; }",
        "1:1 unterminated-comment",
    );
    in_main("d += 0.1; / brighter now", "4:15 syntax-error");
}

#[test]
fn merge_conflicts_and_pasted_diffs_are_found() {
    in_main(
        "<<<<<<< HEAD\nd = 0.1;\n=======\nd = 0.2;\n>>>>>>> other",
        "4:5 syntax-error",
    );
    at_top(
        "<<<<<<< a\nfloat f() { return 1.0; }\n||||||| b\n=======\nfloat f() { return 2.0; }\n>>>>>>> c",
        "1:1 syntax-error",
    );
    at_top(
        "```glsl\nfloat f() { return 1.0; }\n```",
        "1:1 syntax-error",
    );
    at_top(
        "float f() { return 1.0; }\nfloat f() { return 1.0; }",
        "2:7 redefinition",
    );
    in_main(
        "float f(float x) { return x; }\n    d = f(d);",
        "4:5 local-function",
    );
}

#[test]
fn notations_of_other_languages_are_found() {
    in_main("vec3 p(1, 2, 3); d = p.x;", "4:10 foreign-syntax");
    in_main("float k = 1.0.0; d = k;", "4:15 invalid-number");
    in_main("d = sin(π * d);", "4:13 invalid-character");
    in_main(
        "float k = 1.0 if d < 0.5 else 0.0; d = k;",
        "4:15 foreign-syntax",
    );
    in_main("vec2 v = vec2(d); d = v[x];", "4:28 foreign-syntax");
    in_main("d = half_of(float d);", "4:17 syntax-error");
}

#[test]
fn pointers_and_references_are_found() {
    at_top("void grow(vec2& p) { p *= 2.0; }", "1:15 foreign-syntax");
    at_top(
        "float area(const vec2 &p) { return p.x * p.y; }",
        "1:23 foreign-syntax",
    );
    at_top(
        "void grow(float *x) { *x *= 2.0; }\nvoid both(float a) { grow(&a); }",
        "1:17 foreign-syntax",
    );
}

#[test]
fn constructs_of_other_languages_are_found() {
    in_main("int c = 'a'; d = float(c);", "4:13 invalid-character");
    in_main("char c = '!'; d = float(c);", "4:14 invalid-character");
    in_main(
        "float w[2] = float[2](0.1, 0.2);\n    for (float x : w) { d += x; }",
        "5:5 foreign-syntax",
    );
    in_main(
        "foreach (int k in 3) { d += float(k); }",
        "4:5 foreign-syntax",
    );
    at_top("buffer Data { vec4 a; } data;", "1:1 foreign-syntax");
    at_top(
        "layout(std430, binding = 1) buffer Data { vec4 a; } data;",
        "1:29 foreign-syntax",
    );
    at_top("import { a, b } from \"./a.glsl\";", "1:1 foreign-syntax");
    at_top(
        "the distance; see below\n * of a point\n */",
        "1:1 syntax-error",
    );
}

#[test]
fn spaces_inside_tokens_are_found() {
    in_main("d = smooth step(0.0, 1.0, d);", "4:9 syntax-error");
    in_main("vec 2 p = vec2(d); d = p.x;", "4:5 syntax-error");
    in_main("if (d > = 0.5) d = 0.0;", "4:11 syntax-error");
    in_main("d + = 0.5;", "4:7 syntax-error");
    in_main("d = half _of(d);", "4:9 syntax-error");
}

#[test]
fn remains_of_pasting_are_found() {
    in_main("d = 0.1;\\n    d += 0.2;", "4:13 invalid-character");
    in_main("d = 0.1; 🎨", "4:14 invalid-character");
    in_main(
        "if (d &amp;lt; 0.5 &amp;amp;&amp;amp; d &gt 0.1) d = 0.0;",
        "4:11 invalid-character",
    );
    at_top("https://example.org/a", "1:1 syntax-error");
    at_top(
        "Ray { vec3 o; };\nfloat f(Ray r) { return r.o.x; }",
        "1:1 syntax-error",
    );
    in_main("d = 1.0e;", "4:9 invalid-number");
}

#[test]
fn missing_braces_before_else_are_found() {
    in_main(
        "if (d > 0.2)\n    d = 0.1;\n    d += sin(d);\nelse\n    d = 0.3;",
        "7:1 syntax-error",
    );
    in_main(
        "if (d > 0.2) d = 0.1; d += 0.2; else d = 0.3;",
        "4:37 syntax-error",
    );
}

#[test]
fn functions_of_other_languages_are_found() {
    at_top("function f(x) { return sin(x); }", "1:1 foreign-syntax");
    at_top("sub f(a, b) { return a * b.xyz; }", "1:1 foreign-syntax");
    at_top("auto f(vec2 p) { return p.yx; }", "1:1 foreign-syntax");
    at_top(
        "proc f(vec2 p)\n{\n    return vec3(p, 1.0);\n}",
        "1:1 foreign-syntax",
    );
    in_main(
        "auto k = [](float x) { return 0.5 * x; }; d = k(d);",
        "4:14 foreign-syntax",
    );
    in_main("const k = (x) => x * x; d = k(d);", "4:15 foreign-syntax");
    in_main(
        "var k = [&](vec2 p, float s) -> vec2 { return p * s; }; d = k(vec2(d), 2.0).x;",
        "4:13 foreign-syntax",
    );
    at_top("const f = (x) => x * x;", "1:11 foreign-syntax");
}

#[test]
fn blocks_of_other_languages_are_found() {
    in_main(
        "loop { d += 0.1; if (d > 1.0) break; }",
        "4:5 foreign-syntax",
    );
    in_main(
        "try { d = 1.0; } catch (e) { d = 0.0; }",
        "4:5 foreign-syntax",
    );
    in_main(
        "try {\n        d = 1.0;\n    } except {\n        d = 0.0;\n    }",
        "4:5 foreign-syntax",
    );
    in_main("unless (d > 1.0) d = 0.5;", "4:5 foreign-syntax");
    in_main("if (d > 1.0) { d = 0.5; end", "4:29 foreign-syntax");
    in_main(
        "for (int i = 0; i < 4; i++) { d += 0.5; done",
        "4:45 foreign-syntax",
    );
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

#[test]
fn misplaced_words_and_operators_are_found() {
    in_main("d = this.d + 1.0;", "4:9 reserved-word");
    in_main("float k <- 2.0; d *= k;", "4:13 syntax-error");
    in_main("vec2 q <- vec2(d); d = q.x;", "4:12 syntax-error");
    in_main("float my-value = 2.0; d *= my-value;", "4:11 syntax-error");
    in_main("float = 2.0; d *= scale;", "4:11 syntax-error");
    in_main("vec2 = vec2(d); d = size.x + size.y;", "4:10 syntax-error");
    at_top(
        "void f(ouput vec4 c) { c = vec4(1.0); }",
        "1:8 syntax-error",
    );
    at_top("void f(float x, inn vec4 c) { }", "1:17 syntax-error");
    in_main("float &k = d; k += 1.0; d = k;", "4:11 foreign-syntax");
    in_main("d *= 2.0px;", "4:10 invalid-number");
    in_main("d = sin(45.0deg);", "4:13 invalid-number");
    in_main("d = max(d, 1.5em);", "4:16 invalid-number");
    at_top(
        "struct Ray { vec3 o = vec3(0.0); vec3 d; };",
        "1:21 foreign-syntax",
    );
    at_top("precision float mediump;", "1:11 syntax-error");
    in_main("d =* 0.5;", "4:7 syntax-error");
    in_main("d =/ half_of(d);", "4:7 syntax-error");
    in_main("d **= 2.0;", "4:7 foreign-syntax");
    in_main(
        "vec3 q = vec3(d); q **= 2.0; d = q.x;",
        "4:25 foreign-syntax",
    );
    in_main("vec2 q = vec2(d); d = sin q.x + 1.0;", "4:27 syntax-error");
    in_main("d = abs d - 1.0;", "4:9 syntax-error");
    in_main("discard(d);", "4:12 syntax-error");
    in_main("if (not d > 0.5) d = 1.0;", "4:9 foreign-syntax");
    in_main(
        "if (d < 0.1 || not half_of(d) > 0.5) d = 1.0;",
        "4:20 foreign-syntax",
    );
    in_main("d *= \"0.5\";", "4:10 invalid-character");
    in_main("d = max(d, \"2\");", "4:16 invalid-character");
}
