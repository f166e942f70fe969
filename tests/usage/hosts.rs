//! Hosts of shaders: both programs use the same table and report the same.

use crate::scratch::Scratch;
use insta_cmd::get_cargo_bin;
use shaderlint::diagnostic::Severity;
use shaderlint::engine::{DialectChoice, Options, check};
use shaderlint::host::{Preset, preset, presets};
use shaderlint::lint::Settings;
use shaderlint::project::NoFiles;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const DIALECTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/dialects");

/// The shaders of the fixtures, by host; without included files.
fn fixtures() -> Vec<(String, PathBuf)> {
    let mut all = Vec::new();
    for folder in fs::read_dir(DIALECTS).unwrap() {
        let folder = folder.unwrap().path();
        let host = folder.file_name().unwrap().to_str().unwrap().to_string();
        for file in fs::read_dir(folder).unwrap() {
            let path = file.unwrap().path();
            let others = ["vs", "klproj", "kdl"];
            let is_shader = path
                .extension()
                .is_some_and(|e| others.iter().all(|o| e != *o));
            if path.is_file() && is_shader {
                all.push((host.clone(), path));
            }
        }
    }
    all.sort();
    all
}

/// What `shaderport` reports as the type of a file, and whether it produces output.
fn ported(scratch: &Scratch, path: &Path, more: &[&str]) -> (Option<String>, bool) {
    let out = Command::new(get_cargo_bin("shaderport"))
        .current_dir(scratch.path(""))
        .args([
            path.to_str().unwrap(),
            "-t",
            "json",
            "-o",
            "out.json",
            "--force",
        ])
        .args(more)
        .output()
        .unwrap();
    let printed = String::from_utf8(out.stderr).unwrap();
    let line = printed
        .lines()
        .find_map(|l| l.strip_prefix("note: read as "));
    let reported = line.map(|l| l.split("; ").next().unwrap_or(l).to_string());
    (reported, out.status.success())
}

#[test]
fn both_programs_recognise_the_same_host() {
    let scratch = Scratch::new(&[]);
    for (host, path) in fixtures() {
        let (reported, _) = ported(&scratch, &path, &[]);
        let linted = scratch.run(&["-v", path.to_str().unwrap()]);
        let name = path.file_name().unwrap().to_str().unwrap();
        let line = linted.err.lines().find(|l| l.contains(": checked as "));
        let (_, line) = line
            .unwrap_or_else(|| panic!("{name}: {}", linted.err))
            .split_once(": checked as ")
            .unwrap();
        match reported {
            Some(reported) => assert!(
                line.starts_with(&format!("{reported}: ")),
                "{host}/{name}: {line}\n{reported}"
            ),
            None => {
                let is_reported =
                    presets().any(|p| line.starts_with(&format!("{} (found ", p.read_as())));
                assert!(!is_reported, "{host}/{name}: {line}");
            }
        }
    }
}

/// A shader that `shaderport` plays is not rejected for its dialect.
#[test]
fn playable_shaders_are_not_rejected_for_their_dialect() {
    let scratch = Scratch::new(&[]);
    for (host, path) in fixtures() {
        let is_complete = ["bonzomatic", "kodelife", "kodi"].contains(&host.as_str());
        let composes = preset(&host).is_some_and(|host| host.composes);
        if !is_complete && !composes {
            continue;
        }
        let (_, plays) = ported(&scratch, &path, &["--host", &host]);
        assert!(plays, "{}", path.display());
        for host in [&["--host", host.as_str()][..], &[]] {
            if host.is_empty() && path.to_str().unwrap().contains("kodi") {
                continue;
            }
            let args = [&[path.to_str().unwrap(), "--format", "short"], host].concat();
            let linted = scratch.run(&args);
            assert!(!linted.out.contains("error"), "{args:?}: {}", linted.out);
            let is_open = linted.out.contains("undeclared-name");
            assert!(!(composes && is_open), "{args:?}: {}", linted.out);
        }
    }
}

