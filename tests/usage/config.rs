//! `shaderlint.toml`.

use super::super::recorded::accepts;
use crate::scratch::{CLEAN, Scratch, WARNED, root};
use serde_json::Value;
use std::fs;

fn config(text: &str) -> Scratch {
    Scratch::new(&[("shaderlint.toml", text), ("a.glsl", WARNED)])
}

#[test]
fn the_nearest_configuration_above_a_file_applies() {
    let scratch = Scratch::new(&[
        ("shaderlint.toml", "rules.pow-negative-base = \"off\""),
        ("a.glsl", WARNED),
        ("in/a.glsl", WARNED),
        ("own/shaderlint.toml", "rules.tidy = \"off\""),
        ("own/deep/a.glsl", WARNED),
    ]);
    assert_eq!(scratch.places(&["a.glsl"]), ["3:11 unused-variable"]);
    assert_eq!(scratch.places(&["in/a.glsl"]), ["3:11 unused-variable"]);
    assert_eq!(
        scratch.places(&["own/deep/a.glsl"]),
        ["2:22 pow-negative-base"]
    );
    let all = ["2:22 pow-negative-base", "3:11 unused-variable"];
    assert_eq!(scratch.places(&["--no-config", "a.glsl"]), all);
    let given = ["--config", "own/shaderlint.toml", "a.glsl"];
    assert_eq!(scratch.places(&given), ["2:22 pow-negative-base"]);
    // From a subfolder, `..` leads to the same file.
    let ran = scratch.run_in("own/deep", &["--info", "--format", "short", "../../a.glsl"]);
    assert!(ran.out.contains("unused-variable") && !ran.out.contains("pow-negative-base"));
    let named = ["-", "--stdin-filename", "own/b.glsl", "--format", "short"];
    let ran = scratch.pipe(WARNED, &named);
    assert!(!ran.out.contains("unused-variable") && ran.out.contains("pow-negative-base"));
}

#[test]
fn rules_and_groups_have_levels() {
    let level = |config_text: &str| {
        let ran = config(config_text).run(&["--format", "short", "a.glsl"]);
        let line = ran.out.lines().find(|l| l.contains("pow-negative-base"));
        line.map(|l| l.split([' ', '[']).nth(1).unwrap().to_string())
    };
    let some = |level: &str| Some(level.to_string());
    assert_eq!(level(""), some("warning"));
    assert_eq!(level("[rules]\nnumeric = \"info\""), some("info"));
    assert_eq!(level("[rules]\nnumeric = \"off\""), None);
    let both = "[rules]\npow-negative-base = \"warning\"\nnumeric = \"off\"";
    assert_eq!(level(both), some("warning"), "a rule overrides its group");
    let table = "[rules]\npow-negative-base = { level = \"info\" }";
    assert_eq!(level(table), some("info"));
}

#[test]
fn disabled_rules_can_be_enabled() {
    let code = "float f(float x, float y) { return x; }\n\
        void mainImage(out vec4 c, in vec2 p) { c = vec4(f(p.x, p.y)); }\n";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    assert_eq!(scratch.places(&["a.glsl"]), [""; 0]);
    scratch.write("shaderlint.toml", "rules.unused-parameter = \"warning\"");
    assert_eq!(scratch.places(&["a.glsl"]), ["1:24 unused-parameter"]);
    assert_eq!(scratch.places(&["--ignore", "tidy", "a.glsl"]), [""; 0]);
}

const MARCH: &str = "\
#define MAX_STEPS 200

float map(vec3 p) {
    return length(p) - 1.0;
}

float march(vec3 origin, vec3 direction) {
    float t = 0.0;
    for (int i = 0; i < MAX_STEPS; i++) {
        float d = map(origin + direction * t);
        if (d < 0.001) break;
        t += d;
    }
    return t;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    fragColor = vec4(march(vec3(0.0, 0.0, -3.0), normalize(vec3(uv, 1.5))) / 10.0);
}
";

