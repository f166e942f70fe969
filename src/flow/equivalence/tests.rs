//! Pairs of shaders that compute the same, and pairs that do not.

use super::*;
use crate::test_shader::checked;
use crate::{Calls, Effects, Writes};
use shaderlint_ir::lower;
use shaderlint_semantic::{Mentions, Structure};

const MAIN: &str = "void mainImage(out vec4 c, in vec2 p) {";

/// Whether two bodies, each after code of its own, are proved to be equivalent.
#[track_caller]
fn check(before: [&str; 2], after: [&str; 2], expected: bool) {
    let texts = [before, after].map(|[code, body]| format!("{code}\n{MAIN}\n{body}\n}}\n"));
    let checked = texts.each_ref().map(|text| checked(text));
    let modules = checked.each_ref().map(|c| lower(&c.program));
    let effects: Vec<Effects> = checked
        .iter()
        .zip(&modules)
        .map(|(c, module)| {
            let program = &c.program;
            let writes = Writes::of(program, module, &Mentions::of(program));
            let calls = Calls::of(module);
            Effects::of(program, module, &Structure::of(program), &calls, &writes)
        })
        .collect();
    let version = |at: usize| ShaderVersion {
        program: &checked[at].program,
        module: &modules[at],
        effects: &effects[at],
        entry: None,
    };
    let found = is_equivalent(version(0), version(1));
    assert_eq!(found, expected, "{}\n{}", texts[0], texts[1]);
}

#[test]
fn temporary_variables_do_not_matter() {
    check(
        ["", "c = vec4(sin(p.x * 2.0) + p.y);"],
        [
            "",
            "float a = p.x * 2.0; float b = sin(a); c = vec4(b + p.y);",
        ],
        true,
    );
    check(
        ["", "c = vec4(sin(p.x * 2.0));"],
        ["", "c = vec4(sin(p.x * 2.5));"],
        false,
    );
    // The value between two writes.
    check(
        ["", "float x = p.x; x += 1.0; c = vec4(x * 2.0); x = 0.0;"],
        [
            "",
            "float x = p.x; x += 1.0; float v = x * 2.0; x = 0.0; c = vec4(v);",
        ],
        true,
    );
    check(
        ["", "float x = p.x; x += 1.0; c = vec4(x * 2.0);"],
        [
            "",
            "float x = p.x; float v = x * 2.0; x += 1.0; c = vec4(v);",
        ],
        false,
    );
    // Constants are folded.
    check(
        ["", "float k = 2.0; c = vec4(k * 3.0 * p.x);"],
        ["", "c = vec4(2.0 * 3.0 * p.x);"],
        true,
    );
}

#[test]
fn functions_that_only_one_version_declares_are_inlined() {
    check(
        ["", "float d = p.x; d *= 2.0; d += p.y; c = vec4(d);"],
        [
            "void f(inout float d, vec2 p) { d *= 2.0; d += p.y; }",
            "float d = p.x; f(d, p); c = vec4(d);",
        ],
        true,
    );
    check(
        [
            "",
            "float d = 0.0; for (int i = 0; i < 4; i++) { d += p.x; if (d > 2.0) break; } c = vec4(d);",
        ],
        [
            "float f(vec2 p) { float d = 0.0; for (int i = 0; i < 4; i++) { d += p.x; if (d > 2.0) break; } return d; }",
            "float d = f(p); c = vec4(d);",
        ],
        true,
    );
    check(
        ["float g = 1.0;", "g += p.x; c = vec4(g);"],
        [
            "float g = 1.0; float f(float x) { g = 2.0; return x; }",
            "g += f(p.x); c = vec4(g);",
        ],
        false,
    );
}

/// Both have the function, but only one calls it.
#[test]
fn calls_that_only_one_version_has_are_inlined() {
    let twice = "float twice(float x) { return x + x; }";
    check(
        [twice, "c = vec4(twice(p.x * 2.0) + twice(p.y));"],
        [twice, "c = vec4(p.x * 2.0 + p.x * 2.0 + twice(p.y));"],
        true,
    );
    check(
        [twice, "c = vec4(twice(p.x * 2.0) + twice(p.y));"],
        [twice, "c = vec4(p.x * 2.0 + p.x + twice(p.y));"],
        false,
    );
}

/// A function stays pure if part of it moves to a function that is not.
#[test]
fn a_function_that_calls_a_new_helper_stays_pure() {
    let body = "p = vec2(dot(p, vec2(1.0)), 2.0);";
    check(
        [
            &format!("float h(vec2 p) {{ {body} return p.x; }}"),
            "c = vec4(h(p));",
        ],
        [
            &format!("void e(inout vec2 p) {{ {body} }} float h(vec2 p) {{ e(p); return p.x; }}"),
            "c = vec4(h(p));",
        ],
        true,
    );
}

