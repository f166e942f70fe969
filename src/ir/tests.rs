//! Tests of lowering, as printed IR, and of the verifier.

use super::{
    Access, Lanes, Module, OpId, OpKind, PlaceId, Precision, Provenance, Step, lower, print, verify,
};
use shaderlint_semantic::{Constant, Program, Type, check_fragment};

/// The declarations of every shader here, on one line.
const HEAD: &str = "#version 300 es\nprecision highp float; precision highp int; out vec4 color; \
                    uniform int n; uniform float x; uniform vec3 v; uniform mat3 m; \
                    uniform sampler2D tex; struct S { float a; vec2 b; };\n";

fn lowered(code: &str) -> (Program, Module) {
    let analysis = check_fragment(code);
    assert!(analysis.is_valid(), "{code}: {:?}", analysis.problems.all);
    let module = lower(&analysis.program);
    (analysis.program, module)
}

/// Compares the printed IR of the statements in `main`, without comments.
#[track_caller]
fn check(statements: &str, expected: &str) {
    let (program, module) = lowered(&format!("{HEAD}void main() {{ {statements} }}\n"));
    assert_eq!(verify(&program, &module), []);
    let text = print(&program, &module);
    let body = text.split_once("fn main() {").unwrap().1;
    let lines = body.lines().map(|l| l.split(" //").next().unwrap());
    let lines = lines.map(|l| l.strip_prefix("  ").unwrap_or(l).trim_end());
    // Closing brackets and value numbers are irrelevant here.
    let is_shown = |l: &&str| !matches!(l.trim(), "" | "}");
    let lines: Vec<String> = lines.filter(is_shown).map(without_numbers).collect();
    let expected: Vec<&str> = expected.lines().filter(is_shown).collect();
    assert_eq!(lines, expected, "{text}");
}

fn without_numbers(line: &str) -> String {
    let mut parts = line.split('%');
    let first = parts.next().unwrap_or("").to_string();
    parts.fold(first, |text, part| {
        text + "%" + part.trim_start_matches(|c: char| c.is_ascii_digit())
    })
}

/// Line numbers are those that browsers report: the expansion of a macro call is on the line where
/// the call ends.
#[test]
fn line_macros_have_the_numbers_of_the_browser() {
    check("int y = __LINE__;", "local y: int = 3");
    check(
        "\n#define L __LINE__\n#define F(x) L\n#define G(x) x\nint y = L, z = F(\n1\n), w = G(L\n\n);",
        "local y: int = 7\nlocal z: int = 9\nlocal w: int = 9",
    );
    check("\n#line 70\nint y = __LINE__;", "local y: int = 70");
    check("int y = __FILE__;", "local y: int = 0");
    check(
        "\n#define N 10\n#line (60 + 10) N\n#line 5\nint y = __FILE__;",
        "local y: int = 10",
    );
}

#[test]
fn expressions_are_lowered_to_typed_operations() {
    check("float y = 2.0;", "local y: float = 2.0");
    check("float y;", "local y: float = undefined");
    check("float y = -x * 2.0;", "local y: float = (-x) * 2.0");
    check("bool b = !(x < 1.0);", "local b: bool = !(x < 1.0)");
    check("int i = n << 2u;", "local i: int = n << 2u");
    check("vec3 p = v * x;", "local p: vec3 = v * splat(x)");
    check("vec3 p = m * v;", "local p: vec3 = product(m, v)");
    check("bool b = v == v.zyx;", "local b: bool = v == v.zyx");
    check("float y = float(n);", "local y: float = float(n)");
    check("vec4 p = vec4(v, x);", "local p: vec4 = vec4(v, x)");
    check("float y = m[1].z;", "local y: float = m[1].z");
    check("float y = v[n];", "local y: float = v[n]");
    check("float y = (v + v)[n];", "local y: float = (v + v)[n]");
    check(
        "float y = S(x, v.xy).b.y;",
        "local y: float = S(x, v.xy).b.y",
    );
    check(
        "vec4 p = texture(tex, v.xy);",
        "local p: vec4 = texture(tex, v.xy)",
    );
    check(
        "float y = x > 0.0 ? x : 1.0;",
        "local y: float = select(x > 0.0, x, 1.0)",
    );
    check(
        "bool b = x > 0.0 && n == 1;",
        "local b: bool = (x > 0.0) && (n == 1)",
    );
}

#[test]
fn variables_are_loaded_after_what_may_write_to_them() {
    check(
        "float y = 1.0; float z = y + (y = 2.0);",
        "local y: float = 1.0\ny = 2.0\nlocal z: float = y + 2.0",
    );
    // Without a write, nothing is in another order than in the text.
    check(
        "float y = x * v.x + v.y;",
        "local y: float = (x * v.x) + v.y",
    );
}

#[test]
fn short_circuit_operands_become_control_flow() {
    check(
        "bool b = x > 0.0 && 1.0 / x < 2.0;",
        "temporary $1: bool\n\
         %: bool = x > 0.0\n\
         $1 = %\n\
         if % {\n  \
         $1 = (1.0 / x) < 2.0\n\
         local b: bool = $1",
    );
    check(
        "float y = n > 0 ? sqrt(x) : 1.0;",
        "temporary $1: float\n\
         if n > 0 {\n  \
         $1 = sqrt(x)\n\
         } else {\n  \
         $1 = 1.0\n\
         local y: float = $1",
    );
}

