//! `shaderlint test` with files that it writes and watches.

use crate::scratch::Scratch;
use std::fs;
use std::io::{BufRead, BufReader};
use std::process::{Child, Stdio};

/// The exit code and the text on standard output.
fn test(folder: &Scratch, args: &[&str]) -> (i32, String) {
    let ran = folder.run(&[&["test"], args].concat());
    (ran.code, ran.out)
}

/// Asserts that a text contains each of these.
fn contains(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "{part}\n---\n{text}");
    }
}

const STEPS: &str = "float steps(float x) {
    float y = 0.0;
    for (int i = 0; i < 3; i++) {
        y += x;
    }
    if (y > 4.0) {
        return 4.0;
    }
    return x > 9.0 ? y / x : y;
}
float unused(float x) {
    return x;
}
";

#[test]
fn coverage_counts_lines_and_branches() {
    let tests = "// each: 1, 2, 1.1\nbool test_steps(float x) { return steps(x) <= 4.0; }\n";
    let folder = Scratch::new(&[("steps.glsl", STEPS), ("steps.test.glsl", tests)]);
    let (code, _) = test(&folder, &[".", "--coverage", "out.info"]);
    assert_eq!(code, 0);
    let info = fs::read_to_string(folder.path("out.info")).unwrap();
    contains(
        &info,
        &[
            "SF:steps.glsl\n",
            "FNDA:3,steps\n",
            "FNDA:0,unused\n",
            "FNH:1\n",
        ],
    );
    contains(
        &info,
        &["DA:2,3\n", "DA:4,9\n", "DA:7,1\n", "DA:9,2\n", "DA:12,0\n"],
    );
    contains(
        &info,
        &[
            "BRDA:6,0,0,1\nBRDA:6,0,1,2\n",
            "BRDA:9,0,0,0\nBRDA:9,0,1,2\n",
        ],
    );
    assert!(!info.contains("steps.test.glsl"), "{info}");
    test(
        &folder,
        &[".", "--coverage", "out.txt", "--coverage-format", "json"],
    );
    let json = fs::read_to_string(folder.path("out.txt")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["files"][0]["summary"]["branches"]["covered"], 3);
}

#[test]
fn benchmarks_count_operations() {
    let tests = "// any: x in 0..9\nfloat bench_steps(float x) { return steps(x); }\n\
        bool test_zero() { return steps(0.0) == 0.0; }\n";
    let folder = Scratch::new(&[("steps.glsl", STEPS), ("steps.test.glsl", tests)]);
    let (code, text) = test(&folder, &[".", "--bench"]);
    assert_eq!(code, 0, "{text}");
    contains(&text, &["bench_steps ... ok, ", " operations\n"]);
    let (code, text) = test(&folder, &["."]);
    assert_eq!(code, 0);
    assert!(!text.contains("bench_steps"), "{text}");
}

#[test]
fn textures_and_buffers_are_bound_by_name() {
    let gradient = "void mainImage(out vec4 c, in vec2 p) { c = vec4(floor(p) / 4.0, 0.0, 1.0); }";
    let looks = "uniform sampler2D noise;\nvec4 look(vec2 p) { return texture(noise, p); }\n";
    let tests = "// texture: noise = media/steps.png,nearest\n\
        // each: p = vec2(0.1), vec2(0.9)\n\
        bool test_look(vec2 p) { return approx(look(p).xy, floor(p * vec2(4, 2)) / 4.0, 0.01); }\n\
        bool test_black() { return look(vec2(0.9)).xyz == vec3(0.0); }\n\
        // texture: noise = missing.png\n\
        bool test_missing() { return true; }\n";
    let buffer = "void mainImage(out vec4 c, in vec2 p) {\n\
        c = texelFetch(iChannel0, ivec2(p), 0) + 1.0;\n}\n";
    let image = "float level(vec2 p) { return texelFetch(iChannel0, ivec2(p), 0).x; }\n\
        void mainImage(out vec4 c, in vec2 p) { c = vec4(level(p)); }\n";
    let level = "// texture: iChannel0 = buffer-a at frame 2\n\n\
        bool test_level() { return level(gl_FragCoord.xy) == 3.0; }\n";
    let folder = Scratch::new(&[
        ("gradient.glsl", gradient),
        ("look.glsl", looks),
        ("look.test.glsl", tests),
        ("p/buffer-a.glsl", buffer),
        ("p/image.glsl", image),
        ("p/image.test.glsl", level),
        (
            "p/channels.toml",
            "0 = 'buffer_a'\n[buffer_a]\n0 = 'buffer_a'\n",
        ),
    ]);
    fs::create_dir(folder.path("media")).unwrap();
    let drawn = [
        "run",
        "gradient.glsl",
        "--size",
        "4x2",
        "-o",
        "media/steps.png",
    ];
    assert!(folder.command(&drawn).output().unwrap().status.success());
    let (code, text) = test(&folder, &["look.glsl", "p/image.test.glsl"]);
    assert_eq!(code, 1, "{text}");
    contains(
        &text,
        &["test_look(p = vec2(0.9)) ... ok", "test_black ... ok"],
    );
    contains(&text, &["test_level ... ok", "4 passed, 1 failed"]);
    contains(
        &text,
        &["look.test.glsl:5:21: test_missing: cannot read missing.png: "],
    );
}