/// A typical ISF shader for desktops: persistent passes, and implicit conversions.
const ISF: &str = r#"/*{
  "ISFVSN": "2",
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"}, {"NAME": "amount", "TYPE": "float", "DEFAULT": 0.5},
    {"NAME": "at", "TYPE": "point2D"}
  ],
  "PASSES": [{"TARGET": "old", "PERSISTENT": true, "FLOAT": true}, {}]
}*/
void main() {
    if (PASSINDEX == 0) {
        gl_FragColor = mix(IMG_THIS_PIXEL(inputImage), IMG_THIS_PIXEL(old), amount);
    } else {
        gl_FragColor = IMG_NORM_PIXEL(old, isf_FragNormCoord) + IMG_PIXEL(old, at) * TIME * 0;
    }
}
"#;

/// The head of a text declares its names: an unknown name is an error.
#[test]
fn undeclared_names_beside_those_of_the_header_are_errors() {
    let wrong = ISF.replace("old), amount)", "old), amuont)");
    let versioned = ISF.replace("}*/", "}*/\n#version 120");
    let scratch = Scratch::new(&[("a.fs", ISF), ("b.fs", &wrong), ("c.fs", &versioned)]);
    for file in ["a.fs", "c.fs"] {
        assert_eq!(scratch.places(&[file]), [] as [&str; 0], "{file}");
        let (reported, plays) = ported(&scratch, Path::new(file), &[]);
        assert!(
            plays && reported.is_some_and(|t| t.starts_with("ISF (found ")),
            "{file}"
        );
    }
    assert_eq!(scratch.places(&["b.fs"]), ["11:77 undeclared-name"]);
    assert!(!ported(&scratch, Path::new("b.fs"), &[]).1);
}

/// An included file may contain directives of the host, too, and need not be a shader.
#[test]
fn host_directives_are_applied() {
    let image = "#include \"ui.glsl\"\n#iChannel0 \"file://buffer.glsl\"\n\
        void mainImage(out vec4 c, in vec2 p) {\n    \
        c = texture(iChannel0, p / iResolution.xy) * speed * iMouseButton.x;\n}\n";
    let buffer = "void main() { gl_FragColor = vec4(sin(iTime)); }\n";
    let typo = image.replace("* speed", "* sped");
    let removed = image.replace("ui.glsl", "gone.glsl");
    let scratch = Scratch::new(&[
        ("a.glsl", image),
        ("ui.glsl", "#iUniform float speed = 1.0 in { 0.0, 2.0 }\n"),
        ("buffer.glsl", buffer),
        ("typo.glsl", &typo),
        ("away.glsl", &removed),
    ]);
    assert_eq!(scratch.places(&["a.glsl", "ui.glsl"]), [] as [&str; 0]);
    assert!(ported(&scratch, Path::new("a.glsl"), &[]).1);
    assert_eq!(scratch.places(&["typo.glsl"]), ["4:50 undeclared-name"]);
    assert!(!ported(&scratch, Path::new("typo.glsl"), &[]).1);
    // A missing file may declare it.
    let reported = scratch.run(&["away.glsl", "--info", "--format", "short"]);
    assert!(
        reported.out.contains("info[undeclared-name]: `speed`"),
        "{}",
        reported.out
    );
}

/// A shader in Markdown or a script is read like one in its own file.
#[test]
fn hosts_of_embedded_shaders_are_recognised() {
    let bonzomatic = "#version 410 core\nuniform float fGlobalTime;\nuniform vec2 v2Resolution;\n\
        uniform sampler1D texFFT;\nout vec4 o;\nvoid main(void) {\n    \
        o = vec4(v2Resolution, sin(fGlobalTime), 1) + texture(texFFT, 0.1);\n}\n";
    let text = format!("# Shaders\n\n```glsl\n{bonzomatic}```\n\n```glsl\n{ISF}```\n");
    let wrong = bonzomatic.replace("0.1)", "0.1) + oops");
    let script = format!("const a = `{wrong}`;\nconst b = `#version 330\nvoid main() {{}}`;\n");
    let scratch = Scratch::new(&[("a.md", &text), ("a.js", &script)]);
    let ran = scratch.run(&["a.md", "-v"]);
    assert!(ran.out.contains("No findings"), "{}", ran.out);
    assert!(
        ran.err.contains("checked as Bonzomatic: fragment shader"),
        "{}",
        ran.err
    );
    let places = ["7:74 undeclared-name", "10:12 unsupported-version"];
    assert_eq!(scratch.places(&["a.js"]), places);
    // Markdown that contains shaders is not itself a shader.
    assert!(!ported(&scratch, Path::new("a.md"), &[]).1);
}