#[test]
fn assignments_are_lowered_to_places() {
    check("color.zx = v.xy;", "color.zx = v.xy");
    check(
        "vec4 p = color; p[n] = x;",
        "local p: vec4 = color\np[n] = x",
    );
    check(
        "S s; s.b.y += x;",
        "local s: S = undefined\ns.b.y = s.b.y + x",
    );
    check(
        "float a[2]; a[n] = a[1];",
        "local a: float[2] = undefined\na[n] = a[1]",
    );
    check(
        "int i = 0; int j = i++ + i;",
        "local i: int = 0\n%: int = i\ni = % + 1\nlocal j: int = % + i",
    );
}

#[test]
fn loops_keep_their_structure() {
    check(
        "float y = 0.0; for (int i = 0; i < 4; i++) { if (i == n) continue; y += x; }",
        "local y: float = 0.0\n\
         local i: int = 0\n\
         loop while i < 4 {\n  \
         if i == n {\n    \
         continue\n  \
         y = y + x\n\
         } step {\n  \
         i = i + 1",
    );
    check(
        "float y = x; do { y *= 2.0; } while (y < 9.0);",
        "local y: float = x\n\
         loop {\n  \
         y = y * 2.0\n\
         } while y < 9.0",
    );
    check("while (true) { break; }", "loop while true {\n  break");
}

#[test]
fn switches_keep_their_structure() {
    check(
        "switch (n) { case 1: case 2: discard; default: color = vec4(x); }",
        "switch n {\n\
         case 1, case 2:\n  \
         discard\n\
         default:\n  \
         color = splat(x)",
    );
}

#[test]
fn calls_copy_in_and_out() {
    let code = "float f(float a, inout vec2 b, out int c) { c = 1; b *= a; return a; }\n\
                void main() { vec3 p = v; int i; color.x = f(x, p.zx, i); }";
    let (program, module) = lowered(&format!("{HEAD}{code}\n"));
    assert_eq!(verify(&program, &module), []);
    let text = print(&program, &module);
    let call = [
        "float = call f(x, p.zx, undefined)",
        "p.zx = returned(%",
        "i = returned(%",
        "color.x = %",
    ];
    let mut rest = text.as_str();
    for line in call {
        let at = rest.find(line).unwrap_or_else(|| panic!("{line}\n{text}"));
        rest = &rest[at..];
    }
}

/// The first operation of a kind in a well-formed module.
fn find(module: &Module, is_it: impl Fn(&OpKind) -> bool) -> OpId {
    let at = module.ops.iter().position(|op| is_it(&op.kind));
    OpId(at.unwrap() as u32)
}

/// Breaks a well-formed module and checks that the verifier reports `expected`.
#[track_caller]
fn broken(expected: &str, break_it: impl FnOnce(&mut Module)) {
    let (program, mut module) = lowered(&format!(
        "{HEAD}float f(float a) {{ return a; }}\n\
         void main() {{ vec3 p = v; p.x = f(-x); if (p.x > 1.0) {{ p = v * 2.0; }} \
         color = vec4(p, 1.0); }}\n"
    ));
    assert_eq!(verify(&program, &module), []);
    break_it(&mut module);
    let found = verify(&program, &module);
    let messages: Vec<String> = found.iter().map(ToString::to_string).collect();
    assert!(
        messages.iter().any(|s| s.contains(expected)),
        "{messages:?}"
    );
}

#[test]
fn the_verifier_finds_invalid_modules() {
    broken("one provenance per operation", |m| {
        m.provenances.pop();
    });
    broken("is not in the program", |m| {
        m.provenances[0] = Provenance::Declaration(9999);
    });
    broken("the result has type", |m| {
        let op = find(m, |k| matches!(k, OpKind::Unary(..)));
        m.ops[op.0 as usize].ty = Type::INT;
    });
    broken("is not defined here", |m| {
        let op = find(m, |k| matches!(k, OpKind::Unary(..)));
        let OpKind::Unary(unary, _) = m.ops[op.0 as usize].kind else {
            unreachable!()
        };
        m.ops[op.0 as usize].kind = OpKind::Unary(unary, op);
    });
    broken("a write to a read-only variable", |m| {
        let load = find(m, |k| matches!(k, OpKind::Load(_)));
        let OpKind::Load(place) = m.ops[load.0 as usize].kind else {
            unreachable!()
        };
        let uniform = (0..m.places.len() as u32).map(PlaceId).find(|p| {
            let variable = m.variable(m.place(*p).variable);
            variable.is_some_and(|v| v.root == super::Root::Uniform && v.ty == Type::FLOAT)
        });
        let value = find(m, |k| matches!(k, OpKind::Unary(..)));
        let store = find(m, |k| matches!(k, OpKind::Store(_, v) if v.0 > value.0));
        m.ops[store.0 as usize].kind = OpKind::Store(uniform.unwrap_or(place), value);
    });
    broken("has no components", |m| {
        let at = m
            .access_lists
            .iter()
            .position(|a| matches!(a, Access::Lanes(_)));
        m.access_lists[at.unwrap()] = Access::Lanes(Lanes::new([3]));
    });
    broken("runs contain", |m| {
        let op = m.ops[0];
        m.ops.push(op);
        m.provenances.push(Provenance::Language);
    });
    broken("a `continue` outside any loop", |m| {
        let stmt = shaderlint_syntax::ast::StmtId(0);
        let at = m.steps.iter().position(|s| matches!(s, Step::If { .. }));
        m.steps[at.unwrap()] = Step::Continue(stmt);
    });
    broken("a constant of 0 scalars is not a float", |m| {
        let op = find(m, |k| matches!(k, OpKind::Const(_)));
        m.ops[op.0 as usize] = super::Op {
            kind: OpKind::Const(Constant::NONE),
            ty: Type::FLOAT,
            precision: Precision::None,
        };
    });
}