#[test]
fn options_and_target_affect_rules() {
    let scratch = Scratch::new(&[("a.glsl", MARCH)]);
    let finds = |text: &str| {
        scratch.write("shaderlint.toml", text);
        let places = scratch.places(&["a.glsl"]);
        places.iter().any(|p| p.ends_with(" step-budget"))
    };
    assert!(!finds(""));
    assert!(finds("[rules.step-budget]\nmain = 199"));
    assert!(!finds("target = \"gpu\""));
    assert!(finds("target = \"swiftshader\""));
    assert!(!finds(
        "target = \"swiftshader\"\n[rules.step-budget]\nmain = 256\nsum = 300"
    ));
    let level = |text: &str| {
        scratch.write("shaderlint.toml", text);
        let out = scratch.run(&["--only", "step-budget", "a.glsl"]).out;
        out.split('[').next().unwrap().to_string()
    };
    let limits = "[rules.step-budget]\nmain = 199\n";
    assert_eq!(level(limits), "info");
    assert_eq!(
        level(&format!("target = \"swiftshader\"\n{limits}")),
        "warning"
    );
    assert_eq!(
        level(&format!(
            "target = \"swiftshader\"\n{limits}level = \"info\""
        )),
        "info"
    );
}

#[test]
fn overrides_apply_to_their_paths() {
    let scratch = Scratch::new(&[
        (
            "shaderlint.toml",
            "[[overrides]]\npaths = [\"legacy\", \"*.test.glsl\"]\nrules = { numeric = \"off\" }\n\
             [[overrides]]\npaths = [\"legacy/new/*\"]\nrules = { pow-negative-base = \"info\" }\n",
        ),
        ("a.glsl", WARNED),
        ("x/a.test.glsl", WARNED),
        ("legacy/deep/a.glsl", WARNED),
        ("legacy/new/a.glsl", WARNED),
    ]);
    let level = |file: &str| {
        let ran = scratch.run(&["--format", "short", file]);
        let line = ran.out.lines().find(|l| l.contains("pow-negative-base"));
        line.map_or("off", |l| {
            if l.contains(" info[") {
                "info"
            } else {
                "warning"
            }
        })
    };
    assert_eq!(level("a.glsl"), "warning");
    assert_eq!(level("x/a.test.glsl"), "off");
    assert_eq!(level("legacy/deep/a.glsl"), "off");
    assert_eq!(
        level("legacy/new/a.glsl"),
        "info",
        "the later override wins"
    );
}

#[test]
fn dialects_can_be_overridden_by_path() {
    let webgl1 = "precision highp float;\nvoid main() { gl_FragColor = vec4(1.0); }\n";
    let scratch = Scratch::new(&[
        (
            "shaderlint.toml",
            "dialect = \"webgl2\"\n[[overrides]]\npaths = [\"old\"]\ndialect = \"webgl1\"",
        ),
        ("a.glsl", webgl1),
        ("old/a.glsl", webgl1),
    ]);
    assert_eq!(scratch.run(&["a.glsl"]).code, 1);
    assert_eq!(scratch.run(&["old/a.glsl"]).code, 0);
    assert_eq!(scratch.run(&["--dialect", "webgl1", "a.glsl"]).code, 0);
}

#[test]
fn the_host_declares_uniforms() {
    let code = "#version 300 es\nprecision highp float;\nout vec4 color;\n\
        void main() { color = vec4(uTime, lights[3]); }\n";
    let own = code.replace(
        "out vec4 color;\n",
        "out vec4 color;\nuniform float uTime;\n",
    );
    let plain = "void mainImage(out vec4 c, in vec2 p) { c = vec4(uTime); }\n";
    let scratch = Scratch::new(&[
        ("a.frag", code),
        ("own.frag", &own),
        ("plain.glsl", plain),
        ("none/shaderlint.toml", ""),
        ("none/a.frag", code),
    ]);
    let uniforms = "[host.uniforms]\nuTime = \"float\"\nlights = \"vec3[4]\"\n";
    scratch.write("shaderlint.toml", uniforms);
    for file in ["a.frag", "own.frag", "plain.glsl"] {
        let ran = scratch.run(&["-q", file]);
        assert_eq!((ran.code, ran.out.as_str()), (0, ""), "{file}");
    }
    assert_eq!(scratch.run(&["none/a.frag"]).code, 1);
    // The declared types are used.
    scratch.write(
        "shaderlint.toml",
        uniforms.replace("\"float\"", "\"sampler2D\""),
    );
    let found = scratch.places(&["a.frag"]);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].starts_with("4:"), "{found:?}");
}

