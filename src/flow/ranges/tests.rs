//! Ranges of expressions, as messages say them.

use super::{Interval, Query, Ranges, Rounding};
use crate::flow::Calls;
use crate::flow::defs::Defs;
use crate::flow::sample::checked;
use crate::ir::lower;
use crate::syntax::ast::{ExprKind, StmtKind};

/// The range of what `float test()` returns at its last `return`.
fn interval(code: &str) -> Interval {
    let analysis = checked(code);
    let program = &analysis.program;
    let module = lower(program);
    let defs = Defs::of(program, &module, &Calls::of(&module));
    let query = Query {
        program,
        module: &module,
        defs: &defs,
        ranges: &Ranges::default(),
    };
    let returned = program.tree.stmts.iter().rev().find_map(|s| match s.kind {
        StmtKind::Return(Some(e)) if !matches!(program.tree.expr(e).kind, ExprKind::Error) => {
            Some(e)
        }
        _ => None,
    });
    query.expr(returned.unwrap()).next().unwrap()
}

fn range(code: &str) -> String {
    interval(code).to_string()
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
fn built_in_functions_have_ranges() {
    check("x", "any number");
    check("sin(x) - 2.0", "-3.0..-1.0");
    check("sin(x) * 0.5 + 0.5", "0.0..1.0");
    check("sin(0.1)", "0.09983");
    check("abs(x)", "0.0 or more");
    check("x * x", "0.0 or more");
    check("dot(v, v)", "0.0 or more");
    check("length(v)", "0.0 or more");
    check("distance(v, vec3(1.0))", "0.0 or more");
    check("dot(normalize(v), normalize(v.zxy))", "-1.0..1.0");
    check("1.0 - dot(normalize(v), vec3(0.0, 1.0, 0.0))", "0.0..2.0");
    check("normalize(v).y", "-1.0..1.0");
    check("fract(x) * 4.0", "0.0..4.0");
    check("mod(x, 3.0) + 1.0", "1.0..4.0");
    check("clamp(x, -2.0, 3.0)", "-2.0..3.0");
    check("max(x, 0.25)", "0.25 or more");
    check("min(x, 0.25)", "0.25 or less");
    check("smoothstep(0.1, 0.2, x) - 0.5", "-0.5..0.5");
    check("mix(-2.0, 5.0, step(0.5, x))", "-2.0..5.0");
    check("sqrt(clamp(x, 0.0, 4.0))", "0.0..2.0");
    check("exp(-abs(x))", "0.0..1.0");
    check("pow(clamp(x, 0.0, 2.0), 3.0)", "0.0..8.0");
    check("vec3(1.0, sin(x), x).y", "-1.0..1.0");
    check("float(n % 4)", "-3.0..3.0");
    check("float(n & 7)", "0.0..7.0");
    check("unknown(x)", "any number");
}

#[test]
fn hosts_fill_in_known_ranges() {
    check("iTime", "0.0 or more");
    check("iResolution.y", "1.0 or more");
    check("gl_FragCoord.x / iResolution.x", "0.0..1.0");
    check("float(iFrame) * -1.0", "0.0 or less");
}

#[test]
fn variables_hold_what_is_written_to_them() {
    check_body("float a = 1.0; if (x > 0.0) a = 4.0; return a;", "1.0..4.0");
    check_body(
        "float a = 0.0; for (int i = 0; i < 3; i++) a += abs(x); return a;",
        "0.0 or more",
    );
    check_body(
        "vec2 a = vec2(0.0, 5.0); a.x = sin(x); return a.x;",
        "-1.0..1.0",
    );
    check_body("vec2 a = vec2(0.0, 5.0); a.x = sin(x); return a.y;", "5.0");
    check_body("float[2] a = float[2](1.0, 3.0); return a[n];", "1.0..3.0");
    check_body("float a; modf(x, a); return a;", "any number");
    check_body("float a = x; a = a + 1.0; return a;", "any number");
}

#[test]
fn conditions_narrow_ranges() {
    check_body("if (x > 2.0) return x; return 0.0 * x;", "0.0");
    check_body(
        "if (x > 2.0) { float y = x; return y; } else return 3.0;",
        "3.0",
    );
    check_body("if (x <= 2.0) return 0.0; return x;", "2.0 or more");
    check_body("if (x <= 2.0) return 0.0; x = v.y; return x;", "any number");
    check_body("return x > 1.0 && x < 5.0 ? x : 2.0;", "1.0..5.0");
    check_body("if (abs(x) > 1.0) discard; return x;", "-1.0..1.0");
    check_body(
        "float a[5]; for (int i = 0; i < 5; i++) { n += i; } return 1.0;",
        "1.0",
    );
    check_body(
        "for (int i = 0; i < 5; i++) { if (x < v.x) { return float(i); } } return v.x > 0.0 ? v.x : 1.0;",
        "0.0 or more",
    );
}

#[test]
fn the_last_write_before_a_use_counts() {
    check_body(
        "x = clamp(x, 0.0, 1.0); x = x * 2.0; x -= 1.0; return x;",
        "-1.0..1.0",
    );
    check_body("v.x = 3.0; v.y = sin(x); v.z = x; return v.y;", "-1.0..1.0");
    check_body(
        "x = 3.0; for (int i = 0; i < n; i++) { v.x = x; x = v.y; } return v.x;",
        "any number",
    );
    check_body("x = 3.0; if (n > 0) x = 5.0; return x;", "3.0..5.0");
}

#[test]
fn what_is_made_of_a_value_narrows_it() {
    check_body(
        "if (length(v) > 1.0) return 0.5; return dot(v, v);",
        "0.0..1.0",
    );
    check_body(
        "float d = dot(v, v); if (d > 4.0) discard; return length(v);",
        "0.0..2.0",
    );
    check_body(
        "bool ok = x > 0.5; if (ok) { return min(x, 1.0); } return 0.75;",
        "0.75",
    );
    check_body(
        "bool ok = x > 0.5; if (!ok) return 0.75; return min(x, 1.0);",
        "0.5..1.0",
    );
    check_body(
        "if (2.0 * x + 1.0 > 5.0) return 1.0; return x;",
        "2.0 or less",
    );
    check_body(
        "if (v != clamp(v, 0.0, 1.0)) return 0.0; return v.y;",
        "0.0..1.0",
    );
    check_body(
        "if (n < 0 || n > 3) return 0.0; return float(n);",
        "0.0..3.0",
    );
}

#[test]
fn what_comes_round_in_a_loop_is_bounded() {
    check_body(
        "float a = 1.0; for (int i = 0; i < n; i++) a *= 0.5; return a;",
        "0.0..1.0",
    );
    check_body(
        "float a = 5.0; while (a > 0.5) { a = max(a - x * x, 0.0); } return a;",
        "0.0..0.5",
    );
    check_body(
        "int i = 0; for (; i < 7; i += 2) { } return float(i);",
        "8.0",
    );
    check_body(
        "float a = 3.0; for (int i = 0; i < 4; i++) { if (x > v.x) break; a = min(a, 2.0); } return a;",
        "2.0..3.0",
    );
}

#[test]
fn members_are_told_apart() {
    let code = "struct S { float a; vec2 b; };
        void mainImage(out vec4 o, vec2 p) { o = vec4(p, 0.0, 1.0); }
        float test() { S s = S(1.0, vec2(2.0, 3.0)); S t = s; t.a = 9.0; return s.a + t.b.y; }";
    assert_eq!(range(code), "4.0");
}

#[test]
fn a_loop_counter_stays_below_its_limit() {
    let code = "void mainImage(out vec4 o, vec2 p) { o = vec4(p, 0.0, 1.0); }
        float test() { for (int i = 2; i < 9; i++) { if (iTime > 1.0) return float(i); } }";
    assert_eq!(range(code), "2.0..8.0");
}

#[test]
fn parameters_take_what_callers_pass() {
    let code = "float f(float a) { return a; }
        void mainImage(out vec4 o, vec2 p) { o = vec4(f(1.0), f(3.0), 0.0, 1.0); }
        float test() { return f(2.0); }";
    let range = interval(code);
    let reached = range.lo.is_reached() && range.hi.is_reached();
    assert_eq!((range.to_string().as_str(), reached), ("1.0..3.0", false));
}

#[test]
fn a_call_writes_what_is_written_however_deep() {
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
fn rounding_is_told_from_exact_arithmetic() {
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
    check("return mod(floor(x), 3.0);", Always);
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
