//! Diagnostics and fixes of single statements.

use super::explain;
use crate::analyze_fragment;
use shaderlint_semantic::{Completeness, Dialect, Pass, Stage, Unit, check_shader};
use shaderlint_syntax::Search;
use shaderlint_text::{Role, Sources, apply_edits};
use std::sync::Arc;

const HEAD: &str = "#version 300 es\nprecision highp float;\nout vec4 color;\n\
                    uniform vec3 size;\nfloat own(vec2 p, float k) { return p.x * k; }\n\
                    void main() {\n    color = vec4(1);\n    int i = 1; float f = 2.; vec2 v = vec2(f);\n";

/// Checks the diagnostics of a statement: `message`, or `message => the statement with the fix
/// applied`.
#[track_caller]
fn check(statement: &str, expected: &str) {
    let text = format!("{HEAD}{statement}\n}}\n");
    let found = analyze_fragment(&text);
    let all: Vec<String> = found
        .diagnostics
        .iter()
        .map(|d| match &d.fix {
            Some(fix) => {
                let repaired = apply_edits(&text, 0, &fix.edits).unwrap();
                let repaired = repaired.strip_prefix(HEAD).unwrap_or(&repaired);
                let repaired = repaired.strip_suffix("\n}\n").unwrap_or(repaired);
                format!("{} => {repaired}", d.message)
            }
            None => d.message.clone(),
        })
        .collect();
    assert_eq!(all.join("; "), expected, "{statement}");
}

/// A statement, and what `check` compares it with; `↵` is a line break.
#[test]
fn statements_have_the_expected_messages_and_fixes() {
    let cases = include_str!("cases.txt").lines();
    for case in cases.filter(|case| !case.starts_with("# ")) {
        let (statement, expected) = case.split_once(" ⇒ ").unwrap();
        check(&statement.replace('↵', "\n"), &expected.replace('↵', "\n"));
    }
}

/// A missing brace has no position for an edit.
#[test]
fn unclosed_initializer_lists_have_no_fix() {
    let text = format!("{HEAD}float x = {{ f\n");
    for found in analyze_fragment(&text).diagnostics {
        let edits = found.fix.map_or(Vec::new(), |fix| fix.edits);
        assert!(apply_edits(&text, 0, &edits).is_ok(), "{}", found.message);
        assert!(found.rule != "initializer-list" || edits.is_empty());
    }
}

/// Applies the only fix of each shader: `before => after`, or `None` if there is no fix.
#[test]
fn fixes_make_complete_shaders_valid() {
    const VERSION: &str = "#version 300 es\nprecision highp float;\n";
    let table = [
        (
            "#define G(x) uvec4(x)\nout vec4 a;\nvoid main() { a = vec4(G(3).r / 2.0); }",
            Some(
                "#define G(x) uvec4(x)\nout vec4 a;\nvoid main() { a = vec4(float(G(3).r) / 2.0); }",
            ),
        ),
        (
            "#define G 1u + uvec4(3)\nout vec4 a;\nvoid main() { a = G.r / vec4(2); }",
            None,
        ),
        (
            "out vec4 a[2];\nvoid main() { gl_FragData[1] = vec4(1); a[0] = vec4(1); }",
            Some("out vec4 a[2];\nvoid main() { a[1] = vec4(1); a[0] = vec4(1); }"),
        ),
        (
            "layout(location = 1) out vec4 b;\nlayout(location = 0) out vec4 a;\n\
             void main() { gl_FragData[1] = vec4(1); a = vec4(1); }",
            Some(
                "layout(location = 1) out vec4 b;\nlayout(location = 0) out vec4 a;\n\
                 void main() { b = vec4(1); a = vec4(1); }",
            ),
        ),
        (
            "void main() { gl_FragData[0] = vec4(1); gl_FragData[2] = vec4(0); }",
            Some(
                "layout(location = 0) out vec4 fragColor;\n\
                 layout(location = 2) out vec4 fragColor2;\n\
                 void main() { fragColor = vec4(1); fragColor2 = vec4(0); }",
            ),
        ),
        (
            "out vec4 a;\nvoid main() { gl_FragData[2] = vec4(1); a = vec4(0); }",
            None,
        ),
        (
            "out vec3 a;\nvoid main() { gl_FragColor = vec4(1); a = vec3(0); }",
            None,
        ),
        (
            "out vec4 a;\nvoid main() { float 2d = 1.; a = vec4(2d); }",
            Some("out vec4 a;\nvoid main() { float _2d = 1.; a = vec4(_2d); }"),
        ),
    ];
    for (before, expected) in table {
        let text = format!("{VERSION}{before}");
        let found = analyze_fragment(&text).diagnostics;
        let fix = found.iter().find_map(|d| d.fix.as_ref());
        let after = fix.map(|f| apply_edits(&text, 0, &f.edits).unwrap());
        let expected = expected.map(|e| format!("{VERSION}{e}"));
        assert_eq!(after, expected, "{before}");
        if let Some(after) = after {
            let left = analyze_fragment(&after).diagnostics;
            assert!(left.is_empty(), "{after}: {left:?}");
        }
    }
}

