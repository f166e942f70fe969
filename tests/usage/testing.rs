//! `test`: which tests are found and run, messages of failed tests, comparison with golden images
//! and when one is written.

use crate::scratch::Scratch;
use serde_json::Value;
use std::fs;

/// Helpers without an entry point, with a test.
const SDF: &str = "float sdSphere(vec3 p, float r) { return length(p) - r; }
float sdBox(vec3 p, vec3 b) {
    vec3 q = abs(p) - b;
    return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0);
}
bool test_sphere_inside() { return sdSphere(vec3(0.0), 2.0) == -2.0; }
";

/// Tests of the helpers, in a separate file.
const SDF_TESTS: &str = "const float EPS = 1e-4;
bool near(float a, float b) { return abs(a - b) < EPS; }
bool test_box_face() {
    float d = sdBox(vec3(2.5, 0.0, 0.0), vec3(1.0));
    return abs(d - 1.0) < EPS;
}
bool test_box_far() {
    return near(sdBox(vec3(3.0, 0.0, 0.0), vec3(1.0)), 2.0);
}
bool test_box_left() {
    vec2 p = gl_FragCoord.xy;
    return p.x < 640.0 && sdBox(vec3(p, 0.0), vec3(2000.0)) < 0.0;
}
";

/// An image that depends on a number.
fn wave(level: &str) -> String {
    format!(
        "void mainImage(out vec4 color, in vec2 place) {{
    color = vec4(place / iResolution.xy, {level}, 1.0);
}}
"
    )
}