#[test]
fn errors_in_multi_pass_texts_are_reported_once() {
    let code = "/*{\"INPUTS\": [], \"PASSES\": [{\"TARGET\": \"a\"}, {}]}*/\n\
                void main() { gl_FragColor = vec4(unknown); }\n";
    let scratch = Scratch::new(&[("a.fs", code)]);
    let out = Command::new(get_cargo_bin("shaderport"))
        .current_dir(scratch.path(""))
        .args(["a.fs", "-o", "a.html"])
        .output()
        .unwrap();
    let printed = String::from_utf8(out.stderr).unwrap();
    assert_eq!(
        printed.matches("`unknown` is not declared").count(),
        1,
        "{printed}"
    );
    assert!(printed.contains("1 error in 1 file"), "{printed}");
}

/// Files that include each other, or others twice, do not recurse forever.
#[test]
fn circular_includes_terminate() {
    let main =
        "#iChannel0 \"self\"\n#include \"0.glsl\"\nvoid mainImage(out vec4 c, vec2 p) { c = x; }\n";
    let mut files = vec![("main.glsl".to_string(), main.to_string())];
    for number in 0..40 {
        let next = format!("#include \"{}.glsl\"\n", (number + 1) % 40);
        files.push((format!("{number}.glsl"), next.repeat(2)));
    }
    let files: Vec<(&str, &str)> = files.iter().map(|(n, t)| (&n[..], &t[..])).collect();
    let scratch = Scratch::new(&files);
    assert_eq!(scratch.run(&["main.glsl"]).code, 1);
    assert!(!ported(&scratch, Path::new("main.glsl"), &[]).1);
}

/// The machine-readable formats name the host with the same words as the human-readable ones.
#[test]
fn machine_readable_formats_name_the_host() {
    let bonzomatic = Path::new(DIALECTS).join("bonzomatic/default.glsl");
    let bonzomatic = fs::read_to_string(bonzomatic).unwrap();
    let toy = "void mainImage(out vec4 c, vec2 p) { c = vec4(x); }\n";
    let text = format!("```glsl\n{ISF}```\n");
    let files = [
        ("a.glsl", &bonzomatic[..]),
        ("b.glsl", toy),
        ("c.md", &text),
    ];
    let scratch = Scratch::new(&files);
    let printed = scratch.run(&[".", "-v"]).err;
    let json = scratch.run(&[".", "--format", "json"]).out;
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let readings = json["readings"].as_array().unwrap();
    let hosts: Vec<&serde_json::Value> = readings.iter().map(|r| &r["hosts"][0]).collect();
    assert_eq!(hosts, ["bonzomatic", "shadertoy", "isf"]);
    for (reading, (file, _)) in readings.iter().zip(files) {
        let read_as = reading["read_as"].as_str().unwrap();
        let line = format!("{file}: checked as {read_as}; no configuration");
        assert!(
            reading["file"] == file && printed.contains(&line),
            "{line}\n{printed}"
        );
    }
    let lines = scratch.run(&["b.glsl", "--format", "jsonl"]).out;
    let line: serde_json::Value = serde_json::from_str(lines.lines().next().unwrap()).unwrap();
    assert_eq!(line["read_as"], readings[1]["read_as"]);
    let named = scratch
        .run(&["b.glsl", "--format", "json", "--host", "kodi"])
        .out;
    let named: serde_json::Value = serde_json::from_str(&named).unwrap();
    assert_eq!(named["readings"][0]["hosts"][0], "kodi");
}

#[test]
fn unknown_hosts_get_suggestions() {
    let scratch = Scratch::new(&[("a.glsl", "void main() {}")]);
    let ran = scratch.run(&["a.glsl", "--host", "bonzomatik"]);
    let printed = "unknown host `bonzomatik`; did you mean `bonzomatic`?";
    assert_eq!(ran.code, 2);
    assert!(ran.err.contains(printed), "{}", ran.err);
    let (reported, plays) = ported(&scratch, Path::new("a.glsl"), &["--from", "bonzomatik"]);
    assert!(reported.is_none() && !plays);
    assert_eq!(
        scratch
            .run(&["a.glsl", "--host", "three", "--dialect", "webgl2"])
            .code,
        2
    );
}

