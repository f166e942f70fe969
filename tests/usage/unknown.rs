//! Undeclared names, depending on what may complete the text that uses them.

use crate::scratch::Scratch;

/// The output for a file that is checked with others, without its name and the advice.
#[track_caller]
fn check(files: &[(&str, &str)], expected: &[&str]) {
    let scratch = Scratch::new(files);
    let name = files[0].0;
    let ran = scratch.run(&["-q", "--no-run", "--info", "--format", "short", name]);
    let lines: Vec<&str> = ran
        .out
        .lines()
        .map(|l| l.strip_prefix(&format!("{name}:")).unwrap_or(l))
        .map(|l| l.split_once("; ").map_or(l, |(message, _)| message))
        .collect();
    assert_eq!(lines, expected, "{}", files[0].1);
}

const OWN: &str = "uniform float opacity;\nvoid main() { gl_FragColor = vec4(opcaity); }\n";

#[test]
fn typos_without_a_host_are_errors() {
    let reported = "2:35: error[undeclared-name]: `opcaity` is not declared";
    check(&[("a.frag", OWN)], &[reported]);
    check(&[("a.glsl", OWN)], &[reported]);
    let script = format!("export const shader = `{OWN}`;");
    check(&[("a.js", &script)], &[reported]);
}

#[test]
fn typos_in_fragments_are_warnings() {
    let code = "uniform float opacity; float f(float x) { return noise(x) * opcaity; }";
    check(
        &[("a.glsl", code)],
        &[
            "1:50: info[undeclared-name]: `noise` is not declared in this file",
            "1:61: warning[undeclared-name]: `opcaity` is not declared",
        ],
    );
}

#[test]
fn names_without_a_similar_name_are_listed_once() {
    check(
        &[(
            "a.glsl",
            "float f() { return alpha + beta * gamma + alpha; }",
        )],
        &[
            "1:20: info[undeclared-name]: 3 names are not declared in this file: `alpha`, `beta`, `gamma`",
        ],
    );
}

#[test]
fn names_declared_elsewhere_in_the_repository_are_not_typos() {
    let listed = "2:35: info[undeclared-name]: `opcaity` is not declared in this file";
    let beside = ("b.js", "source = 'uniform float opcaity;' + source;");
    let top = ("package.json", "{}");
    check(&[("a.frag", OWN), beside, top], &[listed]);
    let script = format!("const head = 'uniform float opcaity;'; const shader = `{OWN}`;");
    check(&[("a.js", &script)], &[listed]);
    let macros = format!("const material = {{ defines: {{ opcaity: 1 }}, shader: `{OWN}` }};");
    check(&[("a.js", &macros)], &[listed]);
}

#[test]
fn setting_a_name_or_declaring_it_in_another_shader_does_not_declare_it() {
    let top = ("package.json", "{}");
    let warned = "2:35: warning[undeclared-name]: `opcaity` is not declared";
    let sets = ("b.js", "material.uniforms.opcaity = 1;");
    check(&[("a.frag", OWN), sets, top], &[warned]);
    let declares = "uniform float opcaity; void main() { gl_FragColor = vec4(opcaity); }";
    check(&[("a.frag", OWN), ("b.frag", declares), top], &[warned]);
    // Two shaders that lack the same name have a host that declares it.
    let listed = "2:35: info[undeclared-name]: `opcaity` is not declared in this file";
    let lacks = "void main() { gl_FragColor = vec4(opcaity); }";
    check(&[("a.frag", OWN), ("b.frag", lacks), top], &[listed]);
    let script = format!("const uniforms = {{ opcaity: 1 }}; const shader = `{OWN}`;");
    let reported = "2:35: error[undeclared-name]: `opcaity` is not declared";
    check(&[("a.js", &script)], &[reported]);
}

#[test]
fn the_output_that_a_host_declares_has_a_type() {
    let code = "varying vec2 vUv; uniform float t;\nvoid main() { gl_FragColor = vec3(vUv, t); }";
    let reported = "2:15: error[vector-size]: cannot assign `vec3` to `vec4`";
    check(&[("a.glsl", code)], &[reported]);
    let script = format!(
        "import {{ ShaderMaterial }} from 'three';\nexport const m = {{ fragmentShader: `{}` }};",
        code.replace('\n', " "),
    );
    let reported = "2:86: error[vector-size]: cannot assign `vec3` to `vec4`";
    check(&[("a.js", &script)], &[reported]);
}