#[test]
fn the_three_host_declares_its_names() {
    let code = "varying vec2 vUv;\nvoid main() {\n    vUv = uv;\n    \
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);\n}\n";
    let wrong = code.replace("vec4(position, 1.0)", "vec4(normal.xy, 1.0)");
    let misspelled = code.replace("modelViewMatrix", "modelVeiwMatrix");
    let files = [
        ("a.vert", code),
        ("wrong.vert", &wrong),
        ("misspelled.vert", &misspelled),
    ];
    let scratch = Scratch::new(&files);
    for config in ["", "host = \"three\""] {
        scratch.write("shaderlint.toml", config);
        let ran = scratch.run(&["-q", "a.vert"]);
        assert_eq!((ran.code, ran.out.as_str()), (0, ""), "{config}");
        let ran = scratch.run(&["-q", "--format", "short", "wrong.vert"]);
        assert!(
            ran.out
                .starts_with("wrong.vert:4:56: error[constructor-arguments]"),
            "{}",
            ran.out
        );
        let ran = scratch.run(&["-q", "--format", "short", "misspelled.vert"]);
        assert!(
            ran.out
                .starts_with("misspelled.vert:4:38: error[undeclared-name]"),
            "{}",
            ran.out
        );
    }
}

#[test]
fn include_and_exclude_select_files_in_folders() {
    let scratch = Scratch::new(&[
        ("a.glsl", WARNED),
        ("a.shader", WARNED),
        ("third_party/a.glsl", WARNED),
    ]);
    let files = |args: &[&str]| {
        let ran = scratch.run(&[&["--format", "checkstyle"], args].concat());
        let xml = roxmltree::Document::parse(&ran.out).unwrap();
        let names = xml.descendants().filter(|n| n.has_tag_name("file"));
        names
            .map(|n| n.attribute("name").unwrap().to_string())
            .collect::<Vec<_>>()
    };
    assert_eq!(files(&["."]), ["a.glsl", "third_party/a.glsl"]);
    scratch.write("shaderlint.toml", "exclude = [\"third_party\"]");
    assert_eq!(files(&["."]), ["a.glsl"]);
    assert_eq!(
        files(&["third_party/a.glsl"]),
        ["third_party/a.glsl"],
        "a file that is named is checked"
    );
    assert_eq!(
        files(&["--force-exclude", "a.glsl", "third_party/a.glsl"]),
        ["a.glsl"]
    );
    scratch.write("shaderlint.toml", "include = [\"*.shader\"]");
    assert_eq!(files(&["."]), ["a.shader"]);
}

#[test]
fn configuration_errors_have_a_position() {
    let wrong = |text: &str, message: &str| {
        let ran = config(text).run(&["a.glsl", "a.glsl"]);
        assert_eq!((ran.code, ran.out.as_str()), (2, ""));
        assert_eq!(ran.err, format!("shaderlint: {message}\n"));
    };
    wrong(
        "# é\ntaget = \"gpu\"",
        "shaderlint.toml:2:1: unknown key `taget`; did you mean `target`?",
    );
    wrong(
        "[rules]\nflaot-equality = \"off\"",
        "shaderlint.toml:2:1: unknown rule or group `flaot-equality`; did you mean `float-equality`?",
    );
    wrong(
        "[rules.step-budget]\nmian = 3",
        "shaderlint.toml:2:1: unknown key `mian`; did you mean `main`?",
    );
    wrong(
        "[[overrides]]\nrules = {}",
        "shaderlint.toml:1:1: an override requires `paths`; add `paths = [\"legacy/**\"]`",
    );
    wrong(
        "exclude = [\"a\", \"[\"]",
        "shaderlint.toml:1:17: invalid pattern `[`: unclosed character class; missing ']'",
    );
}

#[test]
fn an_invalid_configuration_is_reported_once_and_others_apply() {
    let scratch = Scratch::new(&[
        ("bad/shaderlint.toml", "x = 1"),
        ("bad/a.glsl", WARNED),
        ("bad/b.glsl", WARNED),
        ("good/a.glsl", WARNED),
    ]);
    let ran = scratch.run(&["--format", "short", "."]);
    assert_eq!(ran.code, 2);
    assert_eq!(ran.err.lines().count(), 1, "{}", ran.err);
    assert!(
        ran.err
            .starts_with("shaderlint: bad/shaderlint.toml:1:1: unknown key `x`")
    );
    assert_eq!(ran.out.lines().count(), 1, "{}", ran.out);
    let ran = scratch.run(&["--config", "missing.toml", "good"]);
    assert_eq!(ran.code, 2);
    assert!(
        ran.err.starts_with("shaderlint: missing.toml: "),
        "{}",
        ran.err
    );
}