/// A desktop shader without a recognised host is not a WebGL shader; the user may name one.
#[test]
fn desktop_shaders_without_a_host_are_rejected() {
    let code = "#version 330 core\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    assert_eq!(scratch.places(&["a.glsl"]), ["1:1 unsupported-version"]);
    assert_eq!(scratch.run(&["a.glsl", "--host", "kodelife"]).code, 0);
}

/// Positions are those of the file, regardless of the added code.
#[test]
fn errors_in_desktop_shaders_have_correct_positions() {
    let code = "#version 150\nin VertexData {\n    vec2 v_texcoord;\n} inData;\n\
        uniform vec3 spectrum;\nout vec4 c;\nvoid main() {\n    c = vec4(spectrums, 1) * inData.v_texcoord.x;\n}\n";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    let places = scratch.places(&["a.glsl"]);
    assert!(
        places.contains(&"8:14 undeclared-name".to_string()),
        "{places:?}"
    );
}

/// A user-defined host declares the meaning of its names, too.
#[test]
fn a_user_defined_host_can_extend_another() {
    let host = "// Mine\n//\n// As three.js.\n// base: three\nuniform float mine; // = tmie\n";
    let scratch = Scratch::new(&[
        ("shaderlint.toml", "[host]\nprelude = \"host.glsl\"\n"),
        ("host.glsl", host),
        (
            "a.frag",
            "void main() { gl_FragColor = vec4(mine, cameraPosition); }\n",
        ),
    ]);
    let ran = scratch.run(&["a.frag"]);
    assert_eq!(ran.code, 2);
    assert!(
        ran.err.contains("host.glsl:5: expected one of"),
        "{}",
        ran.err
    );
    assert!(ran.err.contains("did you mean `time`?"), "{}", ran.err);
    scratch.write("host.glsl", host.replace("tmie", "time"));
    assert_eq!(scratch.run(&["a.frag"]).code, 0);
}

