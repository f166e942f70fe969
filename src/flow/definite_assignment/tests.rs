//! Tests of definite assignment.

use super::{DefiniteAssignment, UnassignedVariable};
use crate::calls::Calls;
use crate::ranges::{Query, Ranges};
use crate::reaching_definitions::ReachingDefinitions;
use shaderlint_ir::lower;
use shaderlint_semantic::problem::{CallError, ProblemKind};
use shaderlint_semantic::{Completeness, Dialect, Mentions, Pass, Stage, Unit, check_shader};
use shaderlint_syntax::Search;
use shaderlint_text::{Role, Sources};
use std::sync::Arc;

/// Compares the findings in the last function of `code`; `?` marks a variable that is guarded by a
/// condition.
#[track_caller]
fn check(code: &str, expected: &str) {
    let mut sources = Sources::new();
    let head = Pass::Image.host().prelude([None; 4]);
    let head = sources.add("", None, Role::Prelude, head).unwrap();
    let user = sources.add("a.glsl", None, Role::User, code).unwrap();
    let sources = Arc::new(sources);
    let unit = Unit {
        sources: &sources,
        files: &[head, user],
        stage: Stage::Fragment,
        dialect: Dialect::ShaderToy(Pass::Image),
        infer_channels: true,
        completeness: Completeness::Chunk,
    };
    let analysis = check_shader(&unit, &mut Search::for_text());
    // A host adds the entry function and the bodies of prototypes.
    let is_added = |what: &ProblemKind| {
        matches!(
            what,
            ProblemKind::Entry(_) | ProblemKind::Calls(CallError::Undefined(_))
        )
    };
    assert!(
        analysis.problems.all.iter().all(|p| is_added(&p.what)),
        "{code}"
    );
    let reported = [analysis.preprocessing, analysis.syntax, analysis.translated];
    assert_eq!(reported.concat(), [], "{code}");
    let program = &analysis.program;
    let module = lower(program);
    let calls = Calls::of(&module);
    let (defs, ranges) = (
        ReachingDefinitions::of(program, &module, &calls),
        Ranges::default(),
    );
    let query = || Query {
        program,
        module: &module,
        defs: &defs,
        ranges: &ranges,
    };
    let mentions = Mentions::of(program);
    let paths = DefiniteAssignment::of((program, &module), &calls, &mentions, &query);
    let tested = program
        .functions
        .iter()
        .rposition(|f| f.definition.is_some());
    let tested = shaderlint_semantic::FunctionRef(tested.unwrap() as u32);
    let found = paths.get(tested).unwrap();
    let shown = |word: &str, unset: &UnassignedVariable| {
        let name = program
            .names
            .text(program.variables[unset.variable.0 as usize].name);
        let word = if unset.always { "never" } else { word };
        let guard = if unset.guarded { "?" } else { "" };
        format!("{name} {word}{guard}")
    };
    let reads = found.reads.iter().map(|u| shown("read", u));
    let in_loops = found.loop_reads.iter().map(|u| shown("loop", u));
    let reads = reads.chain(in_loops);
    let outputs = found.outputs.iter().map(|u| shown("left", u));
    let end = found.reaches_end.then(|| "end".to_string());
    let messages: Vec<String> = reads.chain(outputs).chain(end).collect();
    assert_eq!(messages.join(", "), expected, "{code}");
}

#[test]
fn assignments_in_loops_hold_on_some_paths_only() {
    let found = |body: &str, expected| {
        check(
            &format!("float f(float x) {{ float y; {body} return y; }}"),
            expected,
        );
    };
    found(
        "for (int i = 0; i < 4; i++) { if (x > float(i)) { y = x; break; } }",
        "y loop?",
    );
    found(
        "for (int i = 0; i < 4; i++) { if (x > float(i)) y = x; }",
        "y loop",
    );
    found(
        "while (x > 1.0) { x -= 1.0; if (x > 7.0) y = x; else if (x > 3.0) continue; }",
        "y loop?",
    );
    found(
        "for (int i = 0; i < 4; i++) { if (x > float(i)) y = x; } y = 1.0;",
        "",
    );
    found(
        "for (int i = 0; i < 4; i++) { y = x; if (x > float(i)) break; }",
        "",
    );
    check(
        "float f(float x) { vec2 y; y.x = 1.0; for (int i = 0; i < 4; i++) { if (x > float(i)) y.y = x; } return y.x; }",
        "",
    );
}

