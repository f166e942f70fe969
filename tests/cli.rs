//! The command line as people and programs use it: flags, exit codes, and every format on one
//! fixture.

use super::scratch::Scratch;
use insta_cmd::{assert_cmd_snapshot, get_cargo_bin};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

fn fixtures() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures")
}

fn command(name: &str, args: &[&str]) -> Command {
    let mut command = Command::new(get_cargo_bin(name));
    command
        .current_dir(fixtures())
        .args(args)
        .env("NO_COLOR", "1");
    command
}

fn lint(args: &[&str]) -> Command {
    command("shaderlint", args)
}

fn lint_stdin(args: &[&str], text: &str) -> Output {
    let mut child = lint(args)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child
        .stdin
        .take()
        .unwrap()
        .write_all(text.as_bytes())
        .unwrap();
    child.wait_with_output().unwrap()
}

#[test]
fn the_human_format_shows_the_code() {
    assert_cmd_snapshot!(lint(&["mixed.glsl"]));
}

#[test]
fn the_short_format_has_one_line_per_finding() {
    assert_cmd_snapshot!(lint(&["--format", "short", "mixed.glsl"]));
}

#[test]
fn json_output_lists_all_findings() {
    assert_cmd_snapshot!(lint(&["--format", "json", "mixed.glsl"]));
}

#[test]
fn jsonl_output_has_one_finding_per_line() {
    assert_cmd_snapshot!(lint(&["--format", "jsonl", "mixed.glsl"]));
}

#[test]
fn findings_are_coloured_on_request() {
    assert_cmd_snapshot!(lint(&["--color", "always", "warned.glsl"]));
}

#[test]
fn an_export_names_its_passes() {
    assert_cmd_snapshot!(lint(&["export.json"]));
}

#[test]
fn clean_files_are_summarised() {
    assert_cmd_snapshot!(lint(&["clean.glsl"]));
}

#[test]
fn warnings_pass_unless_denied() {
    assert_eq!(
        lint(&["warned.glsl"]).output().unwrap().status.code(),
        Some(0)
    );
    let denied = lint(&["--deny-warnings", "warned.glsl"]).output().unwrap();
    assert_eq!(denied.status.code(), Some(1));
    let ignored = lint(&[
        "--deny-warnings",
        "--ignore",
        "numeric,runtime",
        "warned.glsl",
    ]);
    assert_eq!({ ignored }.output().unwrap().status.code(), Some(0));
}

#[test]
fn folders_are_searched_for_shaders() {
    assert_cmd_snapshot!(lint(&["--format", "short", "folder"]));
}

#[test]
fn folders_without_shaders_are_reported() {
    assert_cmd_snapshot!(lint(&["without"]));
}

#[test]
fn missing_files_are_reported_and_others_checked() {
    assert_cmd_snapshot!(lint(&["missing.glsl", "clean.glsl"]));
}

#[test]
fn named_json_files_that_are_not_exports_are_errors() {
    assert_cmd_snapshot!(lint(&["folder/package.json"]));
}

#[test]
fn empty_files_are_reported() {
    assert_cmd_snapshot!(lint(&["empty.glsl"]));
}

#[test]
fn files_that_are_not_utf8_are_reported() {
    assert_cmd_snapshot!(lint(&["latin1.glsl"]));
}

#[test]
fn nul_characters_are_errors() {
    assert_cmd_snapshot!(lint(&["nul.glsl"]));
}

#[test]
fn unknown_rules_get_suggestions() {
    assert_cmd_snapshot!(lint(&["--ignore", "float-equalty", "clean.glsl"]));
}

#[test]
fn without_a_path_the_current_folder_is_checked() {
    let run = |args: &[&str]| lint(args).output().unwrap();
    assert_eq!(run(&[]), run(&["."]));
}

#[test]
fn the_help_lists_all_options() {
    assert_cmd_snapshot!(lint(&["--help"]));
    // The list of targets depends on the features; the snapshot contains all of them.
    if cfg!(feature = "naga") {
        assert_cmd_snapshot!(command("shaderport", &["--help"]));
    }
}

#[test]
fn standard_input_is_checked_as_the_named_file() {
    let out = lint_stdin(
        &["-", "--stdin-filename", "a/b.vert", "--format", "short"],
        "#version 300 es\nvoid main() { gl_Position = vec3(1.0); }\n",
    );
    let text = String::from_utf8(out.stdout).unwrap();
    assert!(text.starts_with("a/b.vert:2:"), "{text}");
    assert_eq!(out.status.code(), Some(1));
}

