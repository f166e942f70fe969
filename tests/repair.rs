//! `shaderport --repair`: what it repairs, and that it never breaks what compiles.
#![cfg(unix)]

use crate::port::with_shader;
use std::fs;
use std::path::{Path, PathBuf};

/// Repairs a shader, which must then compile, and returns its new text and the messages.
#[track_caller]
fn repaired(name: &str, code: &str) -> (String, String) {
    let folder = with_shader();
    folder.write(name, code);
    let (exit, message) = folder.port(&format!("{name} --repair --verify -t glsl -o out.frag"));
    assert_eq!(exit, Some(0), "{code}\n{message}");
    let diff = folder
        .port_command(&format!("{name} --diff"))
        .output()
        .unwrap();
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
fn names_that_glsl_es_3_reserves_are_replaced() {
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
fn webgl1_shaders_that_cannot_be_converted_are_kept() {
    let folder = with_shader();
    let code = "#if __VERSION__ != 100\n#error expected GLSL ES 1.00\n#endif\nprecision highp float;\n\
                void main() { gl_FragColor = vec4(1.0); }\n";
    folder.write("old.frag", code);
    let (exit, message) = folder.port("old.frag --repair -o out.frag");
    assert_eq!(exit, Some(0), "{message}");
    let note = "note: not converted to GLSL ES 3.00 because it tests `__VERSION__`";
    assert!(message.contains(note), "{message}");
    assert!(!message.contains("repaired:"), "{message}");
}

/// Errors are repaired in the version that the shader is written in before it is converted.
#[test]
fn webgl1_errors_are_repaired_before_the_conversion() {
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
fn initial_values_from_macros_move_to_main() {
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
    let folder = with_shader();
    folder.write(
        "two.frag",
        "#version 330\nuniform float time;\nout vec4 c;\n#define T time\nfloat t = T;\n#undef T\n\
         #define T 2.0\nvoid main() { c = vec4(t * T); }\n",
    );
    assert_eq!(folder.port("two.frag --repair -o out.frag").0, Some(1));
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
fn conditionals_of_structs_and_arrays_become_branches() {
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

/// A choice in the body of a macro becomes a call there, with a function for each type of its uses.
#[test]
fn conditionals_in_macros_become_function_calls() {
    check(
        "macro.frag",
        "#version 330\nuniform float t;\nout vec4 c;\nstruct S { float d; vec3 col; };\n\
         struct M { float d; int id; };\n#define PICK(a, b) ((a).d < (b).d ? (a) : (b))\n\
         #define MIN(a, b) ((a) < (b) ? (a) : (b))\n#define OR(x, a, b) x ? a : b\n\
         #define FIRST t > 1 ? s : e\n#define NEST(a, b, e) PICK(PICK(a, b), e)\n\
         M ground(float x) { M m = M(x, 1), n = M(2 * x, 2); return PICK(m, n); }\n\
         S map(vec3 p) {\n    S s = S(length(p), vec3(1)), e = S(p.y, vec3(0));\n    S u = NEST(s, e, s);\n    \
         float r[2] = float[2](1, 2), q[2] = float[2](3, 4);\n    float w[2] = OR(p.x > 1, r, q);\n    \
         u.d += w[0] + (p.y > 2 ? r : q)[1] + ground(t).d;\n    return PICK(u, s);\n}\n\
         void main() {\n    S s = map(vec3(gl_FragCoord.xy, 1)), e = S(2.0, vec3(0.5)), u = FIRST;\n    \
         float x = PICK(s, e).d + MIN(s.d, t) + OR(t > 1, 2, t);\n    c = vec4(s.col, x + u.d);\n}\n",
        &[
            "#define PICK(a, b) (choose((a).d < (b).d, (a), (b)))",
            "#define OR(x, a, b) choose2(x, a, b)",
            "#define FIRST choose(t > 1.0, s, e)",
            "M choose(bool condition, M yes, M no)",
            "S choose(bool condition, S yes, S no)",
            "float[2] choose(bool condition, float[2] yes, float[2] no)",
            "float choose2(bool condition, float yes, float no)",
            "(choose(p.y > 2.0, r, q))[1]",
        ],
    );
    // A function that computes both values would run `f` each time.
    let folder = with_shader();
    folder.write(
        "calls.frag",
        "#version 330\nuniform float t;\nout vec4 c;\nstruct S { float d; };\n\
         #define OR(x, a, b) x ? a : b\nS f(inout float x) { x += 1.0; return S(x); }\n\
         void main() { float x = t; S s = S(t); x += (OR(t > 1.0, f(x), s)).d; c = vec4(x); }\n",
    );
    assert_eq!(folder.port("calls.frag --repair -o out.frag").0, Some(1));
}

/// Where a function has overloads for integers and floats, desktop GLSL converts the integers.
#[test]
fn integer_arguments_beside_floats_are_converted() {
    check(
        "overloads.frag",
        "#version 330\nuniform float x;\nuniform int i;\nuniform uint u;\nuniform vec2 p;\nuniform ivec2 q;\n\
         out vec4 c;\n#define PI acos(-1)\n#define LOW(v) max(v, 0.5)\nfloat own(float a) { return a; }\n\
         float own(vec2 a) { return a.x; }\nvoid main() {\n    \
         c.x = min(x, i) + max(i, 1.5) + clamp(i, 0, x) + clamp(0, i, 0.5) + PI / 4;\n    \
         c.yz = min(p, q) + max(p, i) + vec2(lessThan(p, q)) + min(q, x);\n    \
         c.w = LOW(i) + LOW(x) + float(max(u, 1)) + own(i) + own(q) + mix(0, 1, x) + min(u, x);\n}\n",
        &[
            "min(x, float(i)) + max(float(i), 1.5) + clamp(float(i), 0.0, x) + clamp(0.0, float(i), 0.5) + PI / 4.0",
            "min(p, vec2(q)) + max(p, float(i)) + vec2(lessThan(p, vec2(q))) + min(vec2(q), x)",
            "LOW(float(i)) + LOW(x) + float(max(u, 1u)) + own(float(i)) + own(vec2(q)) + mix(0.0, 1.0, x)",
        ],
    );
}

/// `--channel` finds a sampler that was renamed by its old name and by its new one.
#[test]
fn renamed_samplers_are_found_by_both_names() {
    let folder = with_shader();
    let png = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/browser/page.png");
    fs::copy(png, folder.path("photo.png")).unwrap();
    let old = "precision mediump float;\nuniform sampler2D texture;\nvarying vec2 uv;\n\
               void main() { gl_FragColor = texture2D(texture, uv); }\n";
    let broken = "uniform sampler2D texture, sample;\nuniform vec2 resolution;\nuniform float time;\n\
                  void main() {\n    vec2 uv = gl_FragCoord.xy / resolution;\n    \
                  gl_FragColor = texture2D(texture, uv) + texture2D(sample, uv) * 2;\n}\n";
    let desktop = "#version 330\nuniform sampler2D sample;\nout vec4 c;\n\
                   void main() { c = texture(sample, gl_FragCoord.xy); }\n";
    for (name, code, sampler, new) in [
        ("old.frag", old, "texture", "myTexture"),
        ("broken.frag", broken, "texture", "myTexture"),
        ("broken.frag", broken, "sample", "sampleColor"),
        ("desktop.frag", desktop, "sample", "sampleColor"),
    ] {
        folder.write(name, code);
        for sampler in [sampler, new] {
            let channel = format!("--channel {sampler}=photo.png");
            let command = format!("{name} --repair {channel} -o out.html --force");
            let (exit, message) = folder.port(&command);
            assert_eq!(exit, Some(0), "{name} {sampler}: {message}");
            assert!(message.contains("embedded photo.png"), "{message}");
        }
        let command = format!("{name} --repair --channel other=photo.png -o out.html --force");
        let (exit, message) = folder.port(&command);
        assert!(exit != Some(0) && message.contains(new), "{message}");
    }
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
fn repaired_shaders_still_compile() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut all = Vec::new();
    for folder in ["tests/fixtures", "corpus"] {
        shaders_in(&root.join(folder), &mut all);
    }
    let folder = with_shader();
    let mut compiling = 0;
    for path in &all {
        let path = path.display();
        let plain = folder.port(&format!("{path} -t glsl -o out.frag --force"));
        if plain.0 != Some(0) {
            continue;
        }
        compiling += 1;
        let (exit, message) = folder.port(&format!("{path} -t glsl -o out.frag --force --repair"));
        assert_eq!(exit, Some(0), "{path}: {message}");
    }
    assert!(compiling > 50, "{compiling} of {}", all.len());
}