#[test]
fn inout_arguments_are_read_if_the_function_uses_the_value() {
    check(
        "void set(inout vec2 a) { a = vec2(1.); } float f() { vec2 a; set(a); return a.x; }",
        "",
    );
    check(
        "void add(inout float a) { a += 1.; } float f() { float a; add(a); return a; }",
        "a never",
    );
    check(
        "void add(inout float a); float f() { float a; add(a); return a; }",
        "",
    );
    check(
        "void part(inout vec2 a) { a.x = 1.; a.y += a.x; } float f() { vec2 a; part(a); return a.x; }",
        "a never",
    );
    check(
        "void inner(inout float a) { a = 1.; } void outer(inout float a) { inner(a); }
         float f() { float a; outer(a); return a; }",
        "",
    );
    check(
        "struct S { float a, b; }; void set(inout S s) { s.a = 1.; s.b = 2.; }
         float f() { S s; set(s); return s.a; }",
        "",
    );
    check(
        "void set(inout float a) { if (iTime > 1.) a = 1.; else a = 2.; }
         float f() { float a; set(a); return a; }",
        "",
    );
}

#[test]
fn reads_before_assignment_are_found() {
    check("float f() { float a; return a; }", "a never");
    check(
        "float f(float x) { float a; if (x > 0.) a = 1.; return a; }",
        "a read",
    );
    check(
        "float f() { float a; for (int i = 0; i < 4; i++) a += 1.; return a; }",
        "a never",
    );
    check("float f(float x) { float a = x; return a; }", "");
    check(
        "void f(out float d, float c) { for (;;) { if (c > 1.) break; d += c; } }",
        "d never?, end",
    );
}

#[test]
fn assignments_in_earlier_iterations_count() {
    check(
        "float f(float x) { float s, l; for (int i = 0; i < 4; i++) { \
         if (i == 0) s = 1.; else s += l; l = s; } return s; }",
        "l read?, s read?",
    );
}

/// What both operands of `?:` read is read whatever the condition is.
#[test]
fn reads_in_both_operands_of_a_conditional_are_unconditional() {
    let check = |value: &str, expected| {
        check(
            &format!(
                "float f(float x) {{ vec2 d; float s; for (int i = 0; i < 4; i++) {{ \
                 s = max(s, {value}); d = vec2(x); }} return s; }}"
            ),
            expected,
        );
    };
    check("x > 0. ? d.x : d.x * d.x", "s never, d never");
    check("x > 0. ? 1. - d.y : sin(d.y)", "s never, d never");
    check("x > 0. ? d.x : 1.", "s never, d read?");
    check("x > 0. ? d.x : d.y", "s never, d read?");
    check(
        "x > 0. ? d.x : (x > 1. ? d.x : 2.)",
        "s never, d read?, d read?",
    );
    check(
        "x > 0. ? sin(d.x) : x < -1. ? sin(d.x) : cos(d.x)",
        "s never, d never",
    );
    check(
        "x > 0. ? sin(d.x) : x < -1. ? sin(d.x) : 1.",
        "s never, d read?, d read?",
    );
}

#[test]
fn repeated_conditions_have_the_same_result() {
    check(
        "float f(float x) { float a; if (x > 0.) a = 1.; if (!(x > 0.)) a = 2.; return a; }",
        "",
    );
    check(
        "float f(float x) { float a; if (x > 0.) a = 1.; if (x <= 0.) a = 2.; return a; }",
        "",
    );
    check(
        "float f(bool b) { float a; if (b) a = 1.; if (b) return a; return 0.; }",
        "",
    );
    check(
        "float f(float x) { float a; if (x > 0.) a = 1.; x = -x; if (x > 0.) return a; return 0.; }",
        "a read?",
    );
}

