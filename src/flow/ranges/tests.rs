//! Tests of value ranges, in the form used in messages.

use super::{Interval, Query, Ranges, Rounding};
use crate::calls::Calls;
use crate::reaching_definitions::ReachingDefinitions;
use crate::test_shader::checked;
use shaderlint_ir::lower;
use shaderlint_syntax::ast::{ExprKind, StmtKind};

/// The range of the value at the last `return` in `float test()`.
fn interval(code: &str) -> Interval {
    returned(code, 0)
}

/// The range at an earlier `return`: the one with `skipped` others after it.
fn returned(code: &str, skipped: usize) -> Interval {
    let analysis = checked(code);
    let program = &analysis.program;
    let module = lower(program);
    let defs = ReachingDefinitions::of(program, &module, &Calls::of(&module));
    let query = Query {
        program,
        module: &module,
        defs: &defs,
        ranges: &Ranges::default(),
    };
    let mut returned = program
        .tree
        .stmts
        .iter()
        .rev()
        .filter_map(|s| match s.kind {
            StmtKind::Return(Some(e)) if !matches!(program.tree.expr(e).kind, ExprKind::Error) => {
                Some(e)
            }
            _ => None,
        });
    query.expr(returned.nth(skipped).unwrap()).next().unwrap()
}

fn range(code: &str) -> String {
    interval(code).to_string()
}

/// Each case is the value of an expression, or of a body with a `return`, and its range.
#[test]
fn values_have_the_expected_ranges() {
    let cases = include_str!("cases.txt").lines();
    for case in cases.filter(|case| !case.starts_with("# ")) {
        let (code, expected) = case.rsplit_once(" => ").unwrap();
        match code.strip_prefix("body: ") {
            Some(body) => check_body(body, expected),
            None => check(code, expected),
        }
    }
}

#[track_caller]
fn check(expr: &str, expected: &str) {
    let code = format!(
        "float unknown(float a) {{ return texture(iChannel0, vec2(a)).x; }}
         void mainImage(out vec4 o, vec2 p) {{ o = vec4(p, 0.0, 1.0); }}
         float test(float x, vec3 v, int n) {{ return {expr}; }}"
    );
    assert_eq!(range(&code), expected, "{expr}");
}

#[track_caller]
fn check_body(body: &str, expected: &str) {
    let code = format!(
        "void mainImage(out vec4 o, vec2 p) {{ o = vec4(p, 0.0, 1.0); }}
         float test(float x, vec3 v, int n) {{ {body} }}"
    );
    assert_eq!(range(&code), expected, "{body}");
}

#[test]
fn members_have_separate_ranges() {
    let code = "struct S { float a; vec2 b; };
        void mainImage(out vec4 o, vec2 p) { o = vec4(p, 0.0, 1.0); }
        float test() { S s = S(1.0, vec2(2.0, 3.0)); S t = s; t.a = 9.0; return s.a + t.b.y; }";
    assert_eq!(range(code), "4.0");
}

#[test]
fn a_loop_counter_stays_below_its_limit() {
    let code = "void mainImage(out vec4 o, vec2 p) { o = vec4(p, 0.0, 1.0); }
        float test() { for (int i = 2; i < 9; i++) { if (iTime > 1.0) return float(i); } }";
    assert_eq!(range(code), "2.0..=8.0");
}

#[test]
fn parameters_have_the_ranges_of_their_arguments() {
    let code = "float f(float a) { return a; }
        void mainImage(out vec4 o, vec2 p) { o = vec4(f(1.0), f(3.0), 0.0, 1.0); }
        float test() { return f(2.0); }";
    let range = interval(code);
    let reached = range.lo.is_reached() && range.hi.is_reached();
    assert_eq!((range.to_string().as_str(), reached), ("1.0..=3.0", false));
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
    assert_ne!(range(&code), "0.0");
}