#[test]
fn the_dialect_can_be_specified() {
    let code = "precision highp float;\nvoid main() { gl_FragColor = vec4(1.0); }\n";
    for (dialect, errors) in [("auto", 0), ("webgl1", 0), ("webgl2", 1), ("shadertoy", 1)] {
        let out = lint_stdin(&["-", "--dialect", dialect], code);
        assert_eq!(out.status.code(), Some(errors), "{dialect}");
    }
}

#[test]
fn output_is_deterministic() {
    let run = || lint(&["--format", "json", "."]).output().unwrap().stdout;
    assert_eq!(run(), run());
}

/// Exit code and messages of `shaderport` in a folder, where the first argument may name a fixture.
fn port(folder: &Scratch, args: &[&str]) -> (Option<i32>, String) {
    let mut all: Vec<String> = args.iter().map(|a| a.to_string()).collect();
    if let Some(input) = all.first_mut()
        && !input.starts_with('-')
    {
        *input = fixtures().join(&input).to_string_lossy().into_owned();
    }
    let out = folder.port_command("").args(&all).output().unwrap();
    let fixtures = format!("{}/", fixtures().display());
    let text = String::from_utf8(out.stderr).unwrap();
    (out.status.code(), text.replace(&fixtures, ""))
}

fn count_files(folder: &Scratch) -> usize {
    fs::read_dir(folder.path("")).unwrap().count()
}

#[test]
fn existing_pages_are_not_overwritten() {
    let folder = Scratch::new(&[]);
    assert_eq!(
        port(&folder, &["clean.glsl", "-o", "a.html"]),
        (Some(0), String::new())
    );
    assert!(folder.read("a.html").starts_with("<!doctype html>"));
    let (code, text) = port(&folder, &["warned.glsl", "-o", "a.html"]);
    assert_eq!(code, Some(2));
    assert_eq!(
        text,
        "shaderport: a.html already exists; use --force to overwrite it\n"
    );
    let before = folder.read("a.html");
    assert_eq!(
        port(&folder, &["warned.glsl", "-o", "a.html", "--force"]).0,
        Some(0)
    );
    assert_ne!(before, folder.read("a.html"));
    assert_eq!(count_files(&folder), 1);
}

#[test]
fn shaders_are_written_as_a_vertex_and_fragment_pair() {
    let folder = Scratch::new(&[]);
    assert_eq!(port(&folder, &["clean.glsl", "-o", "a.frag"]).0, Some(0));
    assert!(folder.read("a.frag").starts_with("#version 300 es\n"));
    assert!(folder.read("a.vert").starts_with("#version 300 es\n"));
    fs::remove_file(folder.path("a.frag")).unwrap();
    assert_eq!(port(&folder, &["clean.glsl", "-o", "a.frag"]).0, Some(2));
    assert_eq!(
        count_files(&folder),
        1,
        "an existing file prevents writing both"
    );
}

#[test]
fn invalid_input_writes_no_files() {
    let folder = Scratch::new(&[]);
    let check = |input: &str, message: &str| {
        let (code, text) = port(&folder, &[input, "-o", "a.html"]);
        assert_eq!(
            (code, text),
            (Some(2), format!("shaderport: {input}: {message}\n"))
        );
    };
    check("missing.glsl", "no such file or folder");
    check(
        "empty.glsl",
        "no entry point: expected `mainImage` (ShaderToy) or `main`",
    );
    check(
        "folder/package.json",
        "not a ShaderToy export: `renderpass` is missing",
    );
    assert_eq!(count_files(&folder), 0);
}

#[cfg(not(feature = "naga"))]
#[test]
fn target_languages_that_are_not_compiled_in_are_rejected() {
    let folder = Scratch::new(&[]);
    for extension in ["wgsl", "spv", "hlsl", "metal"] {
        let (code, text) = port(&folder, &["clean.glsl", "-o", &format!("a.{extension}")]);
        assert_eq!(code, Some(2));
        assert!(text.contains("--features naga"), "{text}");
    }
    assert_eq!(count_files(&folder), 0);
}

