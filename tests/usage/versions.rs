//! `target-version`: shaders in GLSL ES 1.00 are converted, both stages or none.

use crate::scratch::Scratch;

const TARGET: &str = "target-version = \"300 es\"\n";
const VERTEX: &str = "attribute vec3 at;\nvarying vec2 uv;\n\
    void main() {\n    uv = at.xy;\n    gl_Position = vec4(at, 1.0);\n}\n";
const FRAGMENT: &str = "precision highp float;\nuniform sampler2D image;\nvarying vec2 uv;\n\
    void main() {\n    gl_FragColor = texture2D(image, uv);\n}\n";
const NEW_VERTEX: &str = "#version 300 es\nin vec3 at;\nout vec2 uv;\n\
    void main() {\n    uv = at.xy;\n    gl_Position = vec4(at, 1.0);\n}\n";
const NEW_FRAGMENT: &str = "#version 300 es\nprecision highp float;\nout vec4 fragColor;\n\
    uniform sampler2D image;\nin vec2 uv;\n\
    void main() {\n    fragColor = texture(image, uv);\n}\n";

fn pair(vertex: &str, fragment: &str) -> Scratch {
    Scratch::new(&[
        ("shaderlint.toml", TARGET),
        ("a.vert", vertex),
        ("a.frag", fragment),
    ])
}

#[test]
fn both_stages_are_converted() {
    let scratch = pair(VERTEX, FRAGMENT);
    scratch.run(&["--fix", "."]);
    assert_eq!(scratch.read("a.vert"), NEW_VERTEX);
    assert_eq!(scratch.read("a.frag"), NEW_FRAGMENT);
    assert_eq!(scratch.run(&["."]).code, 0);
}

#[test]
fn stages_are_converted_together_or_not_at_all() {
    let tested = format!("#if __VERSION__ == 100\n#endif\n{FRAGMENT}");
    for (vertex, fragment) in [
        (VERTEX, &*tested),
        (
            &*format!("#if __VERSION__ == 100\n#endif\n{VERTEX}"),
            FRAGMENT,
        ),
    ] {
        let scratch = pair(vertex, fragment);
        let ran = scratch.run(&["--fix", "."]);
        assert_eq!(scratch.read("a.vert"), vertex, "{}", ran.out);
        assert_eq!(scratch.read("a.frag"), fragment, "{}", ran.out);
        assert!(ran.out.contains("it tests `__VERSION__`"), "{}", ran.out);
        let other = "shader cannot be";
        assert!(ran.out.contains(other), "{}", ran.out);
    }
}

/// The file of the other stage is not changed if it is not named.
#[test]
fn stages_that_were_not_converted_are_reported() {
    let scratch = pair(VERTEX, FRAGMENT);
    let ran = scratch.run(&["--fix", "a.frag"]);
    assert_eq!(scratch.read("a.vert"), VERTEX);
    assert_eq!(scratch.read("a.frag"), NEW_FRAGMENT);
    assert!(ran.out.contains("warning[link-version]"), "{}", ran.out);
    assert!(
        ran.out.contains("convert the vertex shader too"),
        "{}",
        ran.out
    );
    let scratch = pair(VERTEX, FRAGMENT);
    let ran = scratch.run(&["--fix", "a.vert"]);
    assert_eq!(scratch.read("a.vert"), NEW_VERTEX);
    assert!(
        ran.out.contains("convert the fragment shader too"),
        "{}",
        ran.out
    );
}

