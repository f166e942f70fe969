//! How often loops turn.

use super::Loops;
use crate::flow::Calls;
use crate::flow::defs::Defs;
use crate::flow::ranges::{Query, Ranges};
use crate::flow::sample::checked;
use crate::ir::lower;

/// The bounds of the loops of `void f(int n, float x)`, which is called with 5 and with 9.
#[track_caller]
fn check(body: &str, expected: &str) {
    let code = format!(
        "void f(int n, float x) {{ {body} }}
         void mainImage(out vec4 o, vec2 p) {{ f(5, p.x); f(9, p.y); o = vec4(p, 0.0, 1.0); }}"
    );
    let analysis = checked(&code);
    let module = lower(&analysis.program);
    let defs = Defs::of(&analysis.program, &module, &Calls::of(&module));
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
fn counters_end_loops() {
    check("for (int i = 0; i < 8; i++) { x += 1.0; }", "Exact(8)");
    check("for (int i = 8; i > 0; i -= 2) { x += 1.0; }", "Exact(4)");
    check("for (int i = 0; i != 8; i++) { x += 1.0; }", "Exact(8)");
    check("for (int i = 1; i < 100; i *= 3) { x += 1.0; }", "Exact(5)");
    check(
        "for (float t = 0.0; t < 1.0; t += 0.25) { x += t; }",
        "Exact(4)",
    );
    check("int i = 0; while (i < 3) { i++; }", "AtMost(3)");
    check("int i = 0; do { i++; } while (i < 3);", "AtMost(3)");
    check("for (int i = 6; i-- > 0;) { x += 1.0; }", "AtMost(6)");
    check("for (int i = 0; i < n; i++) { x += 1.0; }", "AtMost(9)");
    check(
        "for (ivec2 p = ivec2(0); p.x < 4; p.x++) { x += 1.0; }",
        "Exact(4)",
    );
}

#[test]
fn what_is_left_early_turns_at_most_as_often() {
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
fn a_counter_that_is_helped_along_ends_too() {
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
fn loops_that_nothing_ends_are_open() {
    check("while (x < 9.0) { x += sin(x); }", "Open");
    check("for (int i = 0; i < 8; i--) { x += 1.0; }", "Open");
    check("for (int i = 0; i < 8; i++) { i = 0; }", "Open");
    check("for (int i = 0; i < n; i++) { n++; }", "Open");
}