#[test]
fn names_differing_in_numbers_or_prefixes_are_not_typos() {
    let code = "float f(vec2 uv1, vec3 normal) { return uv2.x + vNormal.x; }";
    check(
        &[("a.glsl", code)],
        &["1:41: info[undeclared-name]: 2 names are not declared in this file: `uv2`, `vNormal`"],
    );
}

#[test]
fn typos_are_found_in_conditional_groups_of_a_host() {
    let code = "uniform float opacity;\nfloat f() {\n#ifdef FADES\nreturn opcaity;\n#endif\n\
        return opacity;\n}\n";
    check(
        &[("a.glsl", code)],
        &["4:8: warning[undeclared-name]: `opcaity` is not declared"],
    );
    // Whoever defines the name later has the typo, even in a complete text.
    let whole = "#version 300 es\nprecision highp float;\nuniform float opacity;\nout vec4 color;\n\
        void main() {\n#ifdef FADES\ncolor = vec4(opcaity);\n#endif\ncolor = vec4(opacity);\n}\n";
    check(
        &[("a.glsl", whole)],
        &["7:14: warning[undeclared-name]: `opcaity` is not declared"],
    );
}

#[test]
fn three_js_materials_are_complete() {
    let material = "import * as THREE from 'three';\nnew THREE.ShaderMaterial({ fragmentShader: `\n\
        varying vec2 vUv;\nvoid main() { gl_FragColor = vec4(one * vUv, two, toneMappingExposure); }` });\n";
    let errors = [
        "4:35: error[undeclared-name]: `one` is not declared",
        "4:46: error[undeclared-name]: `two` is not declared",
    ];
    check(&[("a.js", material)], &errors);
    let patched = format!("{material}m.onBeforeCompile = (shader) => change(shader);\n");
    let listed = "4:35: info[undeclared-name]: 2 names are not declared in this file: `one`, `two`";
    check(&[("a.js", &patched)], &[listed]);
}

const NEW: &str = "precision highp float;\nin vec2 at;\nout vec4 color;\nvoid main() { color = vec4(at, 0.0, 1.0); }\n";

#[test]
fn missing_versions_are_reported() {
    let reported =
        "2:1: warning[needs-webgl2]: `in` requires GLSL ES 3.00, but `#version 300 es` is missing";
    check(&[("a.frag", NEW)], &[reported]);
    let top = ("package.json", "{}");
    let adds = ("b.js", "const head = '#version 300 es\\n';");
    check(&[("a.frag", NEW), top, adds], &[]);
    let library = (
        "b.js",
        "import { draw } from 'library';\nimport shader from './a.frag';",
    );
    check(&[("a.frag", NEW), top, library], &[]);
    let three = ("package.json", "{\"dependencies\": {\"three\": \"1\"}}");
    check(&[("a.frag", NEW), three], &[]);
    let script = format!("const shader = `{NEW}`;\ngl.shaderSource(s, shader);\n");
    check(
        &[("a.js", &script)],
        &[&reported.replace("warning", "error")],
    );
    check(
        &[(
            "a.js",
            &script.replace("s, shader", "s, '#version 300 es\\n' + shader"),
        )],
        &[],
    );
}

#[test]
fn whitespace_before_a_version_matters_unless_trimmed() {
    let page = format!(
        "<script id=\"f\" type=\"x-shader/x-fragment\">\n#version 300 es\n{NEW}</script>\n\
        <script src=\"read.js\"></script>\n"
    );
    let reported = "2:1: warning[version-placement]: `#version 300 es` must be on the first line, not after a blank line";
    check(&[("a.html", &page)], &[reported]);
    let keeps = "const read = id => gl.shaderSource(s, document.getElementById(id).textContent);";
    let trims =
        "const read = id => document.getElementById(id).textContent.replace(/^\\s+|\\s+$/g, '');";
    check(
        &[("a.html", &page), ("read.js", keeps)],
        &[&reported.replace("warning", "error")],
    );
    check(&[("a.html", &page), ("read.js", trims)], &[]);
    let imports = "import { read } from './lib/text';";
    let files = [
        ("a.html", &*page),
        ("read.js", imports),
        ("lib/text.ts", trims),
    ];
    check(&files, &[]);
}