#[test]
fn rounding_is_distinguished_from_exact_arithmetic() {
    let check = |body: &str, expected: Rounding| {
        let code = format!(
            "float unknown(float a) {{ return texture(iChannel0, vec2(a)).x; }}
             void mainImage(out vec4 o, vec2 p) {{ o = vec4(p, 0.0, 1.0); }}
             float test(float x, vec3 v, int n) {{ {body} }}"
        );
        assert_eq!(interval(&code).rounding, expected, "{body}");
    };
    use Rounding::{Always, Never, Unknown};
    check("return floor(x) * 0.5 + 1.0;", Never);
    check("return float(n) / 4.0;", Never);
    check("return mod(floor(x), 4.0);", Never);
    check("return mod(floor(x), 3.0);", Never);
    check("return mod(floor(x), 0.1);", Always);
    check("return mod(x, 3.0);", Always);
    check("return dot(vec2(1.0), vec2(n & 1));", Never);
    check("return x;", Unknown);
    check("return unknown(x) + 1.0;", Unknown);
    check("return unknown(x) * 0.1;", Always);
    check("return sqrt(x) + 1.0;", Always);
    check("return length(v);", Always);
    check("return gl_FragCoord.x / iResolution.x;", Always);
    check("return clamp(sin(x), 0.0, 1.0);", Always);
    check("return floor(sin(x));", Never);
    check("float a = 2.0; if (x > 0.0) a = sin(x); return a;", Unknown);
    check(
        "float a = 0.0; for (int i = 0; i < n; i++) a += 0.5; return a;",
        Never,
    );
    check(
        "float a = 0.0; for (int i = 0; i < n; i++) a += 0.1; return a;",
        Always,
    );
}

/// Checks whether the value that `body` returns is known to be negative somewhere.
#[track_caller]
fn check_negative(body: &str, expected: bool) {
    let code = format!(
        "void mainImage(out vec4 o, vec2 p) {{ o = vec4(p, 0.0, 1.0); }}
         float test(float x, vec3 v, int n) {{ {body} }}"
    );
    assert_eq!(interval(&code).strays_below(0.0), expected, "{body}");
}

#[test]
fn centred_coordinates_have_both_signs() {
    let place = "vec2 p = gl_FragCoord.xy, R = iResolution.xy;";
    let check = |expr: &str, expected| check_negative(&format!("{place} return {expr};"), expected);
    check("(p.x - 0.5 * R.x) / R.y", true);
    check("((p + p - R) / R.y).x", true);
    check("(p - R / 2.0).y", true);
    check("(-1.0 + 2.0 * p / R).x", true);
    check("(p / R * 2.0 - 1.0).x * (R.x / R.y)", true);
    check("(p / R.y).x - 0.5", true);
    check("(p.x + 0.5 * R.x) / R.y", false);
    check("(p.x - 0.5 * R.y) / R.y", false);
    check("abs((p.x - 0.5 * R.x) / R.y)", false);
    check("max((p.x - 0.5 * R.x) / R.y, 0.0)", false);
    check("mix(1.0, 2.0, (p / R).x)", false);
}

#[test]
fn rotated_vectors_have_both_signs() {
    let check = |vector: &str, expected| {
        check_negative(
            &format!(
                "mat2 m = mat2(cos(x), -sin(x), sin(x), cos(x));
                 vec2 p = m * {vector}; return p.y;"
            ),
            expected,
        );
    };
    check("(gl_FragCoord.xy / iResolution.xy - 0.5)", true);
    check("(gl_FragCoord.xy / iResolution.xy)", false);
    check("vec2(x)", false);
    check_body(
        "mat2 m = mat2(1.0, 0.0, 0.0, 2.0); return (m * vec2(3.0, 4.0)).y;",
        "8.0",
    );
    check_body(
        "mat2 m = mat2(1.0, 2.0, 3.0, 4.0); return (m * m)[1].x + (vec2(1.0) * m).x;",
        "18.0",
    );
}

#[test]
fn adjusted_colours_may_be_negative() {
    let check = |expr: &str, expected| {
        let texel = "vec3 c = texture(iChannel0, v.xy).rgb;";
        check_negative(&format!("{texel} return {expr};"), expected);
    };
    check("((c - 0.5) * 1.2 + 0.5).x", true);
    check("0.5 - 0.8 * c.x", true);
    check("c.x", false);
    check("c.x * 0.5", false);
    // Not a colour, but another value stored there.
    check("c.x - 20.0", false);
}

