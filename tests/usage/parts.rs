//! Shader fragments: errors that no host can fix, and what a host adds.

use crate::scratch::Scratch;

/// The errors in one file.
#[track_caller]
fn check(name: &str, code: &str, expected: &[&str]) {
    let scratch = Scratch::new(&[(name, code)]);
    let ran = scratch.run(&["-q", "--format", "short", name]);
    let errors = ran.out.lines().filter(|l| l.contains(": error["));
    let places: Vec<String> = errors
        .filter_map(|l| {
            let (place, rest) = l
                .strip_prefix(name)?
                .strip_prefix(':')?
                .split_once(": error[")?;
            Some(format!("{place} {}", rest.split_once(']')?.0))
        })
        .collect();
    assert_eq!(places, expected, "{code}\n{}", ran.out);
}

#[test]
fn undeclared_names_in_fragments_have_any_type() {
    check(
        "a.glsl",
        "float f(Light l) { vec3 a = l.colour * uSun + tint(vec2(1.0), l); return a.x + K[2].y; }",
        &[],
    );
    check(
        "a.glsl",
        "vec3 f(vec3 p) { float d = host(p); return p.xz + vec3(d); }",
        &["1:44 vector-size"],
    );
    check(
        "a.glsl",
        "float f(float x) { return x + 1; }",
        &["1:31 int-float-mix"],
    );
    check(
        "a.glsl",
        "float f(float x) { if (x) { return 1.0; } return x; }",
        &["1:24 condition-type"],
    );
    check(
        "a.glsl",
        "float a[COUNT] = float[COUNT](1.0, 2.0);\nfloat f() { return a[7]; }",
        &[],
    );
}

#[test]
fn unknown_identifiers_may_be_macros() {
    check(
        "a.glsl",
        "IN vec2 uv;\nOUT_COLOR(vec4 c)\nPRECISE float f(float x) { return x; }",
        &[],
    );
    check(
        "a.glsl",
        "float f(float x) { UNROLL for (int i = 0; i < 3; i++) { x += 1.0; } END return x; }",
        &[],
    );
    check(
        "a.glsl",
        "float f(float x) { BEGIN(x) { x += 1.0; } return x; }",
        &[],
    );
    check(
        "a.glsl",
        "float f(float x) { float y = x * 2.0 return y; }",
        &["1:37 missing-semicolon"],
    );
}

#[test]
fn conditional_groups_of_a_host_may_be_present_or_absent() {
    check(
        "a.glsl",
        "#ifdef USE_COLOR\nvec4 tint;\n#else\nfloat tint;\n#endif\nvec4 f() { return tint; }",
        &[],
    );
    check(
        "a.glsl",
        "float f() {\n#ifdef FAST\nreturn 1.0;\n#endif\n}",
        &[],
    );
    check(
        "a.glsl",
        "#if QUALITY > 2\n#define N 4\n#endif\nint f() { return N; }",
        &[],
    );
    check(
        "a.glsl",
        "#ifndef SIZE\n#define SIZE 4\n#endif\nfloat f() { return 1.0 + SIZE; }",
        &[],
    );
    check(
        "a.glsl",
        "#ifndef GUARD\n#define GUARD\nfloat f() { return 1.0 + vec2(2.0); }\n#endif",
        &["3:13 vector-size"],
    );
}

#[test]
fn the_version_of_a_fragment_follows_from_its_code() {
    check(
        "a.frag",
        "in vec2 uv;\nout vec4 c;\nvoid main() { c = texture(map, uv); }",
        &[],
    );
    check(
        "a.frag",
        "varying vec2 uv;\nvoid main() { gl_FragColor = texture2D(map, uv); }",
        &[],
    );
    check(
        "a.frag",
        "varying vec2 uv;\nvoid main() { uvec2 i = uvec2(uv); gl_FragColor = texture(map, uv); }",
        &[],
    );
    check(
        "a.frag",
        "uniform sampler2D map;\nvarying vec2 uv;\nvoid main() { gl_FragColor = texture2D(map, uv).rgb + vec2(x); }",
        &["3:30 vector-size"],
    );
    check("a.glsl", "vec3 centroid(vec3 a) { return a; }", &[]);
    check(
        "a.glsl",
        "uint f(uint x) { return x + 1; }",
        &["1:29 int-float-mix"],
    );
}

#[test]
fn top_level_statements_of_fragments_are_allowed() {
    check(
        "a.glsl",
        "diffuse.rgb *= tint;\nfloat x = 1;\nif (x > 2.0) { discard; }",
        &["2:11 int-float-mix"],
    );
}

