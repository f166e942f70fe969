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

#[test]
fn statements_are_lowered() {
    let cases = include_str!("cases.txt").lines();
    for case in cases.filter(|case| !case.starts_with("# ")) {
        let (statements, expected) = case.split_once(" ⇒ ").unwrap();
        let [statements, expected] = [statements, expected].map(|text| text.replace('↵', "\n"));
        check(&statements, &expected);
    }
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