#[test]
fn rounding_errors_do_not_count_as_negative_values() {
    check_negative("return cos(3.14159265 / 2.0);", false);
    check_negative("return cos(3.0);", true);
    check_negative("return -exp(x);", true);
    check_negative("return exp(x);", false);
}

#[test]
fn integer_arithmetic_may_result_in_zero() {
    let holds_zero = |expr: &str, expected: bool| {
        let code = format!(
            "void mainImage(out vec4 o, vec2 p) {{ o = vec4(p, 0.0, 1.0); }}
             float test(float x, vec3 v, int n) {{ return {expr}; }}"
        );
        assert_eq!(interval(&code).holds(0.0), expected, "{expr}");
    };
    holds_zero("float(iFrame % 4)", true);
    holds_zero("mod(float(iFrame), 4.0)", true);
    holds_zero("float(iFrame % 4 + 1)", false);
    holds_zero("floor(fract(x) * 4.0)", true);
    holds_zero("ceil(fract(x) * 4.0)", false);
    holds_zero("fract(x) * 4.0", false);
    holds_zero("max(x, 0.0) * max(sin(x), 0.0)", true);
    holds_zero("max(x, 0.0) + max(sin(x), 0.0)", false);
}

#[test]
fn conditions_bound_magnitudes_and_products() {
    check_body(
        "x = max(x, 0.0); if (abs(x) > 0.5) return x; return 1.0;",
        "1.0",
    );
    let narrowed = |condition: &str, expr: &str, expected: &str| {
        let body = format!("x = max(x, 0.0); if (!({condition})) return 1.0; return {expr};");
        check_body(&body, expected);
    };
    narrowed("abs(x) >= 0.5", "x", "0.5 or more");
    narrowed("x * x > 0.25", "x", "0.5 or more");
    narrowed("x * v.x > 4.0", "min(x, 0.0) + 1.0", "1.0");
    narrowed(
        "dot(v, v) < 1.0",
        "1.0 - v.x * v.x - v.y * v.y - v.z * v.z",
        "0.0..=1.0",
    );
    narrowed(
        "length(v) < 2.0",
        "2.0 * (v.x * v.x + v.y * v.y + v.z * v.z)",
        "0.0..=8.0",
    );
    let waves = |condition: &str, expected: &str| {
        let body = format!(
            "float a = sin(v.x), b = sin(v.y), c = sin(v.z);
             if (!({condition})) return 1.0; return b + a * a - 1.0;"
        );
        check_body(&body, expected);
    };
    waves("a * a + b > 0.5", "-0.5..=1.0");
    waves("a * a + c > 0.5", "-2.0..=1.0");
}

#[test]
fn conditions_in_functions_narrow_ranges() {
    let code = "void mainImage(out vec4 o, vec2 p) { o = vec4(p, 0.0, 1.0); }
        bool within(vec2 p, float r) { float l = length(p); return l < r && r > 0.0; }
        float test(vec2 v) { if (!within(v, 2.0)) return 0.0; return dot(v, v); }";
    assert_eq!(range(code), "0.0..=4.0");
}

#[test]
fn float_counters_reach_the_value_of_the_last_iteration() {
    let last = |head: &str, expected: bool, end: &str| {
        let code = format!(
            "void mainImage(out vec4 o, vec2 p) {{ o = vec4(p, 0.0, 1.0); }}
             float test(float x) {{ for ({head}) {{ if (x > 0.5) return i; }} }}"
        );
        let range = interval(&code);
        assert_eq!(
            (range.hi.is_reached(), range.to_string().as_str()),
            (expected, end),
            "{head}"
        );
    };
    last("float i = 0.0; i < 1.0; i += 0.25", true, "0.0..=0.75");
    last("float i = 0.0; i < 0.95; i += 0.1", true, "0.0..=0.9");
    // Rounding decides whether there is one more iteration.
    last("float i = 0.0; i < 1.0; i += 0.1", false, "0.0..=1.0");
}

