//! `types` and `reflect`: the text of declarations, which files are written, and what is refused. Whether they
//! compile, and what they set, is tested in `tests/browser/types.js`.

use super::scratch::Scratch;
use insta::assert_snapshot;

const VERTEX: &str = "#version 300 es
in vec3 position;
layout(location = 2) in vec2 uv;
uniform mat3 uTurn; // of the camera
out vec2 vUv;
flat out int vCount;
#ifdef FOG
out float vFog;
#endif
void main() { vUv = uv; vCount = 1; gl_Position = vec4(uTurn * position, 1.0); }
";
const FRAGMENT: &str = "#version 300 es
precision mediump float;
#include \"lib/lamps.glsl\"
#ifndef STEPS
#define STEPS 8
#endif
#define OWN
#if defined(OWN) && defined(QUALITY)
#endif
in vec2 vUv;
in float vUnused;
uniform highp vec3 uColor; // sRGB */
uniform float uLong[20], uShort[2];
uniform bvec2 uFlags;
uniform uint uSeed;
uniform sampler2D uMaps[2];
#ifdef FOG
uniform vec2 uFog; // near, far
#endif
uniform Scene { vec4 fog; float steps[3]; Lamp lamp; } scenes[2];
layout(location = 1) out vec4 color;
void main() { color = vec4(uColor + uLamp.color + scenes[0].fog.rgb, uLong[1] + uShort[0] + vUv.x + float(uSeed) + float(uFlags.x)) * texture(uMaps[0], vUv); }
";
const LAMPS: &str = "struct Lamp { vec3 color; float power; };
uniform Lamp uLamp;
";

fn project() -> Scratch {
    Scratch::new(&[
        ("src/a.vert", VERTEX),
        ("src/a.frag", FRAGMENT),
        ("src/lib/lamps.glsl", LAMPS),
    ])
}

#[test]
fn declarations_are_written_beside_shaders() {
    let scratch = project();
    let ran = scratch.run(&["types"]);
    assert_eq!((ran.code, ran.out.as_str()), (0, ""), "{}", ran.err);
    assert_eq!(ran.err, "shaderlint: 3 files written\n");
    assert_snapshot!("fragment", scratch.read("src/a.frag.d.ts"));
    assert_snapshot!("vertex", scratch.read("src/a.vert.d.ts"));
    assert!(
        scratch
            .read("src/lib/lamps.glsl.d.ts")
            .contains("stage: \"none\"")
    );
    let ran = scratch.run(&["types", "src"]);
    assert_eq!(ran.err, "shaderlint: 3 files up to date\n");
    // Declarations are no shaders.
    assert_eq!(scratch.run(&["--no-cache", "."]).code, 0);
}

#[test]
fn stale_declarations_are_listed() {
    let scratch = project();
    scratch.run(&["types"]);
    scratch.write(
        "src/a.vert",
        VERTEX
            .replace("mat3 uTurn", "mat3 uTurned")
            .replace("uTurn *", "uTurned *"),
    );
    scratch.write("src/b.vert", VERTEX);
    let ran = scratch.run(&["types", "--check"]);
    assert_eq!(ran.code, 1, "{}", ran.err);
    assert_eq!(
        ran.out,
        "src/a.vert.d.ts: not up to date\nsrc/b.vert.d.ts: missing\n"
    );
    assert_eq!(
        ran.err,
        "shaderlint: 2 files not up to date, 2 up to date\n"
    );
    assert!(scratch.read("src/a.vert.d.ts").contains("uTurn:"));
}

#[test]
fn other_files_are_not_overwritten() {
    let scratch = project();
    scratch.write("src/a.vert.d.ts", "export default 1;\n");
    scratch.write("gl.ts", "// mine\n");
    let ran = scratch.run(&["types", "src/a.vert", "--helpers", "gl.ts"]);
    assert_eq!(ran.code, 2);
    let refused = "not written: the file is not one that `shaderlint types` wrote";
    assert_eq!(
        ran.err,
        format!("shaderlint: src/a.vert.d.ts: {refused}\nshaderlint: gl.ts: {refused}\n")
    );
    assert_eq!(scratch.read("gl.ts"), "// mine\n");
}

#[test]
fn shaders_with_errors_keep_their_declarations() {
    let scratch = project();
    scratch.run(&["types"]);
    scratch.write("src/a.vert", VERTEX.replace("uTurn * position", "uTurn"));
    let ran = scratch.run(&["types", "src/a.vert"]);
    assert_eq!(ran.code, 1);
    assert_eq!(
        ran.err,
        "shaderlint: src/a.vert: 1 shader with errors; `shaderlint src/a.vert` lists them\n"
    );
    // An error of linking is one of both stages.
    scratch.write("src/a.vert", VERTEX.replace("vUv", "vUV"));
    let ran = scratch.run(&["types", "src/a.vert"]);
    assert_eq!(
        (ran.code, ran.err.as_str()),
        (0, "shaderlint: 1 file written\n")
    );
}

#[test]
fn one_module_has_all_shaders() {
    let scratch = project();
    scratch.write("src/a-b.vert", VERTEX);
    scratch.write("src/a_b.vert", VERTEX);
    let ran = scratch.run(&["types", "src", "--module", "src/gen/shaders.ts"]);
    assert_eq!(
        (ran.code, ran.err.as_str()),
        (0, "shaderlint: 1 file written\n")
    );
    let text = scratch.read("src/gen/shaders.ts");
    let index: Vec<&str> = text
        .lines()
        .filter(|line| line.contains(": ShaderText<Shader_"))
        .collect();
    assert_snapshot!("module", index.join("\n"));
    assert!(text.contains("export function setUniforms<"));
}

#[test]
fn declarations_are_printed() {
    let scratch = Scratch::new(&[]);
    let ran = scratch.pipe(
        VERTEX,
        &[
            "types",
            "-",
            "--stdin-filename",
            "a.vert",
            "--uniforms",
            "three",
        ],
    );
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert!(ran.out.contains("import type { Matrix3 } from \"three\";"));
    assert!(
        ran.out.contains("    uTurn: { value: Matrix3 };\n"),
        "{}",
        ran.out
    );
}

#[test]
fn reflection_lists_shaders_of_all_files() {
    let scratch = project();
    let script = "const gl = canvas.getContext('webgl2');\nconst source = `#version 300 es\nprecision highp float;\n\
        uniform float uTime;\nout vec4 color;\nvoid main() { color = vec4(uTime); }\n`;\n";
    scratch.write("main.js", script);
    let ran = scratch.run(&["reflect", "main.js", "src/a.frag"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert_snapshot!("reflection", ran.out);
    let ran = scratch.run(&["reflect", "none.frag"]);
    assert_eq!(ran.code, 2);
}