#[test]
fn markdown_has_errors_only_in_complete_shaders() {
    let text = "```glsl\nfloat step(float edge, float x)\nvec2 step(vec2 edge, vec2 x)\n```\n\n\
        ```glsl\nThe function is called twice.\n```\n\n\
        ```glsl\nfloat f(vec2 p) { return p; }\n```\n\n\
        ```glsl\nprecision highp float;\nvoid main() { gl_FragColor = vec3(1.0); }\n```\n";
    check(
        &[("a.md", text)],
        &[
            "16:15: error[vector-size]: cannot assign `vec3` to `vec4`",
            "11:19: warning[vector-size]: expected return value of type `float`, found `vec2`",
        ],
    );
}

#[test]
fn sksl_is_recognised_by_its_types() {
    let code = "uniform shader image;\nhalf4 main(float2 p) { return image.eval(p); }\n";
    check(
        &[("a.glsl", code)],
        &["1:1: info[unsupported-version]: WebGL does not support SkSL"],
    );
}

#[test]
fn rules_run_where_names_are_unknown() {
    let code = "uniform sampler2D image;
varying vec2 uv;
void main() {
    vec3 c = shade(uv);
    float k = clamp(0.0, 1.0, uv.x);
    float late = 1.0 / (c.x - c.x);
    for (int i = 0; i < STEPS; i++) k *= 0.5;
#ifdef FOG
    float fog;
    k *= fog;
#endif
    while (k > 0.0) k -= step(c.x, k);
    gl_FragColor = vec4(c, k * late);
}
";
    check(
        &[("a.glsl", code)],
        &[
            "4:14: info[undeclared-name]: 2 names are not declared in this file: `STEPS`, `shade`",
            "5:15: warning[clamp-bounds]: arguments of `clamp` appear to be in the wrong order",
        ],
    );
}

#[test]
fn functions_of_files_that_a_script_joins_are_found() {
    let shader = "precision highp float;\nvoid main() { gl_FragColor = vec4(glow(1.0)); }\n";
    let part = ("part.glsl", "float glow(float x) { return x * x; }\n");
    let of = |severity: &str| {
        format!("2:35: {severity}[undeclared-name]: function `glow` is not declared")
    };
    check(
        &[("a.frag", shader), part, ("package.json", "{}")],
        &[&of("error")],
    );
    let script = "load(['part.glsl', 'a.frag'].map((path) => fetch(path)));";
    let files = [
        ("a.frag", shader),
        part,
        ("a.js", script),
        ("package.json", "{}"),
    ];
    check(&files, &[]);
    // Each may be put before other files.
    let script = "['part.glsl', 'other.frag', 'a.frag'].forEach(load);";
    let other = ("other.frag", "void main() { gl_FragColor = vec4(1.0); }\n");
    let files = [files[0], part, other, ("a.js", script), files[3]];
    check(&files, &[&of("warning")]);
}

const LACKING: &str =
    "varying vec2 vUv;\nvoid main() { gl_FragColor = vec4(vUv, uAmount, uBase); }\n";

#[test]
fn forgotten_declarations_are_those_of_scripts_and_of_other_shaders() {
    let base = (
        "other.frag",
        "precision mediump float;\nuniform float uBase;\nvoid main() { gl_FragColor = vec4(uBase); }\n",
    );
    let warnings = |at: [&str; 2]| {
        [
            format!(
                "{}: warning[undeclared-name]: `uAmount` is not declared",
                at[0]
            ),
            format!(
                "{}: warning[undeclared-name]: `uBase` is not declared",
                at[1]
            ),
        ]
    };
    let script = |more: &str| {
        format!(
            "export const effect = {{ uniforms: {{ uAmount: {{ value: 1 }}{more} }}, fragmentShader: `{LACKING}` }};\n"
        )
    };
    let both = warnings(["2:40", "2:49"]);
    let both = both.each_ref().map(String::as_str);
    check(&[("a.js", &script(", uBase: { value: 2 }"))], &both);
    check(
        &[("a.js", &script("")), base, ("package.json", "{}")],
        &both,
    );
    // A prelude may declare what nobody sets.
    let listed =
        "2:40: info[undeclared-name]: 2 names are not declared in this file: `uAmount`, `uBase`";
    check(&[("a.js", &script(""))], &[listed]);
    let prelude = ("prelude.glsl", "uniform float uBase;");
    check(
        &[("a.js", &script("")), base, prelude, ("package.json", "{}")],
        &[listed],
    );
}

