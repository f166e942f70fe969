//! A statement in, what is said of it out.

use crate::analyze_fragment;
use shaderlint_text::apply_edits;

const HEAD: &str = "#version 300 es\nprecision highp float;\nout vec4 color;\n\
                    uniform vec3 size;\nfloat own(vec2 p, float k) { return p.x * k; }\n\
                    void main() {\n    color = vec4(1);\n    int i = 1; float f = 2.; vec2 v = vec2(f);\n";

/// Checks what is said of a statement: `message`, or `message => the statement with the fix made`.
#[track_caller]
fn check(statement: &str, expected: &str) {
    let text = format!("{HEAD}{statement}\n}}\n");
    let found = analyze_fragment(&text);
    let all: Vec<String> = found
        .diagnostics
        .iter()
        .map(|d| match &d.fix {
            Some(fix) => {
                let mended = apply_edits(&text, 0, &fix.edits).unwrap();
                let mended = mended.strip_prefix(HEAD).unwrap_or(&mended);
                let mended = mended.strip_suffix("\n}\n").unwrap_or(mended);
                format!("{} => {mended}", d.message)
            }
            None => d.message.clone(),
        })
        .collect();
    assert_eq!(all.join("; "), expected, "{statement}");
}

/// A brace that is missing has no place at which a fix could write.
#[test]
fn a_list_without_its_brace_is_not_rewritten() {
    let text = format!("{HEAD}float x = {{ f\n");
    for found in analyze_fragment(&text).diagnostics {
        let edits = found.fix.map_or(Vec::new(), |fix| fix.edits);
        assert!(apply_edits(&text, 0, &edits).is_ok(), "{}", found.message);
        assert!(found.rule != "initializer-list" || edits.is_empty());
    }
}

#[test]
fn a_literal_changes_and_all_else_is_converted() {
    check(
        "f = i * 2.;",
        "`int` and `float` do not mix in `*` => f = float(i) * 2.;",
    );
    check(
        "f = f + 1;",
        "`float` and `int` do not mix in `+` => f = f + 1.0;",
    );
    check(
        "i = i % f;",
        "`%` works on integers, not on `int` and `float` => i = mod(float(i), f);",
    );
    check(
        "float g[2] = float[2](1., i);",
        "an element of the array is `float`, not `int` => float g[2] = float[2](1., float(i));",
    );
}

#[test]
fn vectors_are_cut_or_filled() {
    check(
        "v = size;",
        "`vec3` cannot become `vec2` by itself => v = size.xy;",
    );
    check(
        "v += size;",
        "`vec2` and `vec3` do not fit in `+` => v += size.xy;",
    );
    check(
        "f = v;",
        "`vec2` cannot become `float` by itself => f = v.x;",
    );
    check(
        "vec3 w = vec3(v);",
        "`vec3` needs 3 components, but only 2 are given => vec3 w = vec3(v, 0.0);",
    );
    check(
        "vec3 w = vec3(v, v, 1.);",
        "`vec3` has 3 components, but 5 are given => vec3 w = vec3(v, v);",
    );
    check(
        "vec3 w = vec3();",
        "`vec3()` has no arguments => vec3 w = vec3(0.0);",
    );
}

#[test]
fn truth_values_are_no_numbers() {
    check(
        "bool b = 0. < f < 1.;",
        "comparisons cannot be chained => bool b = 0. < f && f < 1.;",
    );
    check(
        "if (i) f = 1.;",
        "the condition of `if` must be `bool`, not `int` => if (i != 0) f = 1.;",
    );
    check(
        "if (v == size.xy && f) f = 1.;",
        "`bool` and `float` do not go together in `&&` => if (v == size.xy && f != 0.0) f = 1.;",
    );
    check(
        "f = !f;",
        "`!` has no meaning for `float` => f = (f == 0.0);",
    );
    check(
        "f = i > 0 ? 1 : 2.;",
        "`int` and `float` do not mix in `? :` => f = i > 0 ? 1.0 : 2.;",
    );
    check(
        "return f;",
        "a `void` function cannot return a value (this is `float`) => return;",
    );
}

#[test]
fn members_that_are_not_there() {
    check("f = v.q;", "`vec2` has no component `q` => f = v.t;");
    check("f = f.x;", "`float` has no component `x`");
    check(
        "f = v[f];",
        "an index must be an integer, not `float` => f = v[int(f)];",
    );
    check(
        "v.xx = v;",
        "`xx` names a component twice and cannot be assigned to => v.xy = v;",
    );
    check(
        "f = v.length();",
        "`.length()` is for arrays; this is `vec2` => f = length(v);",
    );
}

#[test]
fn arguments_are_given_swapped_or_taken_away() {
    check(
        "f = own(f, v);",
        "`own` has no form for `float` and `vec2` => f = own(v, f);",
    );
    check(
        "f = own(v);",
        "`own` takes 2 arguments, not 1 => f = own(v, 0.0);",
    );
    check(
        "f = own(v, f, 1.);",
        "`own` takes 2 arguments, not 3 => f = own(v, 1.);",
    );
    check(
        "f = sin(i);",
        "`sin` wants `float` here, not `int` => f = sin(float(i));",
    );
    check(
        "f = sin(v, 1.);",
        "`sin` takes 1 argument, not 2 => f = sin(v);",
    );
    check(
        "f = f(v);",
        "`f` is a variable, not a function => f = f * (v);",
    );
}

#[test]
fn names_that_are_slips_or_of_other_languages() {
    check(
        "f = saturate(f);",
        "there is no function `saturate`: GLSL has `clamp(a, 0.0, 1.0)` => f = clamp(f, 0.0, 1.0);",
    );
    check(
        "float3 w = float3(1.);",
        "there is no type `float3`: GLSL has `vec3` => vec3 w = vec3(1.);",
    );
    check("f = ff;", "nothing declares `ff`");
    check(
        "f = own2(v, f);",
        "nothing declares the function `own2` => f = own(v, f);",
    );
}

#[test]
fn the_side_that_is_written_to() {
    check("1. = f;", "this cannot be assigned to => f = 1.;");
}
