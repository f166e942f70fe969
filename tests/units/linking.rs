//! Link errors of pairs of shaders.

use shaderlint::explain::analyze;
use shaderlint::explain::link::link;
use shaderlint::semantic::{Completeness, Dialect, Stage, Unit};
use shaderlint::text::{Role, Sources};
use std::sync::Arc;

/// Links two shaders and compares the errors, one per line: rule, position in the fragment or
/// vertex shader, message.
#[track_caller]
fn check(vertex: &str, fragment: &str, expected: &str) {
    let mut sources = Sources::new();
    let vert = sources.add("a.vert", None, Role::User, vertex).unwrap();
    let frag = sources.add("a.frag", None, Role::User, fragment).unwrap();
    let sources = Arc::new(sources);
    let files = [[vert], [frag]];
    let of = |files, stage| {
        let analysis = analyze(&Unit {
            sources: &sources,
            files,
            stage,
            dialect: Dialect::WebGl,
            context: shaderlint::syntax::GlContext::WEBGL2,
            infer_channels: false,
            completeness: Completeness::Complete,
        });
        let messages: Vec<&str> = analysis
            .diagnostics
            .iter()
            .map(|d| d.message.as_str())
            .collect();
        assert_eq!(messages, [""; 0]);
        analysis.program
    };
    let programs = (of(&files[0], Stage::Vertex), of(&files[1], Stage::Fragment));
    let found = link(&programs.0, &programs.1);
    let lines: Vec<String> = found
        .iter()
        .map(|d| {
            let file = sources.file_at(d.span.start).unwrap();
            let line = file.position(d.span.start).line;
            format!("{}:{line} {}: {}", file.path, d.rule, d.message)
        })
        .collect();
    assert_eq!(lines.join("\n"), expected);
}

/// Links two GLSL ES 3.00 shaders with these declarations.
#[track_caller]
fn check_300(vertex: &str, fragment: &str, expected: &str) {
    let of = |declarations: &str, rest: &str| {
        let (declarations, body) = declarations.split_once('|').unwrap_or((declarations, ""));
        format!("#version 300 es\n{declarations}\n{rest}\nvoid main() {{ {body} }}\n")
    };
    let vertex = of(vertex, "");
    let fragment = of(fragment, "out highp vec4 color;");
    check(&vertex, &fragment, expected);
}

#[test]
fn varyings_read_must_be_written() {
    let missing = "a.frag:2 link-varying: the vertex shader has no output `v`";
    check_300("", "in highp vec2 v;| color.xy = v;", missing);
    check_300(
        "",
        "in highp vec2 v;| if (false) { color.xy = v; }",
        missing,
    );
    check_300(
        "vec2 v;| v = vec2(0);",
        "in highp vec2 v;| color.xy = v;",
        missing,
    );
    check_300("", "in highp vec2 v;", "");
    check_300("out vec2 v;", "in lowp vec2 v;| color.xy = v;", "");
    // An output in an `#if` that the page may enable is not missing.
    check_300(
        "#ifdef UV\nout vec2 v;\n#endif",
        "in highp vec2 v;| color.xy = v;",
        "",
    );
}

#[test]
fn varyings_have_the_same_type_in_both_stages() {
    check_300(
        "out vec3 v;",
        "in highp vec2 v;| color.xy = v;",
        "a.frag:2 link-varying: `v` is `vec2` in the fragment but `vec3` in the vertex shader",
    );
    check_300("out vec3 v;", "in highp vec2 v;", "");
    check_300(
        "struct S { vec2 a; vec3 b; }; out S v;",
        "struct S { highp vec2 a; highp vec2 b; }; in S v;| color.xy = v.a;",
        "a.frag:2 link-varying: `v.b` is `vec2` in the fragment but `vec3` in the vertex shader",
    );
    check_300(
        "flat out float v;",
        "in highp float v;| color.x = v;",
        "a.frag:2 link-varying: `v` is `flat` in the vertex but not in the fragment shader",
    );
    check_300(
        "centroid out float v;",
        "smooth in highp float v;| color.x = v;",
        "",
    );
}