#[test]
fn functions_that_other_files_overload_have_any_type() {
    let own = "struct Box { vec2 a; vec2 b; };\nBox turn(Box box, mat2 by) { return Box(turn(box.a, by), turn(box.b, by)); }\n";
    let note = "expected `Box` as argument 1 of `turn`, found `vec2`";
    let warnings = [
        format!("2:46: warning[argument-mismatch]: {note}"),
        format!("2:63: warning[argument-mismatch]: {note}"),
    ];
    check(&[("a.glsl", own)], &warnings.each_ref().map(String::as_str));
    let other = ("b.glsl", "vec2 turn(vec2 at, mat2 by) { return by * at; }");
    check(&[("a.glsl", own), other, ("package.json", "{}")], &[]);
}

#[test]
fn unknown_macros_may_call_their_arguments() {
    let code = "float f(float x) { return x; }\nvoid main() { float a = PLOT(f, 0.1); }\n";
    check(
        &[("a.glsl", &format!("#pragma include <plot>\n{code}"))],
        &["3:25: info[undeclared-name]: `PLOT` is not declared in this file"],
    );
}

#[test]
fn directives_that_a_program_reads_are_not_errors() {
    let code = "precision highp float;\n#value uTime:1.0\nuniform float uTime;\nvoid main() { gl_FragColor = vec4(uTime); }\n";
    let reported = "2:1: error[bad-directive]: unknown directive `#value`";
    check(&[("a.frag", code)], &[reported]);
    let plugin = ("plugin.js", "const glsl = s => s.replace(/#value.+/g, '');");
    check(&[("a.frag", code), plugin, ("package.json", "{}")], &[]);
}

#[test]
fn other_branches_of_macros_of_a_host_are_warnings() {
    let code =
        "vec3 f(vec4 texel) {\n#ifdef PACKED\nreturn texel.rgb;\n#else\nreturn texel;\n#endif\n}\n";
    let warning = "5:1: warning[vector-size]: expected return value of type `vec3`, found `vec4`";
    check(&[("a.glsl", code)], &[warning]);
}

#[test]
fn macros_in_scripts_may_be_expressions() {
    check(
        &[(
            "a.js",
            "m.defines.KEEP = /* glsl */ `bool[](${all.join(', ')})`;\n",
        )],
        &[],
    );
}

#[test]
fn modules_that_are_not_installed_may_declare_functions() {
    let code = "import { shaderMaterial } from '@react-three/drei';\nconst M = shaderMaterial({ uTime: 0 },\n\
        glsl`varying vec2 vUv; void main() { vUv = uv; gl_Position = vec4(position, 1.0); }`,\n\
        glsl`#pragma glslify: noise = require(glsl-noise/classic/3d.glsl)\nuniform float uTime;\nvarying vec2 vUv;\n\
        void main() { gl_FragColor = vec4(noise(vec3(vUv, uTime)));\n#include <colorspace_fragment>\n}`);\n";
    check(
        &[("a.jsx", code), ("package.json", "{}")],
        &["7:35: info[undeclared-name]: `noise` is not declared in this file"],
    );
}

#[test]
fn errors_in_test_cases_are_warnings() {
    let shader =
        "const code = `void mainImage(out vec4 c, in vec2 p) { c = texture2D(iChannel0, p); }`;\n";
    let found = "1:59: error[legacy-glsl]: `texture2D` was removed in GLSL ES 3.00";
    check(&[("a.js", shader)], &[found]);
    let tested = format!("{shader}it('converts', () => expect(convert(code)).toBe(1));\n");
    check(&[("a.js", &tested)], &[&found.replace("error", "warning")]);
}

#[test]
fn functions_of_extensions_are_warnings_if_a_program_adds_the_directive() {
    let code = "precision highp float;\nvarying vec2 v;\nvoid main() { gl_FragColor = vec4(fwidth(v.x)); }\n";
    let found = "3:35: error[needs-webgl2]: `fwidth` requires GLSL ES 3.00";
    check(&[("a.glsl", code)], &[found]);
    let program = (
        "b.js",
        "shader = '#extension GL_OES_standard_derivatives : enable\\n' + shader;",
    );
    let lowered = found.replace("error", "warning");
    check(
        &[("a.glsl", code), program, ("package.json", "{}")],
        &[&lowered],
    );
}