#[test]
fn the_committed_schema_is_up_to_date() {
    let schema = Scratch::new(&[]).run(&["schema"]).out;
    let path = root().join("editors/shaderlint.schema.json");
    if accepts() {
        fs::write(&path, &schema).unwrap();
    }
    let committed = fs::read_to_string(path).unwrap_or_default();
    assert!(
        schema == committed,
        "editors/shaderlint.schema.json is out of date"
    );
}

/// The schema and the reader must have the same keys.
#[test]
fn the_schema_has_the_keys_of_the_reader() {
    let schema: Value = serde_json::from_str(&Scratch::new(&[]).run(&["schema"]).out).unwrap();
    let keys = |at: &str| -> Vec<String> {
        let object = schema.pointer(at).and_then(Value::as_object).unwrap();
        object.keys().cloned().collect()
    };
    let reported = |text: &str| {
        let ran = config(text).run(&["a.glsl"]);
        let names = ran
            .err
            .split("expected one of `")
            .nth(1)
            .unwrap()
            .trim_end()
            .trim_end_matches('`');
        let mut names: Vec<String> = names.split("`, `").map(str::to_string).collect();
        names.sort();
        names
    };
    assert_eq!(keys("/properties"), reported("zzzzzzzzzz = 1"));
    let overrides = "[[overrides]]\npaths = []\nzzzzzzzzzz = 1";
    assert_eq!(
        keys("/properties/overrides/items/properties"),
        reported(overrides)
    );
    let host = "host.zzzzzzzzzz = 1";
    assert_eq!(keys("/properties/host/anyOf/1/properties"), reported(host));
    for rule in keys("/properties/rules/properties") {
        let ran = config(&format!("rules.{rule} = \"info\"")).run(&["a.glsl"]);
        assert_ne!(ran.code, 2, "{rule}");
    }
}

#[test]
fn the_documented_example_is_valid() {
    let page = fs::read_to_string(root().join("docs/configuration.md")).unwrap();
    let example = page.split("```toml\n").nth(1).unwrap();
    let scratch = config(example.split("```").next().unwrap());
    let ran = scratch.run(&["a.glsl"]);
    assert_eq!(ran.err, "");
    assert_ne!(ran.code, 2);
}

#[test]
fn files_are_checked_without_a_configuration() {
    let scratch = Scratch::new(&[("a.glsl", CLEAN)]);
    assert_eq!(scratch.run(&["a.glsl"]).code, 0);
}

#[test]
fn a_user_defined_host_is_described_in_glsl() {
    let host = "// My engine\n//\n// It puts its uniforms before every shader.\n// version: 300 es\n// names: all\n\
        precision highp float;\nuniform mat4 uCamera;\n#ifdef VERTEX_SHADER\nin vec3 aPosition;\n#endif\n";
    let good = "void main() { gl_Position = uCamera * vec4(aPosition, 1.0); }\n";
    let bad = "void main() { gl_Position = uCamera * vec4(aPosition, 1.0) + uCameraa; }\n";
    let scratch = Scratch::new(&[
        (
            "shaderlint.toml",
            "host = { prelude = \"engine/host.glsl\" }\nexclude = [\"engine\"]",
        ),
        ("engine/host.glsl", host),
        ("good.vert", good),
        ("bad.vert", bad),
    ]);
    let ran = scratch.run(&["-q", "good.vert"]);
    assert_eq!((ran.code, ran.out.as_str()), (0, ""));
    // All its names are declared, so any other name is an error.
    assert_eq!(scratch.places(&["bad.vert"]), ["1:62 undeclared-name"]);
    scratch.write("engine/host.glsl", "// My engine\n// names: many\n");
    let ran = scratch.run(&["good.vert"]);
    assert_eq!(ran.code, 2);
    assert!(
        ran.err
            .contains("engine/host.glsl:2: expected `all` or `some`, found `many`"),
        "{}",
        ran.err
    );
}

