//! Tests of value ranges, in the form used in messages.

use super::Interval;
use crate::test_shader::{TestShader, cases};
use shaderlint_syntax::ast::{ExprId, ExprKind, StmtKind};

/// The range of the value at the last `return` in `float test()`.
fn interval(code: &str) -> Interval {
    returned(code, 0)
}

/// The range at an earlier `return`: the one with `skipped` others after it.
fn returned(code: &str, skipped: usize) -> Interval {
    let shader = TestShader::of(code);
    let tree = &shader.program.tree;
    let is_valid = |e: &ExprId| !matches!(tree.expr(*e).kind, ExprKind::Error);
    let mut returned = tree.stmts.iter().rev().filter_map(|s| match s.kind {
        StmtKind::Return(value) => value.filter(is_valid),
        _ => None,
    });
    shader
        .query()
        .expr(returned.nth(skipped).unwrap())
        .next()
        .unwrap()
}

/// Each case is the value of an expression, of a body with a `return`, or of the last `return` of a
/// shader or the one before it (`earlier`), and its range or another property.
#[test]
fn values_have_the_expected_ranges() {
    for (code, expected) in cases(include_str!("cases.txt")) {
        let in_test = |body: &str| {
            interval(&format!(
                "float unknown(float a) {{ return texture(iChannel0, vec2(a)).x; }}
                 void mainImage(out vec4 o, vec2 p) {{ o = vec4(p, 0.0, 1.0); }}
                 float test(float x, vec3 v, int n) {{ {body} }}"
            ))
        };
        let range = match code.split_once(": ") {
            Some(("body", body)) => in_test(body),
            Some(("shader", code)) => interval(code),
            Some(("earlier", code)) => returned(code, 1),
            _ => in_test(&format!("return {code};")),
        };
        let property = match expected.split_once(": ") {
            Some(("rounding", _)) => format!("rounding: {:?}", range.rounding),
            Some(("below zero", _)) => format!("below zero: {}", range.strays_below(0.0)),
            Some(("holds zero", _)) => format!("holds zero: {}", range.holds(0.0)),
            Some(("end reached", _)) => format!("end reached: {} {range}", range.hi.is_reached()),
            Some(("reached", _)) => {
                let reached = range.lo.is_reached() && range.hi.is_reached();
                format!("reached: {reached} {range}")
            }
            _ => range.to_string(),
        };
        assert_eq!(property, expected, "{code}");
    }
}

#[test]
fn writes_in_nested_calls_are_found_at_any_depth() {
    let count = 100;
    let heads: String = (0..count).map(|i| format!("void f{i}();\n")).collect();
    let calls: String = (1..count)
        .map(|i| format!("void f{}() {{ f{i}(); }}\n", i - 1))
        .collect();
    let code = format!(
        "float g;\n{heads}{calls}void f{}() {{ g = iTime; }}
         void mainImage(out vec4 o, vec2 p) {{ o = vec4(p, 0.0, 1.0); }}
         float test() {{ g = 0.0; f0(); return g; }}",
        count - 1
    );
    assert_ne!(interval(&code).to_string(), "0.0");
}