#[test]
fn a_folder_of_passes_is_one_project() {
    let folder = Scratch::new(&[]);
    let (code, text) = port(&folder, &["passes", "--channel", "0=buffer_a", "-o", "out"]);
    assert_eq!((code, text.as_str()), (Some(0), ""));
    assert_eq!(count_files(&folder), 1);
    for file in ["image.frag", "buffer_a.frag", "pass.vert"] {
        assert!(
            folder
                .read(&format!("out/{file}"))
                .starts_with("#version 300 es\n")
        );
    }
    assert!(folder.read("out/image.frag").contains("#define SHARED"));
    let (code, text) = port(
        &folder,
        &["passes", "--channel", "0=buffer_b", "-o", "a.html"],
    );
    assert_eq!(code, Some(2));
    assert_eq!(
        text,
        "shaderport: --channel: the project has no pass `buffer_b`; it has `image`, `buffer_a`\n"
    );
    let twice = ["passes", "--pass", "image=clean.glsl", "-o", "a.html"];
    assert_eq!(port(&folder, &twice).0, Some(2));
    assert_eq!(count_files(&folder), 1);
}

#[test]
fn webgl1_code_in_shadertoy_shaders_is_repaired() {
    let folder = Scratch::new(&[]);
    let (code, text) = port(&folder, &["old.glsl", "-o", "a.frag"]);
    assert_eq!(code, Some(1), "only with an option");
    assert!(text.ends_with("`--diff` shows how\n"), "{text}");
    let (code, text) = port(&folder, &["old.glsl", "--repair", "-o", "b.frag"]);
    assert_eq!(code, Some(0), "{text}");
    insta::assert_snapshot!(text);
    assert!(folder.read("a.frag").contains("texture2D"));
    assert!(folder.read("b.frag").contains("samplerCube iChannel1"));
    let (code, _) = port(&folder, &["old.glsl", "--diff", "-o", "c.frag"]);
    assert_eq!(
        (code, count_files(&folder)),
        (Some(0), 4),
        "a diff writes nothing"
    );
    insta::assert_snapshot!(stdout("old.glsl"));
}

#[test]
fn webgl1_shaders_are_repaired() {
    let folder = Scratch::new(&[]);
    let (code, text) = port(&folder, &["webgl1.frag", "-o", "a.html"]);
    assert_eq!(code, Some(0), "a page plays it unchanged: {text}");
    let (code, text) = port(&folder, &["webgl1.frag", "--repair", "-o", "b.html"]);
    assert_eq!(code, Some(0), "{text}");
    insta::assert_snapshot!(stdout("webgl1.frag"));
}

/// Output of `--diff` for a fixture.
fn stdout(name: &str) -> String {
    let out = Command::new(get_cargo_bin("shaderport"))
        .current_dir(fixtures())
        .args([name, "--diff"])
        .output()
        .unwrap();
    String::from_utf8(out.stdout).unwrap()
}

#[test]
fn main_is_rewritten_where_it_is_safe() {
    let folder = Scratch::new(&[]);
    let rewritten = ["clean.glsl", "--main", "rewrite", "-o", "a.frag"];
    assert_eq!(port(&folder, &rewritten), (Some(0), String::new()));
    insta::assert_snapshot!(folder.read("a.frag"));
    let kept = ["returns.glsl", "--main", "rewrite", "-o", "b.frag"];
    let (code, text) = port(&folder, &kept);
    assert_eq!(code, Some(0));
    insta::assert_snapshot!(text);
    assert!(
        folder
            .read("b.frag")
            .contains("mainImage(color, gl_FragCoord.xy);")
    );
}

#[test]
fn external_text_cannot_escape_its_element() {
    let folder = Scratch::new(&[]);
    let hostile = "</script><script>alert(1)</script><!--<script>\u{2028}`${x}`";
    let code = format!("// {hostile}\nvoid mainImage(out vec4 c, in vec2 p) {{ c = vec4(1.0); }}");
    let export = serde_json::json!({
        "info": {"name": hostile, "username": hostile, "id": hostile, "description": hostile},
        "renderpass": [{"type": "image", "name": hostile, "code": code, "inputs": [], "outputs": []}],
    });
    let path = folder.path("hostile.json");
    fs::write(&path, export.to_string()).unwrap();
    assert_eq!(
        port(&folder, &[path.to_str().unwrap(), "-o", "a.html"]).0,
        Some(0)
    );
    let page = folder.read("a.html");
    assert_eq!(page.matches("<script").count(), 3);
    assert_eq!(page.matches("</script").count(), 3);
    assert!(!page.contains("<!--") && !page.contains('\u{2028}'));
}

#[test]
fn excerpts_in_markdown_are_checked() {
    assert_cmd_snapshot!(lint(&["--format", "short", "notes.md"]));
}

#[test]
fn tests_in_glsl_are_run_and_reported() {
    assert_cmd_snapshot!(lint(&["test", "tested"]));
    assert_cmd_snapshot!(lint(&["test", "--help"]));
    assert_cmd_snapshot!(lint(&["test", "parameters"]));
}