#[test]
fn both_stages_of_a_page_are_converted() {
    let page = |vertex: &str, fragment: &str, context: &str| {
        format!(
            "<script id=\"v\" type=\"x-shader/x-vertex\">{vertex}</script>\n\
             <script id=\"f\" type=\"x-shader/x-fragment\">{fragment}</script>\n\
             <script>const gl = canvas.getContext(\"{context}\");</script>\n"
        )
    };
    let check = |before: &str, after: &str, said: &str| {
        let scratch = Scratch::new(&[("shaderlint.toml", TARGET), ("a.html", before)]);
        let ran = scratch.run(&["--fix", "a.html"]);
        assert_eq!(scratch.read("a.html"), after, "{}", ran.out);
        assert!(ran.out.contains(said), "{}", ran.out);
    };
    check(
        &page(VERTEX, FRAGMENT, "webgl2"),
        &page(NEW_VERTEX, NEW_FRAGMENT, "webgl2"),
        "",
    );
    let old = page(VERTEX, FRAGMENT, "webgl");
    check(&old, &old, "a WebGL1 context compiles it");
}

/// A string in one line takes no `#version`, so that the other stage keeps its version too.
#[test]
fn strings_on_one_line_are_not_converted() {
    let line = "attribute vec3 at; void main() { gl_Position = vec4(at, 1.0); }";
    let script = format!(
        "const v = \"{line}\";\nconst f = `{FRAGMENT}`;\n\
         const gl = canvas.getContext(\"webgl2\");\n\
         function make(type, text) {{\n  const s = gl.createShader(type);\n  \
         gl.shaderSource(s, text);\n  gl.compileShader(s);\n}}\n\
         make(gl.VERTEX_SHADER, v); make(gl.FRAGMENT_SHADER, f);\n"
    )
    .replace("varying vec2 uv;\n", "")
    .replace("uv)", "vec2(0.5))");
    let scratch = Scratch::new(&[("shaderlint.toml", TARGET), ("a.js", &script)]);
    let ran = scratch.run(&["--fix", "a.js"]);
    assert_eq!(scratch.read("a.js"), script, "{}", ran.out);
    assert!(ran.out.contains("a string in one line"), "{}", ran.out);
    assert!(
        ran.out.contains("the vertex shader cannot be"),
        "{}",
        ran.out
    );
}

/// A varying that hides a lookup function of one stage has no new name in the other.
#[test]
fn varyings_keep_the_same_name_in_both_stages() {
    let vertex = VERTEX.replace("uv", "texture");
    let fragment = FRAGMENT.replace("uv", "texture");
    let scratch = pair(&vertex, &fragment);
    scratch.run(&["--fix", "--unsafe-fixes", "."]);
    assert_eq!(scratch.read("a.vert"), vertex);
    assert_eq!(scratch.read("a.frag"), fragment);
}

#[test]
fn conversions_that_rename_are_not_applied() {
    let text = FRAGMENT.replace("image", "texture");
    let scratch = Scratch::new(&[("shaderlint.toml", TARGET), ("a.frag", &text)]);
    let ran = scratch.run(&["--fix", "a.frag"]);
    assert_eq!(scratch.read("a.frag"), text);
    assert!(
        ran.out.contains("renames `texture` to `myTexture`"),
        "{}",
        ran.out
    );
    scratch.run(&["--fix", "--unsafe-fixes", "a.frag"]);
    assert_eq!(
        scratch.read("a.frag"),
        NEW_FRAGMENT.replace("image", "myTexture")
    );
}

#[test]
fn conversion_requires_a_target_version() {
    let overridden =
        format!("{TARGET}[[overrides]]\npaths = [\"old\"]\ntarget-version = \"any\"\n");
    for config in ["", &overridden] {
        let scratch = Scratch::new(&[("shaderlint.toml", config), ("old/a.frag", FRAGMENT)]);
        let ran = scratch.run(&["."]);
        assert!(!ran.out.contains("old-version"), "{}", ran.out);
    }
    // ShaderToy's code has no version of its own.
    let toy = "void mainImage(out vec4 c, in vec2 p) { c = vec4(p, iTime, 1.0); }\n";
    let scratch = Scratch::new(&[("shaderlint.toml", TARGET), ("a.glsl", toy)]);
    assert!(!scratch.run(&["a.glsl"]).out.contains("old-version"));
}
