//! `shaderport --repair`: what it repairs, and that it never breaks what compiles.
#![cfg(unix)]

use crate::port::Folder;
use std::fs;
use std::path::{Path, PathBuf};

/// Repairs a shader, which must then compile, and returns its new text and the messages.
#[track_caller]
fn repaired(name: &str, code: &str) -> (String, String) {
    let folder = Folder::new();
    folder.put(name, code);
    let (exit, message) = folder.run(&format!("{name} --repair --verify -t glsl -o out.frag"));
    assert_eq!(exit, Some(0), "{code}\n{message}");
    let diff = folder.command(&format!("{name} --diff")).output().unwrap();
    let diff = String::from_utf8(diff.stdout).unwrap();
    let lines = diff.lines().skip(2).filter(|l| l.starts_with('+'));
    let lines = lines.map(|l| format!("{}\n", l.trim_start_matches('+')));
    (lines.collect(), message)
}

/// Checks that the new lines of a repaired shader contain some texts.
#[track_caller]
fn check(name: &str, code: &str, expected: &[&str]) {
    let (lines, message) = repaired(name, code);
    for text in expected {
        assert!(lines.contains(text), "no `{text}` in\n{lines}\n{message}");
    }
}

/// A name of the shader that GLSL ES 3.00 takes gets another name.
#[test]
fn names_that_the_newer_version_takes_are_replaced() {
    let (lines, message) = repaired(
        "sampler.frag",
        "#ifdef GL_ES\nprecision mediump float;\n#endif\nuniform sampler2D texture;\nvarying vec2 uv;\n\
         #define LOOK(p) texture2D(texture, p)\n\
         void main() { gl_FragColor = LOOK(uv) + texture2D(texture, uv); }\n",
    );
    assert!(lines.contains("uniform sampler2D myTexture;"), "{lines}");
    assert!(lines.contains("texture(myTexture, p)"), "{lines}");
    let renamed = "repaired: replace `texture` with `myTexture`";
    assert!(message.contains(renamed), "{message}");
    let note = "the code that sets it must use the new name";
    assert!(message.contains(note), "{message}");
    check(
        "words.frag",
        "precision highp float;\nfloat smooth(float x) { return x * x; }\n\
         float flat(vec2 sample) { return sample.x; }\nfloat uint(float x) { return floor(x); }\n\
         void main() {\n    float centroid = smooth(2.0);\n    \
         gl_FragColor = vec4(flat(vec2(centroid)), uint(1.0), 0.0, 1.0);\n}\n",
        &[
            "flatValue(vec2(myCentroid))",
            "float mySmooth(float x)",
            "myUint(1.0)",
        ],
    );
    check(
        "toy.glsl",
        "struct S { float centroid, patch; };\n#define SQUARE(x) smooth(x)\n\
         float smooth(float x) { return x * x; }\nfloat flat(float x) { return x; }\n\
         vec4 blur(sampler2D texture, vec2 p) { return texture2D(texture, p); }\n\
         void mainImage(out vec4 c, in vec2 p) {\n    S s;\n    s.centroid = SQUARE(p.x);\n    \
         s.patch = flat(1.0);\n    c = blur(iChannel0, p) * s.centroid * s.patch;\n}\n",
        &[
            "#define SQUARE(x) smoothValue(x)",
            "sampler2D myTexture, vec2 p) { return texture(myTexture, p); }",
            "s.centroidValue = SQUARE(p.x)",
            "s.patchValue = flatValue(1.0)",
        ],
    );
}

/// What compiles as WebGL1 is left if it cannot be converted.
#[test]
fn what_cannot_be_converted_is_left() {
    let folder = Folder::new();
    let code = "#if __VERSION__ != 100\n#error expected GLSL ES 1.00\n#endif\nprecision highp float;\n\
                void main() { gl_FragColor = vec4(1.0); }\n";
    folder.put("old.frag", code);
    let (exit, message) = folder.run("old.frag --repair -o out.frag");
    assert_eq!(exit, Some(0), "{message}");
    let note = "note: not converted to GLSL ES 3.00 because it tests `__VERSION__`";
    assert!(message.contains(note), "{message}");
    assert!(!message.contains("repaired:"), "{message}");
}

/// Errors are repaired in the version that the shader is written in before it is converted.
#[test]
fn errors_of_webgl1_are_repaired_before_the_conversion() {
    check(
        "old.frag",
        "precision highp float;\nuniform float time;\nfloat sample(float x) { return x * 2; }\n\
         void main() { gl_FragColor = vec4(sample(time)); }\n",
        &[
            "mySample(float x) { return x * 2.0; }",
            "fragColor = vec4(mySample(time));",
        ],
    );
}

