//! The order of evaluation, with a table for each kind of expression. The values are those of Chromium
//! (ANGLE's SPIR-V on SwiftShader); `ir::lower::order` describes the rule.

use super::results::row;

/// Functions with side effects. `log` records in which order numbers were evaluated.
const HEAD: &str = "#version 300 es
    precision highp float; precision highp int; out vec4 color;
    struct S { int m; ivec2 n; int e[3]; };
    int g = 1, log = 0; int a[4]; ivec4 v; S s;
    int f() { g = 7; return 2; }
    float ff() { g = 7; return 2.0; }
    int set(int x) { g = x; return x; }
    int bump() { g += 1; return g; }
    int rec(int d) { log = log * 10 + d; return d; }
    int inc(inout int x) { x += 1; return x; }
    int add(int x, int y) { return x * 10 + y; }
    int both(inout int x, int y) { x += 1; return y * 10 + x; }
    bool yes(int d) { log = log * 10 + d; return true; }
    bool no(int d) { log = log * 10 + d; return false; }\n";

/// Each case is statements that assign a value to `r`, and the value.
#[test]
fn operands_are_evaluated_in_browser_order() {
    let cases = include_str!("evaluation_order.txt").lines();
    for case in cases.filter(|case| !case.starts_with("# ")) {
        let (statements, value) = case.split_once(" => ").unwrap();
        let main =
            format!("void main() {{ int r = 0, i = 1, x = 1; {statements} color = vec4(r); }}");
        let expected: f32 = value.parse().unwrap();
        let found = row(&format!("{HEAD}{main}"), 1)[0][0];
        assert_eq!(found, expected, "{statements}");
    }
}