#[test]
fn the_same_argument_passed_twice_cancels() {
    let check = |call: &str, expected: &str| {
        let code = format!(
            "void mainImage(out vec4 o, vec2 p) {{ o = vec4(p, 0.0, 1.0); }}
             float test(vec3 a, vec3 b) {{ return (a - b).x; }}
             vec3 use(vec3 v, vec3 w) {{ float f = test({call}); return v; }}"
        );
        assert_eq!(returned(&code, 1).to_string(), expected, "{call}");
    };
    check("v, v", "0.0");
    check("v, w", "any number");
}

#[test]
fn functions_with_prototypes_have_ranges() {
    let code = "float late(float a);
        float wave(float a) { return max(sin(a), 0.0); }
        float test(float a) { if (wave(a) == 0.0) return 1.0; return wave(a); }
        float late(float a) { float r = 1.0; if (a > 0.0 && a < 4.0) r = wave(a); return r; }
        void mainImage(out vec4 o, vec2 p) { o = vec4(late(p.x)); }";
    assert!(!returned(code, 1).holds(0.0));
}

#[test]
fn conditions_narrow_values_computed_before_them() {
    let holds_zero = |condition: &str, expected: bool| {
        let code = format!(
            "void mainImage(out vec4 o, vec2 p) {{ o = vec4(p, 0.0, 1.0); }}
             vec2 test(float x) {{ float d = max(sin(x), 0.0); vec2 w = vec2(3.0, 1.0) * d;
             if (!({condition})) return vec2(1.0); return w; }}"
        );
        assert_eq!(interval(&code).holds(0.0), expected, "{condition}");
    };
    holds_zero("d > 0.0", false);
    holds_zero("d >= 0.0", true);
    holds_zero("x > 0.0", true);
}

#[test]
fn array_elements_have_separate_ranges() {
    check_body(
        "float a[2] = float[2](x, v.y); float b = a[0], c = a[1]; return b - c;",
        "any number",
    );
    check_body(
        "float a[2] = float[2](x, v.y); float b = a[0]; if (b < 1.0) discard; return a[1];",
        "any number",
    );
    check_body(
        "struct S { vec2 p[2]; }; S s = S(vec2[2](v.xy, v.yz)); vec2 b = s.p[0]; vec2 c = s.p[1]; \
         return b.y - c.y;",
        "any number",
    );
    check(
        "float[2](x, v.y)[0] > 2.0 ? float[2](x, v.y)[1] : 3.0",
        "any number",
    );
    let code = "bool f(float a[2]) { return a[0] > 2.0; }
        void mainImage(out vec4 o, vec2 p) { o = vec4(p, 0.0, 1.0); }
        float test(float x, float y) { float a[2] = float[2](x, y); return f(a) ? a[1] : 3.0; }";
    assert_eq!(range(code), "any number");
    let code = "float f(float a[2]) { float b = a[0], c = a[1]; return b - c; }
        void mainImage(out vec4 o, vec2 p) { float a[2] = float[2](p.x, p.y); o = vec4(f(a)); }";
    assert_eq!(range(code), "any number");
}

#[test]
fn unassigned_variables_may_have_any_value() {
    check_body("float a; if (x > 0.0) a = 1.0; return a;", "any number");
    check_body(
        "float a; for (int i = 0; i < n; i++) { a = 2.0; } return a;",
        "any number",
    );
    check_body(
        "float a; switch (n) { case 0: a = 1.0; break; case 1: a = 2.0; } return a;",
        "any number",
    );
    check_body(
        "float a; if (x > 0.0) a = 1.0; else a = 2.0; return a;",
        "1.0..=2.0",
    );
    check_body(
        "float a[2]; a[0] = 1.0; a[1] = 2.0; return a[n];",
        "1.0..=2.0",
    );
    check_body(
        "float a; float b = x > 0.0 && v.x > 1.0 ? 1.0 : 2.0; return b;",
        "1.0..=2.0",
    );
    let code = "void f(float x, out float a) { if (x > 0.0) a = 1.0; }
        void mainImage(out vec4 o, vec2 p) { o = vec4(p, 0.0, 1.0); }
        float test(float x) { float a; f(x, a); return a; }";
    assert_eq!(range(code), "any number");
}