#[test]
fn typos_of_one_letter_are_reported() {
    let code = "uniform vec3 lightColour;\nvec3 f(vec3 a) { return a * lightColour + lightColuor * lightColour; }";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    let ran = scratch.run(&["-q", "--format", "short", "a.glsl"]);
    assert_eq!(
        (ran.code, ran.out.as_str()),
        (
            0,
            "a.glsl:2:43: warning[undeclared-name]: `lightColuor` is not declared; did you mean `lightColour`?\n"
        )
    );
}

#[test]
fn complete_shaders_are_checked_without_a_host() {
    check(
        "a.frag",
        "precision highp float;\nvoid main() { gl_FragColor = x; }",
        &["2:30 undeclared-name"],
    );
    check(
        "a.frag",
        "#version 300 es\nvoid main() { }\nint f() { return x; }",
        &["3:18 undeclared-name"],
    );
    check(
        "a.glsl",
        "void mainImage(out vec4 c, in vec2 p) { c = x; }",
        &["1:45 undeclared-name"],
    );
    // The entry point of another host.
    check(
        "a.glsl",
        "void mainImage(const in vec4 i, const in vec2 uv, out vec4 c) { c = i + x; }",
        &[],
    );
    let scratch = Scratch::new(&[("a.glsl", "vec3 f() { return x; }")]);
    assert_eq!(
        scratch.places(&["-q", "--dialect", "shadertoy", "a.glsl"]),
        ["1:19 undeclared-name"]
    );
}

#[test]
fn hosts_are_identified_by_names_imports_and_packages() {
    let code = "varying vec2 vUv;\nvoid main() { gl_Position = vec4(uv.xyz, 1.0); }\n";
    let scratch = Scratch::new(&[
        ("none/a.vert", code),
        (
            "words/a.vert",
            &code.replace("1.0)", "1.0) * projectionMatrix"),
        ),
        (
            "packages/package.json",
            "{\"dependencies\": {\"three\": \"1\"}}",
        ),
        ("packages/src/a.vert", code),
        (
            "import/a.js",
            &format!("import * as T from 'three';\nconst vertexShader = `{code}`;\n"),
        ),
    ]);
    let out = scratch.run(&["-q", "--info", "--format", "short", "."]).out;
    let places: Vec<&str> = out.lines().filter_map(|l| l.split(": ").next()).collect();
    assert_eq!(
        places,
        [
            "import/a.js:3:37",
            "none/a.vert:2:34",
            "packages/src/a.vert:2:37",
            "words/a.vert:2:37"
        ],
        "{out}"
    );
    let json = scratch.run(&["--format", "json", "words"]).out;
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["diagnostics"][0]["part"], true);
    assert_eq!(json["diagnostics"][0]["host"], "three.js");
    let reported = scratch.run(&["-v", "words"]).err;
    assert!(reported.contains("for three.js"), "{reported}");
}

/// A host whose names are all known.
#[test]
fn gl_transitions_are_checked_with_the_names_of_their_host() {
    let code = "uniform float softness; // = 0.1\nvec4 transition(vec2 uv) {\n    \
        float shown = smoothstep(uv.x, uv.x + softness, progres * (1.0 + softness));\n    \
        return mix(getFromColor(uv), getToColor(uv), shown) * pow(sin(uv.x), 2.0);\n}\n";
    let scratch = Scratch::new(&[
        ("wrong.glsl", code),
        ("right.glsl", &code.replace("progres ", "progress ")),
    ]);
    let ran = scratch.run(&["--no-run", "--format", "short", "wrong.glsl"]);
    let typo = "wrong.glsl:3:53: warning[undeclared-name]: `progres` is not declared; did you mean `progress`?";
    assert!(ran.out.starts_with(typo), "{}", ran.out);
    let ran = scratch.run(&["--no-run", "--format", "short", "right.glsl"]);
    let base = "right.glsl:4:63: warning[pow-negative-base]";
    assert!(ran.out.starts_with(base), "{}", ran.out);
}

