//! Versions of the language that WebGL does not have.

use crate::scratch::Scratch;

/// Names of a host for WebGL are no evidence that it runs a later version.
#[test]
fn later_versions_are_refused_also_with_names_of_a_host() {
    for version in ["310 es", "320 es", "450"] {
        let text = format!(
            "#version {version}\nprecision highp float;\nuniform float time;\n\
             uniform vec2 resolution;\nout vec4 c;\n\
             void main() {{ c = vec4(gl_FragCoord.xy / resolution, sin(time), 1.0); }}\n"
        );
        let folder = Scratch::new(&[("a.frag", &text)]);
        let found = folder.places(&["a.frag"]);
        assert_eq!(found, ["1:1 unsupported-version"], "{version}");
    }
}

/// Excerpts of a document are of the version of its shaders, and a script may expect errors.
#[test]
fn excerpts_of_desktop_glsl_and_expected_faults_are_not_changed() {
    let excerpt = "```c\nfloat depth = 4;\nvec4 c = vec4(0.5);\n```\n";
    let chapter = |version: &str| {
        format!(
            "```c\n#version {version}\nout vec4 c;\nvoid main() {{ c = vec4(1); }}\n```\n{excerpt}"
        )
    };
    let script = "it(\"throws\", () => {\n  expect(() => compile(`#version 300 es\nuniform int n;\n\
                  void main() { gl_Position = vec4(1.0 + n); }`)).toThrow();\n});\n";
    let folder = Scratch::new(&[
        ("desktop.md", &chapter("150")),
        ("web.md", &chapter("300 es")),
        ("a.spec.js", script),
    ]);
    assert_eq!(folder.places(&["desktop.md"]), [""; 0]);
    assert!(!folder.places(&["web.md"]).is_empty());
    assert_eq!(folder.places(&["a.spec.js"]), ["4:40 int-float-mix"]);
    let ran = folder.run(&["--fix", "--deny-warnings", "."]);
    assert_eq!(folder.read("a.spec.js"), script, "{}", ran.out);
}
