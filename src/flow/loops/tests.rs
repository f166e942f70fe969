//! Tests of loop bounds.

use super::Loops;
use crate::calls::Calls;
use crate::ranges::{Query, Ranges};
use crate::reaching_definitions::ReachingDefinitions;
use crate::test_shader::checked;
use shaderlint_ir::lower;

/// Checks the bounds of the loops in `void f(int n, float x)`, which is called with 5 and with 9.
#[track_caller]
fn check(body: &str, expected: &str) {
    let code = format!(
        "void f(int n, float x) {{ {body} }}
         void mainImage(out vec4 o, vec2 p) {{ f(5, p.x); f(9, p.y); o = vec4(p, 0.0, 1.0); }}"
    );
    let analysis = checked(&code);
    let module = lower(&analysis.program);
    let defs = ReachingDefinitions::of(&analysis.program, &module, &Calls::of(&module));
    let loops = Loops::of(Query {
        program: &analysis.program,
        module: &module,
        defs: &defs,
        ranges: &Ranges::default(),
    });
    let bounds: Vec<String> = loops.all.iter().map(|l| format!("{:?}", l.bound)).collect();
    assert_eq!(bounds.join(" "), expected, "{body}");
}

#[test]
fn loops_with_counters_have_exact_bounds() {
    check("for (int i = 0; i < 8; i++) { x += 1.0; }", "Exact(8)");
    check("for (int i = 8; i > 0; i -= 2) { x += 1.0; }", "Exact(4)");
    check("for (int i = 0; i != 8; i++) { x += 1.0; }", "Exact(8)");
    check("for (int i = 1; i < 100; i *= 3) { x += 1.0; }", "Exact(5)");
    check(
        "for (float t = 0.0; t < 1.0; t += 0.25) { x += t; }",
        "Exact(4)",
    );
    check("int i = 0; while (i < 3) { i++; }", "Exact(3)");
    check("int i = 0; do { i++; } while (i < 3);", "Exact(3)");
    check("int i = 5; do { i++; } while (i < 3);", "Exact(1)");
    check("for (int i = 6; i-- > 0;) { x += 1.0; }", "Exact(6)");
    check(
        "int i = 0; while (i < 3) { if (x > 1.0) continue; i++; }",
        "Open",
    );
    check("for (int i = 0; i < n; i++) { x += 1.0; }", "AtMost(9)");
    check(
        "for (ivec2 p = ivec2(0); p.x < 4; p.x++) { x += 1.0; }",
        "Exact(4)",
    );
}

#[test]
fn loops_with_early_exits_have_upper_bounds() {
    check(
        "for (int i = 0; i < 8; i++) { if (sin(x) > 0.5) break; }",
        "AtMost(8)",
    );
    check(
        "for (int i = 0; ; i++) { if (i > 7) break; x += 1.0; }",
        "AtMost(8)",
    );
    check(
        "for (int i = 0; i < 8 && x < 3.0; i++) { x *= x; }",
        "AtMost(8)",
    );
}

#[test]
fn loops_with_additional_increments_end() {
    check("for (int i = 0; i < 8; i++) { if (x > 1.0) i++; }", "Ends");
    check(
        "for (float i = 0.0; i < 8.0; i++) { i += step(0.5, x) * 9.0; }",
        "Ends",
    );
    check("while (n > 0) { n /= 2; }", "Ends");
    check("while (x < 9.0) { x += max(sin(x), 0.1); }", "Ends");
    check(
        "float s = iTime; for (float t = 0.0; t < x; t += s) { }",
        "Ends",
    );
}

#[test]
fn loops_without_progress_are_open() {
    check("while (x < 9.0) { x += sin(x); }", "Open");
    check("for (int i = 0; i < 8; i--) { x += 1.0; }", "Open");
    check("for (int i = 0; i < 8; i++) { i = 0; }", "Open");
    check("for (int i = 0; i < n; i++) { n++; }", "Open");
}

#[test]
fn loops_ended_by_setting_the_counter_have_upper_bounds() {
    check(
        "for (int i = 0; i < 8; i++) { if (x > 1.0) i = 8; }",
        "AtMost(8)",
    );
    check(
        "for (float i = 60.0; --i > 0.0;) { x > 0.9 ? i -= i : i; }",
        "AtMost(60)",
    );
    check(
        "for (int i = 0; i < 8; i++) { if (x > 1.0) i = 2; }",
        "Open",
    );
    check(
        "float t = 0.0; while (t < 4.0 || t < 8.0) { t += 1.0; }",
        "AtMost(8)",
    );
    check("for (int i = 0; i < 8 || x > 1.0; i++) { x *= x; }", "Open");
}

