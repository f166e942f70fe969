//! Who runs a shader: both programs read the same table, and say the same.

use super::scratch::Scratch;
use insta_cmd::get_cargo_bin;
use shaderlint::diagnostic::Severity;
use shaderlint::engine::{DialectChoice, NoFiles, Options, check};
use shaderlint::host::{Preset, preset, presets};
use shaderlint::lint::Settings;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;

const DIALECTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/dialects");

/// The shaders of the fixtures, by host; not those that others take in.
fn fixtures() -> Vec<(String, PathBuf)> {
    let mut all = Vec::new();
    for folder in fs::read_dir(DIALECTS).unwrap() {
        let folder = folder.unwrap().path();
        let host = folder.file_name().unwrap().to_str().unwrap().to_string();
        for file in fs::read_dir(folder).unwrap() {
            let path = file.unwrap().path();
            let is_shader = path.extension().is_some_and(|e| e != "vs" && e != "sprj");
            if path.is_file() && is_shader {
                all.push((host.clone(), path));
            }
        }
    }
    all.sort();
    all
}

/// What `shaderport` says that a file was read as, and whether it makes something of it.
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
    let said = String::from_utf8(out.stderr).unwrap();
    let line = said.lines().find_map(|l| l.strip_prefix("note: read as "));
    let told = line.map(|l| l.split("; as much").next().unwrap_or(l).to_string());
    (told, out.status.success())
}

#[test]
fn both_programs_read_a_shader_alike() {
    let scratch = Scratch::new(&[]);
    for (host, path) in fixtures() {
        let (told, _) = ported(&scratch, &path, &[]);
        let linted = scratch.run(&["-v", path.to_str().unwrap()]);
        let name = path.file_name().unwrap().to_str().unwrap();
        let line = linted.err.lines().find(|l| l.contains(": read as "));
        let (_, line) = line
            .unwrap_or_else(|| panic!("{name}: {}", linted.err))
            .split_once(": read as ")
            .unwrap();
        match told {
            Some(told) => assert!(
                line.starts_with(&format!("{told}: ")),
                "{host}/{name}: {line}\n{told}"
            ),
            None => {
                let is_told = presets().any(|p| line.starts_with(&format!("{}, by ", p.read_as())));
                assert!(!is_told, "{host}/{name}: {line}");
            }
        }
    }
}

/// What plays is not refused for its dialect.
#[test]
fn what_one_program_plays_the_other_does_not_refuse() {
    let scratch = Scratch::new(&[]);
    for (host, path) in fixtures() {
        if !["bonzomatic", "kodelife", "kodi", "synthclipse"].contains(&host.as_str()) {
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
        }
    }
}

#[test]
fn a_name_of_no_host_is_told_with_those_close_to_it() {
    let scratch = Scratch::new(&[("a.glsl", "void main() {}")]);
    let ran = scratch.run(&["a.glsl", "--host", "bonzomatik"]);
    let said = "there is no host `bonzomatik`; did you mean `bonzomatic`?";
    assert_eq!(ran.code, 2);
    assert!(ran.err.contains(said), "{}", ran.err);
    let (told, plays) = ported(&scratch, Path::new("a.glsl"), &["--from", "bonzomatik"]);
    assert!(told.is_none() && !plays);
    assert_eq!(
        scratch
            .run(&["a.glsl", "--host", "three", "--dialect", "webgl2"])
            .code,
        2
    );
}

/// A desktop shader that nothing shows the host of is no shader of WebGL; the user may name one.
#[test]
fn a_desktop_shader_of_no_host_is_refused() {
    let code = "#version 330 core\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    assert_eq!(scratch.places(&["a.glsl"]), ["1:1 unsupported-version"]);
    assert_eq!(scratch.run(&["a.glsl", "--host", "kodelife"]).code, 0);
}

/// Places are those of the file, whatever goes around it.
#[test]
fn mistakes_in_a_desktop_shader_are_found_where_they_are() {
    let code = "#version 150\nin VertexData {\n    vec2 v_texcoord;\n} inData;\n\
        uniform vec3 spectrum;\nout vec4 c;\nvoid main() {\n    c = vec4(spectrums, 1) * inData.v_texcoord.x;\n}\n";
    let scratch = Scratch::new(&[("a.glsl", code)]);
    let places = scratch.places(&["a.glsl"]);
    assert!(
        places.contains(&"8:14 undeclared-name".to_string()),
        "{places:?}"
    );
}

/// A host of one's own says what its names mean, too.
#[test]
fn a_described_host_builds_on_another() {
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
        ran.err.contains("host.glsl:5: `tmie` is none of"),
        "{}",
        ran.err
    );
    assert!(ran.err.contains("did you mean `time`?"), "{}", ran.err);
    scratch.write("host.glsl", host.replace("tmie", "time"));
    assert_eq!(scratch.run(&["a.frag"]).code, 0);
}

/// Whether something in a text shows a host.
fn is_shown(host: &Preset) -> bool {
    let names = &host.meanings;
    !host.signs.is_empty()
        || names.feeds.iter().any(|r| r.weight > 0)
        || names.textures.iter().any(|r| r.weight > 0)
        || names.varyings.iter().any(|r| r.weight > 0)
}

/// A host that a text shows has a shader that shows it; of others something around the text does.
#[test]
fn every_host_has_a_fixture_or_is_known_by_other_things() {
    // Nothing around a text shows these: only the user says it.
    const NAMED: [&str; 2] = ["openframeworks", "processing"];
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

/// What a host puts before shaders compiles.
#[test]
fn what_hosts_declare_compiles() {
    for host in presets() {
        for name in ["a.frag", "a.vert"] {
            let mut options = Options::new(DialectChoice::Auto, Settings::of_rules(&[]));
            options.host.preset = Some(Arc::new(host.clone()));
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