/// A shader of the host described in `host.glsl` gets its declarations in all programs, and an
/// error in it is reported by both.
fn own_host(scratch: &Scratch, file: &str, more: &[&str]) {
    let args = |first: &[&'static str]| -> Vec<String> {
        let all = first.iter().chain(more).map(|a| a.to_string());
        all.chain([file.to_string()]).collect()
    };
    let run = |first: &[&'static str]| {
        let args = args(first);
        scratch.run(&args.iter().map(String::as_str).collect::<Vec<_>>())
    };
    let linted = run(&["-v"]);
    assert_eq!(linted.code, 0, "{}", linted.out);
    let shot = ["run", "--time", "0.25", "--size", "2x2", "--format", "json"];
    let drawn: serde_json::Value = serde_json::from_str(&run(&shot).out).unwrap();
    let mean = &drawn["outputs"][0]["mean"];
    assert_eq!(*mean, serde_json::json!([0.25, 0.5, 0.5]), "{drawn}");
    let page = Command::new(get_cargo_bin("shaderport"))
        .current_dir(scratch.path(""))
        .args(args(&["-t", "html"]))
        .output()
        .unwrap();
    let page = String::from_utf8(page.stdout).unwrap();
    for given in [("tick", "float", "time"), ("area", "vec2", "resolution")] {
        let (name, ty, source) = given;
        let given = format!(r#""name":"{name}","type":"{ty}","source":"{source}""#);
        assert!(page.contains(&given), "{file}: {given}");
    }
    let text = fs::read_to_string(scratch.path(file)).unwrap();
    scratch.write(file, text.replace("/ area", "/ arae"));
    let wrong = run(&["--format", "short"]);
    assert!(
        wrong
            .out
            .contains("error[undeclared-name]: `arae` is not declared"),
        "{}",
        wrong.out
    );
    assert!(!ported(scratch, Path::new(file), more).1);
}

/// A user-defined host is equivalent to a built-in one.
#[test]
fn user_defined_hosts_equal_built_in_ones() {
    let names = "uniform float tick; // = time\nuniform vec2 area; // = resolution\n";
    let three = format!("// Mine\n//\n// As three.js.\n//\n// base: three\n// names: all\n{names}");
    let over = format!("// Mine\n//\n// More of three.js.\n//\n// names: all\n{names}");
    let image = format!(
        "// Mine\n//\n// A tool.\n//\n// version: 300 es\n// names: all\n// entry: mainImage\n{names}"
    );
    let main = "void main() { gl_FragColor = vec4(fract(tick), gl_FragCoord.xy / area, 1.0); }\n";
    let entry = "void mainImage(out vec4 c, in vec2 p) { c = vec4(fract(tick), p / area, 1.0); }\n";
    let prelude = "[host]\nprelude = \"host.glsl\"\n";
    let preset = "[host]\npreset = \"webgl\"\nprelude = \"host.glsl\"\n";
    for (host, code, toml) in [
        (&three, main, prelude),
        (&over, main, prelude),
        (&over, main, preset),
        (&image, entry, prelude),
    ] {
        let configured = [
            ("shaderlint.toml", toml),
            ("host.glsl", host),
            ("a.glsl", code),
        ];
        own_host(&Scratch::new(&configured), "a.glsl", &[]);
        let named = [("host.glsl", &host[..]), ("a.glsl", code)];
        own_host(&Scratch::new(&named), "a.glsl", &["--host", "host.glsl"]);
    }
}

/// Whether a text can identify the host.
fn is_shown(host: &Preset) -> bool {
    let names = &host.meanings;
    !host.signs.is_empty()
        || names.feeds.iter().any(|r| r.weight > 0)
        || names.textures.iter().any(|r| r.weight > 0)
        || names.varyings.iter().any(|r| r.weight > 0)
}

/// Each host that a text can identify has a fixture; the others are identified by something else.
#[test]
fn every_host_has_a_fixture_or_is_identified_otherwise() {
    // Nothing in or around a text identifies these: only the user can name them.
    const NAMED: [&str; 3] = ["openframeworks", "processing", "xscreensaver"];
    for host in presets() {
        let has_fixture = Path::new(DIALECTS).join(host.name).is_dir();
        let is_known = [&host.packages, &host.words, &host.globals];
        let is_known = is_known.iter().any(|all| !all.is_empty());
        let is_named = NAMED.contains(&host.name);
        assert!(
            has_fixture || !is_shown(host) && (is_known || is_named),
            "{}",
            host.name
        );
    }
    for (host, _) in fixtures() {
        assert!(preset(&host).is_some(), "{host}");
    }
}

/// The code that a host puts before shaders compiles.
#[test]
fn host_declarations_compile() {
    for host in presets() {
        for name in ["a.frag", "a.vert"] {
            let mut options = Options::new(DialectChoice::Auto, Settings::of_rules(&[]));
            options.host.preset = Some(host);
            let report = check(
                name,
                "float part(float x) {\n    return x;\n}\n",
                &options,
                &NoFiles,
            );
            let errors = report
                .diagnostics
                .iter()
                .filter(|d| d.severity == Severity::Error);
            let errors: Vec<&str> = errors.map(|d| d.message.as_str()).collect();
            assert!(errors.is_empty(), "{}, {name}: {errors:?}", host.name);
        }
    }
}

/// The current releases of a host may require a version that a shader lacks, and accept comments
/// before `#version`.
#[test]
fn hosts_require_versions() {
    let old = "varying vec2 v_texcoord;\nuniform sampler2D tex;\nvoid main() { gl_FragColor = texture2D(tex, v_texcoord); }\n";
    let old = format!("precision mediump float;\n{old}");
    let other = old.replace("uniform", "uniform float alpha;\nuniform");
    let new = "// A\n#version 300 es\nprecision highp float;\nin vec2 v_texcoord;\nuniform sampler2D tex;\n\
        out vec4 c;\nvoid main() { c = texture(tex, v_texcoord); }\n";
    let scratch = Scratch::new(&[("a.frag", &old), ("b.frag", &other), ("c.frag", new)]);
    assert_eq!(scratch.places(&["a.frag"]), ["1:1 unsupported-version"]);
    assert!(
        !scratch
            .places(&["b.frag"])
            .contains(&"1:1 unsupported-version".to_string())
    );
    assert_eq!(scratch.places(&["c.frag"]), [] as [&str; 0]);
}

#[test]
fn the_receiver_of_a_shader_decides_how_it_is_compiled() {
    const ES100: &str = "precision highp float; varying vec2 v; void main() { vec4 sample = vec4(v, 0.0, 1.0); gl_FragColor = sample; }";
    const OWN: &str =
        "precision highp float; in vec2 v; out vec4 c; void main() { c = vec4(v, 0.0, 1.0); }";
    const MACRO: &str =
        "precision highp float; in vec2 v; void main() { gl_FragColor = vec4(v, 0.0, 1.0); }";
    const HOST: &str =
        "precision highp float; void main() { gl_FragColor = vec4(cameraPosition, 1.0); }";
    let own_output = "output-location";
    for (material, shader, expected) in [
        ("ShaderMaterial({ ", ES100, "reserved-word"),
        ("RawShaderMaterial({ ", ES100, ""),
        (
            "RawShaderMaterial({ glslVersion: THREE.GLSL3, ",
            ES100,
            "legacy-glsl",
        ),
        ("ShaderMaterial({ ", OWN, own_output),
        ("ShaderMaterial({ glslVersion: THREE.GLSL3, ", OWN, ""),
        ("ShaderMaterial({ glslVersion: '300 es', ", OWN, ""),
        ("RawShaderMaterial({ glslVersion: THREE.GLSL3, ", OWN, ""),
        ("RawShaderMaterial({ ", OWN, "needs-webgl2"),
        ("ShaderMaterial({ ", MACRO, ""),
        ("ShaderMaterial({ ", HOST, ""),
        ("RawShaderMaterial({ ", HOST, "undeclared-name"),
        // It is not known what that adds.
        ("OwnMaterial({ ", OWN, ""),
    ] {
        for handed in [
            format!("const m = new THREE.{material}fragmentShader: `{shader}` }});"),
            format!(
                "const fragmentShader = `{shader}`; const m = new THREE.{material}fragmentShader }});"
            ),
        ] {
            let script = format!("import * as THREE from 'three';\n{handed}\n");
            let scratch = Scratch::new(&[("a.js", &script)]);
            let out = scratch.run(&["--format", "short", "a.js"]).out;
            let first = out.split_once(": error[").map_or("", |(_, code)| code);
            let first = first.split(']').next().unwrap_or("");
            assert_eq!(first, expected, "{handed}\n{out}");
        }
    }
}

#[test]
fn a_shader_file_is_compiled_as_the_materials_that_import_it() {
    let shader =
        "varying vec2 v; void main() { vec4 sample = vec4(v, 0.0, 1.0); gl_FragColor = sample; }";
    let material = |name: &str| {
        format!(
            "import * as THREE from 'three';\nimport frag from './a.frag';\n\
             export const m = new THREE.{name}({{ fragmentShader: frag }});\n"
        )
    };
    let package = ("package.json", r#"{"dependencies":{"three":"^0.170.0"}}"#);
    for (name, line) in [
        ("ShaderMaterial", "a.frag:1:36: error[reserved-word]"),
        ("OwnMaterial", ""),
        // Without a default precision.
        ("RawShaderMaterial", "a.frag:1:9: error[missing-precision]"),
    ] {
        let script = material(name);
        let files = [("a.frag", shader), ("m.js", script.as_str()), package];
        let out = Scratch::new(&files).run(&["--format", "short", "."]).out;
        assert!(out.starts_with(line), "{name}: {out}");
    }
}

#[test]
fn names_that_a_library_has_removed_are_reported_with_the_release() {
    let material = "import * as THREE from 'three';\nconst m = new THREE.ShaderMaterial({ fragmentShader: `\
                    uniform sampler2D map; void main() { gl_FragColor = \
                    mapTexelToLinear(texture2D(map, gl_FragCoord.xy)); }` });\n";
    let own =
        format!("{material}const helper = `vec4 mapTexelToLinear(vec4 c) {{ return c; }}`;\n");
    for (package, script, expected) in [
        ("^0.170.0", material, "error"),
        ("0.136.2", material, ""),
        (">=0.130", material, "warning"),
        ("^0.170.0", own.as_str(), ""),
    ] {
        let package = format!(r#"{{"dependencies":{{"three":"{package}"}}}}"#);
        let files = [("a.js", script), ("package.json", package.as_str())];
        let out = Scratch::new(&files).run(&["--format", "short", "a.js"]).out;
        let message = "three.js removed `mapTexelToLinear` in r137; remove the call";
        let line = out.lines().find(|line| line.contains(message));
        let level = line.map_or("", |l| l.split([' ', '[']).nth(1).unwrap_or(""));
        assert_eq!(level, expected, "{package}\n{out}");
    }
}