fn reported(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

/// Name and status of each test, in order.
fn states(out: &str) -> Vec<(String, String)> {
    let reported = reported(out);
    let all = reported["tests"].as_array().unwrap().iter();
    let text = |v: &Value| v.as_str().unwrap().to_string();
    all.map(|t| (text(&t["name"]), text(&t["status"])))
        .collect()
}

#[test]
fn tests_of_helpers_run_after_the_tested_code() {
    let scratch = Scratch::new(&[("lib/sdf.glsl", SDF), ("lib/sdf.test.glsl", SDF_TESTS)]);
    // A file, or the folder that contains it: the tests next to it run once.
    for path in ["lib/sdf.glsl", "lib"] {
        let ran = scratch.run(&["test", path]);
        assert_eq!((ran.code, ran.err.as_str()), (1, ""), "{}", ran.out);
        let lines: Vec<&str> = ran.out.lines().take(4).collect();
        assert_eq!(
            lines,
            [
                "lib/sdf.glsl: test_sphere_inside ... ok",
                "lib/sdf.test.glsl: test_box_face ... FAILED",
                "lib/sdf.test.glsl: test_box_far ... ok",
                "lib/sdf.test.glsl: test_box_left ... FAILED",
            ]
        );
        assert!(ran.out.ends_with("2 passed, 2 failed\n"), "{}", ran.out);
    }
    let face = "lib/sdf.test.glsl:3:6: test_box_face: returned false
  line 5: `abs(d - 1.0) < EPS` is false
    abs(d - 1.0)  0.5
    d             1.5
    EPS           0.0001
";
    let left = "lib/sdf.test.glsl:10:6: test_box_left: returned false for 50.0 % of 9216 pixels";
    let ran = scratch.run(&["test", "lib"]);
    assert!(
        ran.out.contains(face) && ran.out.contains(left),
        "{}",
        ran.out
    );
    let ran = scratch.run(&["test", "lib/sdf.test.glsl", "--filter", "far"]);
    assert_eq!((ran.code, ran.err.as_str()), (0, ""), "{}", ran.out);
    assert!(ran.out.ends_with("1 passed, 0 failed\n"), "{}", ran.out);
}

#[test]
fn json_output_contains_evaluated_conditions() {
    let scratch = Scratch::new(&[("sdf.glsl", SDF), ("sdf.test.glsl", SDF_TESTS)]);
    let ran = scratch.run(&["test", "--format", "json"]);
    let reported = reported(&ran.out);
    assert_eq!(
        (
            &reported["schema"],
            &reported["passed"],
            &reported["failed"]
        ),
        (&1.into(), &2.into(), &2.into())
    );
    let left = &reported["tests"][3];
    assert_eq!(
        (&left["file"], &left["at"]),
        (&"sdf.test.glsl".into(), &"sdf.test.glsl:10:6".into())
    );
    // The right operand of `&&` is not evaluated.
    let [condition] = &left["conditions"].as_array().unwrap()[..] else {
        panic!("{left}")
    };
    assert_eq!(
        (&condition["text"], &condition["answer"]),
        (&"p.x < 640.0".into(), &"false".into())
    );
}

#[test]
fn files_with_errors_and_invalid_tests_are_reported() {
    let scratch = Scratch::new(&[
        ("bad.glsl", "bool test_bad() { return 1.0 == vec2(1.0); }\n"),
        (
            "odd.glsl",
            "void test_odd() {}\nbool test_even() { return true; }\n",
        ),
        (
            "open.glsl",
            "bool test_open() { return uScale * 2.0 == 2.0; }\n",
        ),
    ]);
    let ran = scratch.run(&["test"]);
    assert_eq!(ran.code, 1, "{}", ran.out);
    assert!(ran.out.contains("bad.glsl ... FAILED"), "{}", ran.out);
    assert!(
        ran.out.contains("the file has errors: bad.glsl:1:"),
        "{}",
        ran.out
    );
    assert!(ran.out.contains("cannot run: `uScale"), "{}", ran.out);
    let note = "note: odd.glsl:1:6: `test_odd` is not a test; expected `bool test_odd()`\n";
    assert_eq!(ran.err, note);
    let nothing = scratch.run(&["test", "--filter", "nowhere", "odd.glsl"]);
    assert_eq!(nothing.code, 2);
    assert!(nothing.err.contains("no tests found"), "{}", nothing.err);
    assert_eq!(scratch.run(&["test", "missing.glsl"]).code, 2);
}

#[test]
fn complete_shaders_are_tested_with_the_uniforms_of_their_host() {
    let shader =
        wave("iTime") + "bool test_time() { return iResolution.x == 1280.0 && iTime < 5.0; }\n";
    let scratch = Scratch::new(&[("wave.glsl", &shader)]);
    let ran = scratch.run(&["test"]);
    assert!(
        ran.out.contains("test_time: returned false at 10 s\n"),
        "{}",
        ran.out
    );
    assert!(
        ran.out
            .contains("`iTime < 5.0` is false\n    iTime  10.0\n"),
        "{}",
        ran.out
    );
    let clean = scratch.run(&["--format", "short", "wave.glsl"]);
    assert!(!clean.out.contains("unused-function"), "{}", clean.out);
}

#[test]
fn golden_images_are_accepted_and_compared_perceptually() {
    let scratch = Scratch::new(&[("wave.glsl", &wave("0.5"))]);
    let ran = scratch.run(&["test"]);
    assert_eq!(ran.code, 2, "{}", ran.out);
    assert!(
        ran.out.contains("1 complete shader has no golden image"),
        "{}",
        ran.out
    );
    assert!(!scratch.path("wave.glsl.golden.png").exists());
    let args = ["test", "--size", "32x16"];
    let ran = scratch.run(&[&args[..], &["--bless"]].concat());
    assert_eq!(ran.code, 0, "{}", ran.out);
    assert!(
        ran.out
            .starts_with("wave.glsl: golden image at 0 s ... blessed\n"),
        "{}",
        ran.out
    );
    let golden_image = fs::read(scratch.path("wave.glsl.golden.png")).unwrap();
    // Without a size, the golden image's size is used; differences in the last bit are ignored.
    for level in ["0.5", "0.502"] {
        scratch.write("wave.glsl", wave(level));
        let ran = scratch.run(&["test", "--bless"]);
        assert_eq!((ran.code, ran.err.as_str()), (0, ""), "{}", ran.out);
        assert!(
            ran.out
                .starts_with("wave.glsl: golden image at 0 s ... ok\n"),
            "{}",
            ran.out
        );
    }
    scratch.write("wave.glsl", wave("0.9"));
    let ran = scratch.run(&["test", "--format", "json"]);
    assert_eq!(ran.code, 1);
    let difference = &reported(&ran.out)["tests"][0]["difference"];
    assert!(
        difference["visible"].as_f64().unwrap() > 0.9,
        "{difference}"
    );
    let ran = scratch.run(&["test", "--diff"]);
    assert!(
        ran.out.contains("; see wave.glsl.golden.diff.png"),
        "{}",
        ran.out
    );
    let ran = scratch.run(&["test", "--diff"]);
    assert!(
        ran.out.contains("already exists; use --force"),
        "{}",
        ran.out
    );
    assert_eq!(scratch.run(&["test", "--tolerance", "100"]).code, 0);
    assert_eq!(
        fs::read(scratch.path("wave.glsl.golden.png")).unwrap(),
        golden_image
    );
    let ran = scratch.run(&["test", "--bless"]);
    assert_eq!(ran.code, 0, "{}", ran.out);
    assert_ne!(
        fs::read(scratch.path("wave.glsl.golden.png")).unwrap(),
        golden_image
    );
    assert_eq!(scratch.run(&["test"]).code, 0);
}

#[test]
fn shaders_can_specify_sizes_and_times() {
    let shader = format!("// golden: 16x8 at 0, 2.5\n{}", wave("iTime"));
    let scratch = Scratch::new(&[("wave.glsl", &shader), ("bad.frag", "// golden: huge\n")]);
    let ran = scratch.run(&["test", "wave.glsl"]);
    assert_eq!(ran.code, 1, "{}", ran.out);
    assert!(
        ran.out
            .contains("wave.glsl.golden.2.5s.png does not exist; use --bless"),
        "{}",
        ran.out
    );
    assert_eq!(scratch.run(&["test", "wave.glsl", "--bless"]).code, 0);
    let ran = scratch.run(&["test", "wave.glsl", "--format", "json"]);
    let passed = |name: &str| (name.to_string(), "passed".to_string());
    assert_eq!(
        states(&ran.out),
        [
            passed("golden image at 0 s"),
            passed("golden image at 2.5 s")
        ]
    );
    let ran = scratch.run(&["test", "bad.frag"]);
    assert!(
        ran.out.contains("line 1: expected a size, times or both"),
        "{}",
        ran.out
    );
}

#[test]
fn the_passes_of_a_folder_draw_one_image() {
    let scratch = Scratch::new(&[
        (
            "sea/image.glsl",
            "void mainImage(out vec4 c, in vec2 p) { c = vec4(shade(p), 0.0, 1.0); }\n",
        ),
        (
            "sea/common.glsl",
            "vec2 shade(vec2 p) { return fract(p / 8.0); }\nbool test_shade() { return shade(vec2(8.0)) == vec2(0.0); }\n",
        ),
    ]);
    let args = ["test", "--size", "16x8", "--format", "json"];
    let ran = scratch.run(&[&args[..], &["--bless"]].concat());
    assert_eq!(ran.code, 0, "{}{}", ran.out, ran.err);
    let state = |name: &str, status: &str| (name.to_string(), status.to_string());
    assert_eq!(
        states(&ran.out),
        [
            state("test_shade", "passed"),
            state("golden image at 0 s", "blessed")
        ]
    );
    assert!(scratch.path("sea/image.glsl.golden.png").exists());
}