#[test]
fn steps_proportional_to_the_distance_end() {
    check(
        "float s = 0.01; for (float t = 0.001; t < 9.0; t += s) { s = 0.01 * t; }",
        "Exact(916)",
    );
}

#[test]
fn loops_that_bisect_an_interval_end() {
    check(
        "float a = 0.0, b = x; while (abs(b - a) > 0.01) { float m = (a + b) / 2.0; \
         if (sin(m) > 0.5) a = m; else b = m; }",
        "Ends",
    );
    check(
        "float a = 0.0, b = x; while (b - a > 0.01) { float m = 0.5 * (a + b); \
         if (sin(m) > 0.5) { a = m; } else { if (m > 1.0) { b = m; } else { a = m; } } }",
        "Ends",
    );
    check(
        "float a = 0.0, b = x; while (b - a > 0.01) { float m = 0.5 * (a + b); if (sin(m) > 0.5) a = m; }",
        "Open",
    );
    check(
        "int a = n, b = 6; while (b != 0) { int r = a % b; a = b; b = r; }",
        "Ends",
    );
    check(
        "int a = n, b = 6; while (b != 0) { int r = b % a; b = a; a = r; }",
        "Open",
    );
}

#[test]
fn steps_that_may_be_zero_do_not_end_a_loop() {
    check(
        "float t = 0.0; while (t < 1.0) { float h = sin(t * fract(x)); if (h < 0.0) break; t += h * 0.1; }",
        "Open",
    );
}

#[test]
fn loops_that_exit_in_the_first_iteration_run_once() {
    check(
        "while (true) { x += 1.0; if (x > 2.0) break; else return; }",
        "AtMost(1)",
    );
    check("do { x *= 2.0; return; } while (x > 0.0);", "AtMost(1)");
    check(
        "return; for (float t = 0.0; t < 1.0; t += x) { }",
        "AtMost(1)",
    );
    check("for (;;) { if (x > 2.0) continue; break; }", "Open");
}

#[test]
fn loops_that_scale_their_counter_end() {
    check("while (x > 1.0) { x /= 10.0; }", "Ends");
    check("while ((n /= 10) > 0) { x += 1.0; }", "Ends");
    check("for (float i = 1.0; abs(i) < 100.0; i *= -2.0) { }", "Ends");
    check("for (float i = 1.0; i < 100.0; i *= -1.5) { }", "Ends");
    check(
        "for (float i = -50.0; abs(i) < 100.0; i += 1.0) { }",
        "Ends",
    );
    check("for (float a = x; a < -0.5; a *= 0.5) { }", "Ends");
    check(
        "float s = 0.1; for (float t = 0.0; t < 9.0; t += s) { s *= 1.1; }",
        "Ends",
    );
    check(
        "float s = 0.1; while (x < 9.0) { x += s; s += 0.1; }",
        "Ends",
    );
    check(
        "for (float a = 0.0, s = 1.0; a < 99.0; a += s, s *= 1.5) { }",
        "Ends",
    );
    check("for (float i = 9.0; i < 100.0; i *= -0.5) { }", "Open");
    check("for (float a = 1.0; a < 9.0; a *= 0.5) { }", "Open");
    check("for (float a = 9.0; abs(a) > 1.0; a -= 4.0) { }", "Open");
    check(
        "float s = 0.1; while (x < 9.0) { x += s; s *= 0.5; }",
        "Open",
    );
}

#[test]
fn loops_that_shift_out_the_tested_bits_end() {
    check(
        "uint v = uint(n); while ((v & 1u) == 0u) { v >>= 1u; }",
        "Ends",
    );
    check("while ((n & 4) != 0) { n /= 2; x += 1.0; }", "Ends");
    check(
        "uvec2 v = uvec2(n, 8); while (((v.x | v.y) & 1u) == 0u) v >>= 1u;",
        "Ends",
    );
    check("int k = n; while ((n & 1) == 0) { k >>= 1; }", "Open");
    check("while ((n & 1) == 0) { n -= 2; }", "Open");
}
