//! Tests of loop bounds.

use super::Loops;
use crate::test_shader::{TestShader, cases};

/// Checks the bounds of the loops in `void f(int n, float x)`, which is called with 5 and with 9.
#[track_caller]
fn check(body: &str, expected: &str) {
    let code = format!(
        "void f(int n, float x) {{ {body} }}
         void mainImage(out vec4 o, vec2 p) {{ f(5, p.x); f(9, p.y); o = vec4(p, 0.0, 1.0); }}"
    );
    let shader = TestShader::of(&code);
    let loops = Loops::of(shader.query());
    let bounds: Vec<String> = loops.all.iter().map(|l| format!("{:?}", l.bound)).collect();
    assert_eq!(bounds.join(" "), expected, "{body}");
}

/// Each line of the table is `body => bounds`.
#[test]
fn loops_have_the_bounds_that_their_code_determines() {
    for (code, expected) in cases(include_str!("cases.txt")) {
        check(code, expected);
    }
}