#[test]
fn equivalent_loop_bodies_are_recognised() {
    let around = |body: &str| {
        format!("float t = 0.0; for (int i = 0; i < 9; i++) {{ {body} }} c = vec4(t);")
    };
    let [first, second, third, fourth] = [
        "float d = length(p * t); t += d; if (d < 0.1) break;",
        "float k = length(p * t); float d = k; t += d; if (d < 0.1) break;",
        "float d = length(p * t); if (d < 0.1) break; t += d;",
        "float d = length(p * t); t += d; if (d < 0.2) break;",
    ]
    .map(around);
    check(["", &first], ["", &second], true);
    check(["", &first], ["", &third], false);
    check(["", &first], ["", &fourth], false);
    let called = around("float d = f(p, t); t += d; if (d < 0.1) break;");
    let function = "float n = 0.0; float f(vec2 p, float t) { return length(p * t); }";
    check(["float n = 0.0;", &first], [function, &called], true);
    // A value that does not change is the same before the loop; one that changes is not.
    check(
        [
            "",
            "float t = 1.0; for (int i = 0; i < 9; i++) t += p.x * 2.0; c = vec4(t);",
        ],
        [
            "",
            "float t = 1.0; float v = p.x * 2.0; for (int i = 0; i < 9; i++) t += v; c = vec4(t);",
        ],
        true,
    );
    check(
        [
            "",
            "float t = 1.0; for (int i = 0; i < 9; i++) t += t * 2.0; c = vec4(t);",
        ],
        [
            "",
            "float t = 1.0; float v = t * 2.0; for (int i = 0; i < 9; i++) t += v; c = vec4(t);",
        ],
        false,
    );
}

/// Derivatives depend on the control flow around them, as do side effects.
#[test]
fn positions_matter_for_derivatives_and_effects() {
    let lookup = "texture(iChannel0, p).x";
    check(
        [
            "",
            &format!("float x = 0.0; if (p.x > 1.0) x = {lookup}; c = vec4(x);"),
        ],
        [
            "",
            &format!("float x = 0.0; float v = {lookup}; if (p.x > 1.0) x = v; c = vec4(x);"),
        ],
        false,
    );
    check(
        ["", "vec4 a = texture(iChannel0, p); if (p.x > 1.0) c = a;"],
        ["", "if (p.x > 1.0) c = texture(iChannel0, p);"],
        false,
    );
    check(
        ["", &format!("c = vec4(p.x + {lookup});")],
        ["", &format!("float v = {lookup}; c = vec4(p.x + v);")],
        true,
    );
    check(
        ["", "if (p.x > 1.0) discard; c = vec4(1.0);"],
        ["", "if (p.x > 2.0) discard; c = vec4(1.0);"],
        false,
    );
    let count = "float n = 0.0; float f() { n += 1.0; return n; }";
    check(
        [count, "float a = f(); float b = f(); c = vec4(a - b);"],
        [count, "float b = f(); float a = f(); c = vec4(a - b);"],
        false,
    );
    let cut = "float f(float x) { if (x > 1.0) discard; return 1.0; }";
    check(
        [cut, "f(p.x); c = vec4(1.0);"],
        [cut, "c = vec4(1.0);"],
        false,
    );
    check(
        [cut, "if (p.y > 2.0) c = vec4(f(p.x));"],
        [cut, "float v = f(p.x); if (p.y > 2.0) c = vec4(v);"],
        false,
    );
    // A global variable that only one branch writes.
    let set = "float n = 0.0; void f(float x) { if (x > 1.0) n = x; }";
    check(
        [set, "f(p.x); c = vec4(n);"],
        [&set.replace("n = x", "n = x * 2.0"), "f(p.x); c = vec4(n);"],
        false,
    );
    check(
        [count, "c = vec4(f() + f());"],
        [count, "float v = f(); c = vec4(v + v);"],
        false,
    );
}

/// A variable, a parameter or a result with less precision rounds the value.
#[test]
fn reduced_precision_is_a_difference() {
    let original = ["", "c = vec4(p.x * 2.0 + 1.0);"];
    check(
        original,
        ["", "highp float v = p.x * 2.0; c = vec4(v + 1.0);"],
        true,
    );
    check(
        original,
        ["", "mediump float v = p.x * 2.0; c = vec4(v + 1.0);"],
        false,
    );
    check(
        original,
        [
            "mediump float f(float x) { return x * 2.0; }",
            "c = vec4(f(p.x) + 1.0);",
        ],
        false,
    );
    check(
        original,
        [
            "float f(mediump float x) { return x * 2.0; }",
            "c = vec4(f(p.x) + 1.0);",
        ],
        false,
    );
}