#[test]
fn functions_of_vertex_shaders_are_tested() {
    let vertex = "#version 300 es\nin vec2 position;\n\
        vec2 turned(vec2 p) { return vec2(-p.y, p.x); }\n\
        void main() { gl_Position = vec4(turned(position), 0.0, 1.0); }\n";
    let tests = "// any: p in vec2(-3)..vec2(3)\n\
        bool test_turned(vec2 p) { return turned(turned(p)) == -p; }\n\
        bool test_main() { main(); return gl_Position == vec4(0, 0, 0, 1); }\n";
    let folder = Scratch::new(&[
        ("a.vert", vertex),
        ("a.test.vert", tests),
        ("b.vert", vertex),
        ("b.test.glsl", tests),
    ]);
    let (code, text) = test(&folder, &[]);
    assert_eq!(code, 0, "{text}");
    contains(
        &text,
        &[
            "a.test.vert: test_main ... ok",
            "b.test.glsl: test_turned ... ok",
        ],
    );
    contains(&text, &["4 passed, 0 failed"]);
}

#[test]
fn cases_and_seeds_are_reproducible() {
    let tests = "// any: x in 0..1; y in 0..1\n\
        bool test_sum(float x, float y) { return x + y < 1.75 || x == 1.0 || y == 1.0; }\n";
    let folder = Scratch::new(&[("sum.test.glsl", tests)]);
    let with = |args: &[&str]| {
        let args: Vec<&str> = ["."].iter().chain(args).copied().collect();
        test(&folder, &args)
    };
    assert_eq!(with(&[]), with(&["--seed", "0", "--cases", "1000"]));
    assert_ne!(with(&[]), with(&["--seed", "1"]));
    assert_eq!(with(&["--cases", "1"]).0, 0);
}

#[test]
fn only_tests_can_call_approx() {
    let tests = "bool test_one() { return approx(1.0, 1.0); }\n";
    let shader = "void mainImage(out vec4 c, in vec2 p) { c = vec4(approx(1.0, p.x)); }\n";
    let folder = Scratch::new(&[("one.test.glsl", tests), ("shader.glsl", shader)]);
    let lint = |name: &str| folder.command(&[name]).output().unwrap();
    assert_eq!(lint("one.test.glsl").status.code(), Some(0));
    let output = lint("shader.glsl");
    assert_eq!(output.status.code(), Some(1));
    let text = String::from_utf8(output.stdout).unwrap();
    contains(&text, &["`approx`"]);
}

/// A process that ends with the test, also if that fails.
struct Watched(Child);

impl Drop for Watched {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

#[test]
fn changed_files_run_the_tests_that_include_them() {
    let lib = "float one() { return 1.0; }\n";
    let uses = "#include \"lib.glsl\"\nbool test_one() { return one() == 1.0; }\n";
    let other = "bool test_other() { return true; }\n";
    let folder = Scratch::new(&[
        ("lib.glsl", lib),
        ("uses.test.glsl", uses),
        ("other.test.glsl", other),
    ]);
    let watched = folder
        .command(&["test", "--watch"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn();
    let mut watched = Watched(watched.unwrap());
    let mut lines = BufReader::new(watched.0.stdout.take().unwrap()).lines();
    let mut until = |last: &str| {
        let mut seen = Vec::new();
        for line in lines.by_ref() {
            seen.push(line.unwrap());
            if seen.last().unwrap().ends_with(last) {
                break;
            }
        }
        seen.join("\n")
    };
    contains(
        &until("2 passed, 0 failed"),
        &["test_one ... ok", "test_other ... ok"],
    );
    let mut errors = BufReader::new(watched.0.stderr.take().unwrap()).lines();
    assert_eq!(errors.next().unwrap().unwrap(), "waiting for changes");
    fs::write(folder.path("lib.glsl"), lib.replace("1.0", "1.25")).unwrap();
    let second = until("1 passed, 1 failed");
    contains(&second, &["uses.test.glsl: test_one ... FAILED"]);
    assert!(!second.contains("test_other"), "{second}");
}