/// Rules run in a fragment where its host changes nothing.
#[test]
fn rules_run_in_fragments() {
    let code = "\
#ifdef SHARP
#define STEPS 64
float soft(float x) { return x; }
#else
#define STEPS 8
float soft(float x) { return x * x; }
#endif
float plain(vec2 p) { float k; return p.x + k; }
float split(vec2 p) {
    float k;
#ifdef FAST
    k = 1.0;
#endif
    return p.x + k;
}
float calls(vec2 p) { float k; return soft(p.x) + k; }
float macro(vec2 p) { float k; return p.x / float(STEPS) + k; }
float open(vec2 p) { float k; return noise(p) + k; }
#ifdef LATE
float late(vec2 p) { float k; return p.x + k; }
#endif
";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    let ran = scratch.run(&["--info", "--format", "short", "a.glsl"]);
    let out: Vec<&str> = ran.out.lines().collect();
    let found = out.iter().filter(|l| l.contains("uninitialized-read"));
    let found: Vec<&str> = found.filter_map(|l| l.get(..l.find(": ")?)).collect();
    assert_eq!(found, ["a.glsl:8:45"], "{}", ran.out);
    let ran = scratch.run(&["-v", "a.glsl"]);
    let skipped = "Rules skipped 1 function with errors or unknown names: `soft`\n";
    assert!(ran.out.contains(skipped), "{}", ran.out);
    // Without anything of a host, all is checked.
    scratch.write("a.glsl", "float half_of(float x) { return x / 2.0; }\n");
    let out = scratch.run(&["a.glsl"]).out;
    assert_eq!(out, "All checks passed (1 shader in 1 file)\n");
}

#[test]
fn unchecked_names_are_summarised() {
    let scratch = Scratch::new(&[
        ("a.glsl", "float f() { return x + y; }"),
        ("b.glsl", "float g() { return x; }"),
    ]);
    let out = scratch.run(&["."]).out;
    let short =
        "Not fully checked: 2 files (-v lists them); set `[host]` in shaderlint.toml to check more";
    assert!(out.ends_with(&format!("{short}\n")), "{out}");
    let ran = scratch.run(&["-v", "."]);
    let last = "2 files are shader fragments using names from a host: `x`, `y`; set `[host]` in shaderlint.toml to check them";
    assert!(ran.out.ends_with(&format!("{last}\n")), "{}", ran.out);
    let reported = scratch.run(&["-v", "a.glsl"]).err;
    assert!(
        reported.contains("names from the host: `x`, `y`"),
        "{reported}"
    );
}

#[test]
fn only_context_independent_fixes_are_applied_to_fragments() {
    let code = "uniform bool active;\nfloat f(float x) { return active ? x + 1 : vec2(x).x; }\n";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    scratch.run(&["--fix", "a.glsl"]);
    // The error between known operands is fixed; the name, which a program sets, stays.
    assert_eq!(scratch.read("a.glsl"), code.replace("x + 1", "x + 1.0"));
}

#[test]
fn macros_select_the_shaders_of_a_text() {
    let text = |vertex: &str, fragment: &str, end: &str, out: &str| {
        format!(
            "precision mediump float;\nvarying vec2 v;\n{vertex}\nattribute vec2 a;\n\
             void main() {{ v = a; gl_Position = vec4(a, 0.0, 1.0); }}\n{fragment}\n\
             void main() {{ gl_FragColor = {out}; }}\n{end}\n"
        )
    };
    let forms = [
        ["#ifdef VERTEX", "#endif\n#ifdef FRAGMENT", "#endif"],
        ["#ifdef VERTEX", "#else", "#endif"],
        ["#if defined(VS)", "#elif defined(FS)", "#endif"],
        ["#if STAGE == 0", "#else", "#endif"],
    ];
    for [vertex, fragment, end] in forms {
        let with = |out| text(vertex, fragment, end, out);
        let line = 6 + fragment.lines().count();
        check("a.glsl", &with("vec4(v, 0.0, 1.0)"), &[]);
        check(
            "a.glsl",
            &with("vec3(v, 0.0)"),
            &[&format!("{line}:15 vector-size")],
        );
        check(
            "a.glsl",
            &with("vec4(w, 0.0, 1.0)"),
            &[&format!("{line}:35 undeclared-name")],
        );
    }
    let unlike = "#ifdef VERTEX\nattribute vec2 a;\nvarying vec2 v;\n\
         void main() { v = a; gl_Position = vec4(a, 0.0, 1.0); }\n#else\n\
         precision mediump float;\nvarying vec3 v;\n\
         void main() { gl_FragColor = vec4(v, 1.0); }\n#endif\n";
    check("a.glsl", unlike, &["7:14 link-varying"]);
}

#[test]
fn names_of_files_show_the_stage() {
    let code = "varying vec2 v;\nvoid main() { v = vec2(0.0); }\n";
    for name in ["vs.glsl", "water_vertex.glsl", "waterVert.glsl"] {
        check(name, code, &[]);
    }
    check("fs.glsl", code, &["2:15 not-assignable"]);
}