#[test]
fn uniforms_have_the_same_type_in_both_stages() {
    check_300(
        "uniform float u;",
        "uniform highp vec2 u;",
        "a.frag:2 link-uniform: `u` is `vec2` in the fragment but `float` in the vertex shader",
    );
    // Precisions are compared if both stages use the uniform.
    check_300(
        "uniform int u;| gl_Position.x = float(u);",
        "uniform int u;",
        "",
    );
    check_300(
        "uniform int u;| gl_Position.x = float(u);",
        "uniform int u;| color.x = float(u);",
        "a.frag:2 link-uniform: `u` is `mediump` in the fragment but `highp` in the vertex shader",
    );
    check_300(
        "struct S { float a; }; uniform S u, v;| gl_Position.x = u.a + v.a;",
        "struct S { mediump float a; }; uniform S u, v;| color.x = u.a + v.a;",
        "a.frag:2 link-uniform: `u.a` is `mediump` in the fragment but `highp` in the vertex shader",
    );
    check_300(
        "struct S { highp float a; }; uniform S u;",
        "struct T { highp float a; }; uniform T u;",
        "a.frag:2 link-uniform: `u` is a struct T in the fragment but a struct S in the vertex shader",
    );
    check_300(
        "in float a;| gl_Position.x = a;",
        "uniform highp float a;| color.x = a;",
        "",
    );
}

#[test]
fn uniform_blocks_have_the_same_members_in_both_stages() {
    check_300(
        "uniform B { highp vec4 a; highp vec4 b; };",
        "uniform B { highp vec4 a; };",
        "a.frag:2 link-block: `B` has 1 member in the fragment but 2 members in the vertex shader",
    );
    check_300(
        "uniform B { highp vec4 a; } one;",
        "uniform B { highp vec4 a; } two[2];",
        "a.frag:2 link-block: instances of block `B` differ between the stages",
    );
    check_300(
        "layout(row_major) uniform; uniform B { highp mat4 m; } b;",
        "uniform B { highp mat4 m; } b;",
        "a.frag:2 link-block: block `B` is `column_major` in the fragment but `row_major` in the vertex shader",
    );
    check_300(
        "uniform highp vec4 a;",
        "uniform B { highp vec4 a; };",
        "a.vert:2 link-block: `a` is a uniform in one stage but a member of block `B` in the other",
    );
    check_300(
        "uniform highp vec4 a;",
        "uniform B { highp vec4 a; } b;",
        "",
    );
}

#[test]
fn attributes_get_locations() {
    check_300(
        "layout(location = 0) in mat2 m; layout(location = 1) in float f;",
        "",
        "a.vert:2 link-attribute: attributes `f` and `m` both use location 1",
    );
    check_300(
        "in mat4 a, b, c, d; in float e;",
        "",
        "a.vert:2 link-attribute: no location left for attribute `e`; WebGL has 16",
    );
    let all: String = (0..17).map(|i| format!("attribute vec4 a{i};")).collect();
    check(&format!("{all}\nvoid main() {{}}"), "void main() {}", "");
}

#[test]
fn webgl1_varyings_are_invariant_in_both_stages() {
    let fragment = "varying mediump float v; void main() { gl_FragColor.x = v; }";
    let wrong =
        "a.frag:1 link-varying: `v` is `invariant` in the vertex but not in the fragment shader";
    check(
        "invariant varying float v; void main() { v = 1.0; }",
        fragment,
        wrong,
    );
    check(
        "#pragma STDGL invariant(all)\nvarying float v; void main() { v = 1.0; }",
        fragment,
        wrong,
    );
    check_300(
        "invariant out float v;",
        "in highp float v;| color.x = v;",
        "",
    );
    check(
        "void main() {}",
        "invariant gl_FragCoord; void main() { gl_FragColor = gl_FragCoord; }",
        "a.frag:1 link-varying: `gl_FragCoord` is `invariant` but `gl_Position` in the vertex shader is not",
    );
}

#[test]
fn interfaces_above_the_limits_of_browsers_are_errors() {
    let many = |n: u32| {
        let declared: String = (0..n).map(|i| format!("in highp vec4 v{i};")).collect();
        let used: String = (0..n).map(|i| format!("color += v{i};")).collect();
        (
            declared.replace("in ", "out "),
            format!("{declared}|{used}"),
        )
    };
    let (vertex, fragment) = many(32);
    check_300(&vertex, &fragment, "");
    let (vertex, fragment) = many(33);
    check_300(
        &vertex,
        &fragment,
        "a.frag:2 browser-limit: fragment shader needs 33 varying vectors; the limit is 32",
    );
}

#[test]
fn both_stages_have_the_same_version() {
    check(
        "#version 300 es\nvoid main() {}",
        "void main() {}",
        "a.frag:1 link-version: fragment shader is GLSL ES 1.00, vertex shader is GLSL ES 3.00",
    );
}