/// Presets choose rules and show their infos; by default infos are only counted.
#[test]
fn presets_select_rules_and_show_infos() {
    let code = "float idle(float x) { return x; }\n\
        void mainImage(out vec4 c, in vec2 p) {\n    float unused = 1.0;\n    c = vec4(p, 0.0, 1.0);\n}\n";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    let rules = |text: &str, args: &[&str]| {
        scratch.write("shaderlint.toml", text);
        let out = scratch
            .run(&[args, &["--format", "short", "a.glsl"]].concat())
            .out;
        let rule = |line: &str| line.split(['[', ']']).nth(1).map(str::to_string);
        out.lines().filter_map(rule).collect::<Vec<String>>()
    };
    let check = |text: &str, args: &[&str], expected: &[&str]| {
        assert_eq!(rules(text, args), expected, "{text:?} {args:?}");
    };
    let both = ["unused-function", "unused-variable"];
    check("", &[], &[]);
    check("", &["--info"], &["unused-variable"]);
    check("info = true", &[], &["unused-variable"]);
    check("preset = \"strict\"", &[], &both);
    check("preset = \"strict\"\ninfo = false", &[], &[]);
    check("preset = \"performance\"", &[], &["unused-variable"]);
    check(
        "preset = \"all\"",
        &["--ignore", "unused-variable"],
        &both[..1],
    );
    check("", &["--select", "strict"], &both);
    check("", &["--select", "unused-function"], &both[..1]);
    check("[rules]\nunused-variable = \"info\"", &[], &both[1..]);
    check("preset = \"all\"\n[rules]\ntidy = \"off\"", &[], &[]);
    let ran = scratch.run(&["--no-config", "a.glsl"]);
    assert_eq!(
        ran.out,
        "All checks passed (1 shader in 1 file); 1 info: --info\n"
    );
    scratch.write("shaderlint.toml", "preset = \"strikt\"");
    let ran = scratch.run(&["a.glsl"]);
    assert!(ran.err.contains("did you mean `strict`?"), "{}", ran.err);
}

/// One finding for one mistake and file, with the other places.
#[test]
fn repeated_mistakes_are_one_finding() {
    let code = "float f(float x) {\n    float y = pow(x - 2.0, 2.0);\n    return y + pow(x - 2.0, 2.0);\n}\n\
        float g(float x) { return pow(x - 3.0, 2.0); }\n\
        void mainImage(out vec4 c, in vec2 p) {\n    float a, b = 1.0;\n    float d = 2.0;\n    \
        c = vec4(f(sin(iTime)) + g(cos(iTime)));\n}\n";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    let short = scratch
        .run(&["-q", "--info", "--format", "short", "a.glsl"])
        .out;
    let lines: Vec<&str> = short.lines().collect();
    assert_eq!(lines.len(), 2, "{short}");
    let also = [
        "(line 3), `x - 3.0` (line 5))",
        "(also `b` (line 7), `d` (line 8))",
    ];
    for (line, also) in lines.iter().zip(also) {
        assert!(line.contains(also), "{short}");
    }
    let human = scratch.run(&["-q", "a.glsl"]).out;
    assert!(
        human.contains("= also `x - 2.0` (line 3), `x - 3.0` (line 5)"),
        "{human}"
    );
    let all = scratch.run(&["--format", "json", "a.glsl"]).out;
    let all: serde_json::Value = serde_json::from_str(&all).unwrap();
    assert_eq!(all["diagnostics"][0]["others"][1]["start"]["line"], 5);
    assert_eq!(all["summary"]["warnings"], 1);
}

#[test]
fn a_list_of_names_can_be_complete() {
    let shader = "void main() { gl_FragColor = vec4(cameraPosition + own, 1.0); }";
    for (config, expected) in [
        ("host = \"three\"", ""),
        ("[host]\npreset = \"three\"\nnames = \"some\"", ""),
        (
            "[host]\npreset = \"three\"\nnames = \"all\"",
            "1:52 undeclared-name",
        ),
        (
            "[host]\nnames = \"all\"\nuniforms = { cameraPosition = \"vec3\" }",
            "1:52 undeclared-name",
        ),
        (
            "[host]\npreset = \"three\"\nnames = \"all\"\nuniforms = { own = \"vec3\" }",
            "",
        ),
    ] {
        let scratch = Scratch::new(&[
            ("a.frag", shader),
            ("b.frag", "float own;"),
            ("shaderlint.toml", config),
        ]);
        let out = scratch.run(&["--format", "short", "a.frag"]).out;
        let errors: Vec<&str> = out
            .lines()
            .filter(|line| line.contains(" error["))
            .collect();
        let place = expected.split(' ').next().unwrap_or("");
        assert_eq!(
            errors.len(),
            usize::from(!expected.is_empty()),
            "{config}\n{out}"
        );
        assert!(out.contains(place), "{config}\n{out}");
    }
}