#[test]
fn compared_constants_count_as_all_values_of_an_integer() {
    check(
        "float f(int i) { float a; if (i == 0) a = 1.; else if (i == 1) a = 2.; return a; }",
        "",
    );
    check(
        "float f(int i) { float a; switch (i) { case 0: a = 1.; break; case 1: a = 2.; } return a; }",
        "",
    );
    check(
        "float f(int i) { float a; if (i == 0) a = 1.; return a; }",
        "a read",
    );
    check(
        "float f(int i) { if (i == 0) return 1.; else if (i == 1) return 2.; }",
        "end",
    );
}

#[test]
fn unassigned_out_parameters_are_found() {
    check(
        "void f(float d, out float n) { if (d > 1.) return; n = 1.; }",
        "n left, end",
    );
    check(
        "void f(float d, out float n) { if (d > 1.) return; }",
        "n never, end",
    );
    check("void f(float d, out float n) { n = d; }", "end");
    check("float f(float d) { if (d > 1.) return 1.; }", "end");
    check(
        "float f(float d) { while (true) { if (d > 1.) return 1.; d += 1.; } }",
        "",
    );
}

#[test]
fn exhaustive_comparisons_assign_on_every_path() {
    check(
        "float f(float x, float y) { float a; if (x <= y) a = 1.; else if (y < x) a = 2.; return a; }",
        "",
    );
    check(
        "float f(bool b, bool c) { if (b || c) { float a; if (b && c) a = 1.; else if (b && !c) a = 2.; \
         else if (!b && c) a = 3.; return a; } return 0.; }",
        "",
    );
    check(
        "float f(vec3 p) { if (p.x >= max(p.y, p.z)) return 1.; if (p.y >= max(p.x, p.z)) return 2.; \
         if (p.z >= max(p.y, p.x)) return 3.; }",
        "",
    );
    check(
        "float f(vec3 p) { float m = max(p.x, max(p.y, p.z)); if (p.x == m) return 1.; \
         if (p.y == m) return 2.; if (p.z == m) return 3.; }",
        "",
    );
    check(
        "float f(vec3 p) { if (p.x >= max(p.y, p.z)) return 1.; if (p.y >= p.x) return 2.; \
         if (p.z >= 9.) return 3.; }",
        "end",
    );
    check(
        "float f(float x) { x = fract(x); if (x < .5) return 1.; if (.5 <= x && x < 1.) return 2.; }",
        "",
    );
    check(
        "float f(float x) { if (x < .5) return 1.; if (.5 < x) return 2.; }",
        "end",
    );
    check(
        "float f(int i) { i &= 3; if (i == 0) return 1.; if (i == 1) return 2.; if (i > 1 && i < 4) return 3.; }",
        "",
    );
    check(
        "float f(int i) { switch (i & 1) { case 0: return 1.; case 1: return 2.; } }",
        "",
    );
    check(
        "float f(int i) { switch (i & 2) { case 0: return 1.; case 1: return 2.; } }",
        "end",
    );
    check(
        "float f(int i) { float a; if (i == 1) a = 1.; if (i == 2) a = 2.; return a; }",
        "",
    );
    check(
        "float f(float x) { float a; if (x > 1.) a = 1.; x += 1.; if (x <= 1.) a = 2.; return a; }",
        "a read",
    );
}

#[test]
fn unused_arguments_may_be_unassigned() {
    check(
        "float g(float a, float b) { return b; } float h(float a) { return g(a, 1.); } \
         float f() { float a; return h(a); }",
        "",
    );
    check(
        "float g(float a, float b) { return b; } float f() { float a; return g(1., a); }",
        "a never",
    );
}

#[test]
fn members_are_assigned_separately() {
    check(
        "struct S { float a, b; }; float f() { S s; s.a = 1.; return s.b; }",
        "s never",
    );
    check(
        "struct S { float a, b; }; float f() { S s; s.a = 1.; s.b = 2.; return s.b + s.a; }",
        "",
    );
    check(
        "struct S { float a, b; }; S f() { S s; s.a = 1.; return s; }",
        "",
    );
    check(
        "struct S { vec2 a; float b; }; float f() { S s; s.a.x = 1.; return s.a.x; }",
        "",
    );
}