#[test]
fn superfluous_code_is_removed() {
    check("break;", "`break` outside of a loop or `switch` => ;");
    check(
        "if (f > 1.) continue;",
        "`continue` outside of a loop => if (f > 1.) ;",
    );
    check(
        "const float k;",
        "constant `k` has no initializer => float k;",
    );
    check(
        "highp lowp float k;",
        "`lowp` repeats a qualifier of the same kind => highp float k;",
    );
    check("v = v.xg;", "invalid swizzle `xg` on `vec2` => v = v.xy;");
    check("v = v.ry;", "invalid swizzle `ry` on `vec2` => v = v.rg;");
    let all = |text: &str| {
        let found = analyze_fragment(text);
        let fix = |d: &shaderlint_diagnostic::Diagnostic| {
            let fix = d
                .fix
                .as_ref()
                .map(|f| apply_edits(text, 0, &f.edits).unwrap());
            fix.unwrap_or_default()
        };
        found.diagnostics.iter().map(fix).collect::<Vec<_>>()
    };
    let declared = |before: &str, after: &str| {
        let text = |line: &str| {
            format!("#version 300 es\nprecision highp float;\n{line}\nvoid main() {{}}\n")
        };
        assert_eq!(all(&text(before)), [text(after)], "{before}");
    };
    declared("uniform float k = 1.0, l;", "uniform float k, l;");
    declared("uniform vec2 k = vec2(1.0, 2.0);", "uniform vec2 k;");
    declared("precision highp vec3;", "precision highp float;");
    declared("precision mediump uvec2;", "precision mediump int;");
    declared("sampler2D image;", "uniform sampler2D image;");
    declared(
        "float f(float x, float k = 2.0) { return x * k; }",
        "float f(float x, float k) { return x * k; }",
    );
    declared(
        "vec2 f(float x) {\n    float y = x;\n    vec2(x, y);\n}",
        "vec2 f(float x) {\n    float y = x;\n    return vec2(x, y);\n}",
    );
    declared(
        "layout(loc = 1) out vec4 other;",
        "layout(location = 1) out vec4 other;",
    );
}

/// Every problem in the checker's table of tests has a message of one line without a full stop.
#[test]
fn problems_of_the_checker_have_messages_of_one_line() {
    let rows = include_str!("../../semantic/checker/problems.txt").lines();
    for row in rows.filter(|row| !row.starts_with("# ")) {
        let (code, expected) = row.rsplit_once(" => ").unwrap();
        assert!(finds(code, expected), "{code}: no `{expected}`");
    }
}

/// What the code of a table may start with.
const STAGES: [&str; 5] = ["vertex", "vertex 100", "fragment", "fragment 100", "image"];

/// Whether a row of the table has a problem with this name. All problems in it must have messages.
fn finds(code: &str, expected: &str) -> bool {
    let (stage, code) = match code.split_once(": ") {
        Some((stage, code)) if STAGES.contains(&stage) => (stage, code),
        _ => ("fragment", code),
    };
    let (stage, dialect, head) = match stage {
        "vertex" => (Stage::Vertex, Dialect::WebGl, "#version 300 es\n"),
        "vertex 100" => (Stage::Vertex, Dialect::WebGl, ""),
        "image" => (Stage::Fragment, Dialect::ShaderToy(Pass::Image), ""),
        "fragment 100" => (Stage::Fragment, Dialect::WebGl, "precision highp float;\n"),
        _ => (
            Stage::Fragment,
            Dialect::WebGl,
            "#version 300 es\nprecision highp float;\n",
        ),
    };
    let mut sources = Sources::new();
    let prelude = dialect.host().prelude([None; 4]);
    let files = [
        sources.add("prelude", None, Role::Prelude, prelude),
        sources.add("test", None, Role::User, format!("{head}{code}")),
    ];
    let files: Vec<_> = files.into_iter().flatten().collect();
    let unit = Unit {
        sources: &Arc::new(sources),
        files: &files,
        stage,
        dialect,
        infer_channels: false,
        completeness: Completeness::Complete,
    };
    let shader = check_shader(&unit, &mut Search::for_text());
    for d in explain(&shader.program, &shader.problems) {
        let ends_well = !d.message.is_empty() && !d.message.ends_with('.');
        assert!(ends_well && !d.message.contains('\n'), "{d:?}");
    }
    let mut problems = shader.problems.all.iter();
    problems.any(|p| format!("{:?}", p.what).contains(&format!("({expected}")))
}