/// Initial values move to `main`, also if macros supply them.
#[test]
fn initial_values_from_macros_move() {
    check(
        "desktop.frag",
        "#version 330\nuniform vec2 resolution;\nuniform float time;\nout vec4 c;\n#define res resolution\n\
         #define T time\nvec2 p = gl_FragCoord.xy / res;\nfloat t = T, u = t * 2.0;\n\
         void main() { c = vec4(p, t, u); }\n",
        &[
            "vec2 p;",
            "float t, u;",
            "p = gl_FragCoord.xy / res;",
            "t = T;",
            "u = t * 2.0;",
        ],
    );
    check(
        "toy.glsl",
        "#define WIDE (1.0 / iResolution.xy)\nvec2 pixel = WIDE;\n\
         void mainImage(out vec4 c, in vec2 p) { c = vec4(p * pixel, 0.0, 1.0); }\n",
        &["vec2 pixel;", "    pixel = WIDE;"],
    );
    // Here the macro means something else in `main`.
    let folder = Folder::new();
    folder.put(
        "two.frag",
        "#version 330\nuniform float time;\nout vec4 c;\n#define T time\nfloat t = T;\n#undef T\n\
         #define T 2.0\nvoid main() { c = vec4(t * T); }\n",
    );
    assert_eq!(folder.run("two.frag --repair -o out.frag").0, Some(1));
}

/// Integers become floats where they are used as such: in arguments, in the bodies of macros, and at the use
/// of a macro that is an integer elsewhere.
#[test]
fn integers_in_macros_are_converted() {
    check(
        "both.frag",
        "#version 330\nout vec4 c;\n#define N 3\n#define SQUARE(x) ((x) * (x))\n#define POWER(a) pow(a, 2)\n\
         #define MORE N + 1\n\
         float list[N];\nvoid main() {\n    float x = N;\n    \
         for (int i = 0; i < N; i++) { list[i] = i; x += list[i] * N; }\n    \
         x += SQUARE(2) * 1.5;\n    int k = SQUARE(3) + MORE;\n    \
         c = vec4(x, POWER(x), SQUARE(k), max(x, N));\n}\n",
        &[
            "float x = float(N);",
            "x += list[i] * float(N);",
            "x += float(SQUARE(2)) * 1.5;",
            "pow(a, 2.0)",
            "max(x, float(N))",
        ],
    );
    check(
        "toy.glsl",
        "#define rot(a) mat2(cos(a), -sin(a), sin(a), cos(a))\n#define ONE 1\n#define wave(t) (ONE - fract(t * 2))\n\
         void mainImage(out vec4 c, in vec2 p) {\n    int n = ONE + int(p.x) % 2;\n    p *= rot(1);\n    p *= rot(n);\n    \
         c = vec4(p, wave(iTime), 1);\n}\n",
        &[
            "p *= rot(1.0);",
            "p *= rot(float(n));",
            "(float(ONE) - fract(t * 2.0))",
        ],
    );
}

/// WebGL2 refuses `? :` between structs and arrays.
#[test]
fn choices_of_structs_and_arrays_become_branches() {
    check(
        "choice.frag",
        "#version 330\nout vec4 c;\nstruct S { float a; vec3 b; };\n\
         S f(float x) {\n    S a = S(x, vec3(1)), b = S(2 * x, vec3(0));\n    return x > 1 ? a : b;\n}\n\
         void main() {\n    float u[2] = float[2](1, 2);\n    float v[2] = float[2](3, 4);\n    \
         float w[2] = gl_FragCoord.x > 9 ? u : v;\n    S s = f(gl_FragCoord.x), t = s;\n    \
         if (s.a > 1) s = s.a > 2 ? t : f(2);\n    else s.a = 2;\n    \
         c = vec4(w[0], s.a, (s.a > 3 ? s : t).b.x, 1);\n}\n",
        &[
            "{ if (x > 1.0) return a; else return b; }",
            "float w[2]; if (gl_FragCoord.x > 9.0) w = u; else w = v;",
            "if (s.a > 1.0) { if (s.a > 2.0) s = t; else s = f(2.0); }",
            "S choose(bool condition, S yes, S no)",
            "(choose(s.a > 3.0, s, t)).b.x",
        ],
    );
}

fn shaders_in(folder: &Path, found: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> = fs::read_dir(folder)
        .unwrap()
        .map(|e| e.unwrap().path())
        .collect();
    entries.sort();
    for path in entries {
        let extension = path.extension().and_then(|e| e.to_str());
        if path.is_dir() {
            shaders_in(&path, found);
        } else if matches!(extension, Some("glsl" | "frag" | "fs")) {
            found.push(path);
        }
    }
}

/// No shader of this repository that compiles is refused after repairs.
#[test]
fn repairs_break_nothing() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut all = Vec::new();
    for folder in ["tests/fixtures", "corpus"] {
        shaders_in(&root.join(folder), &mut all);
    }
    let folder = Folder::new();
    let mut compiling = 0;
    for path in &all {
        let path = path.display();
        let plain = folder.run(&format!("{path} -t glsl -o out.frag --force"));
        if plain.0 != Some(0) {
            continue;
        }
        compiling += 1;
        let (exit, message) = folder.run(&format!("{path} -t glsl -o out.frag --force --repair"));
        assert_eq!(exit, Some(0), "{path}: {message}");
    }
    assert!(compiling > 50, "{compiling} of {}", all.len());
}
