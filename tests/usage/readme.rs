//! Every command in the README does what it says, in an empty home and a copy of the corpus.
//!
//! What stands in fences of `sh` is run line by line. `cargo` is not run: what it is asked for must be
//! there, and what needs a feature is run where the tests are built with it. Names of files that a
//! reader has, and the repository has not, stand for fixtures.

use super::scratch::{BROKEN, root};
use insta_cmd::get_cargo_bin;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};

/// What the README calls files that its reader has, and what they are here.
const READERS: [(&str, &str); 4] = [
    ("image.glsl", "tests/fixtures/clean.glsl"),
    ("photo.jpg", "tests/browser/page.png"),
    ("folder", "tests/fixtures/passes"),
    ("src", "tests/fixtures/passes"),
];

/// What words of the README with two hyphens are `cargo`'s.
const CARGO: [&str; 5] = ["--", "--features", "--path", "--release", "--bin"];

/// Options that only programs with the feature `naga` have.
const OF_NAGA: [&str; 2] = ["--interface", "--first-row"];

/// A stage each.
const MESH: [(&str, &str); 2] = [
    (
        "mesh.vert",
        "#version 300 es\nin vec3 place;\nout vec3 color;\nvoid main() {\n    \
         color = place;\n    gl_Position = vec4(place, 1.0);\n}\n",
    ),
    (
        "mesh.frag",
        "#version 300 es\nprecision highp float;\nin vec3 color;\nout vec4 c;\n\
         void main() {\n    c = vec4(color, 1.0);\n}\n",
    ),
];

/// An export that compiles.
const EXPORT: &str = r#"{"info": {"name": "x"}, "renderpass": [{"type": "image", "name": "Image",
    "code": "void mainImage(out vec4 c, in vec2 p) { c = vec4(p, 0.0, 1.0); }",
    "inputs": [], "outputs": []}]}"#;

/// Old code that can be repaired.
const OLD: &str = "void mainImage(out vec4 c, in vec2 p) {\n    \
    c = texture2D(iChannel0, p / iResolution.xy);\n}\n";

/// The fences of one language.
fn fences<'a>(text: &'a str, language: &str) -> Vec<&'a str> {
    let open = format!("```{language}\n");
    let starts = text.match_indices(&open).map(|(at, _)| at + open.len());
    starts
        .map(|from| text[from..].split("\n```").next().unwrap())
        .collect()
}

fn copy(from: &Path, to: &Path) {
    if from.is_dir() {
        fs::create_dir_all(to).unwrap();
        for entry in fs::read_dir(from).unwrap() {
            let entry = entry.unwrap();
            copy(&entry.path(), &to.join(entry.file_name()));
        }
    } else {
        fs::copy(from, to).unwrap();
    }
}

/// A copy of what the commands read, and an empty home.
struct Place {
    folder: tempfile::TempDir,
    readme: String,
}

impl Place {
    fn new() -> Place {
        let folder = tempfile::tempdir().unwrap();
        let work = folder.path().join("work");
        copy(&root().join("corpus"), &work.join("corpus"));
        for (name, fixture) in READERS {
            copy(&root().join(fixture), &work.join(name));
        }
        for (name, text) in MESH {
            fs::write(work.join(name), text).unwrap();
        }
        fs::write(work.join("export.json"), EXPORT).unwrap();
        fs::write(work.join("old.glsl"), OLD).unwrap();
        fs::write(work.join("broken.frag"), BROKEN).unwrap();
        fs::create_dir(folder.path().join("home")).unwrap();
        let readme = fs::read_to_string(root().join("README.md")).unwrap();
        Place { folder, readme }
    }

    /// A line that is run with the programs on the path.
    fn command(&self, line: &str) -> Command {
        let programs = get_cargo_bin("shaderlint");
        let path = std::env::var("PATH").unwrap_or_default();
        let path = format!("{}:{path}", programs.parent().unwrap().display());
        let mut command = Command::new("bash");
        command
            .args(["-c", line])
            .current_dir(self.folder.path().join("work"))
            .env("HOME", self.folder.path().join("home"))
            .env("PATH", path);
        command
    }

    /// Runs a line; gives the exit code and all that is printed.
    fn run(&self, line: &str) -> (Option<i32>, String) {
        let output = self.command(line).output().unwrap();
        let mut told = String::from_utf8_lossy(&output.stdout).into_owned();
        told.push_str(&String::from_utf8_lossy(&output.stderr));
        (output.status.code(), told)
    }

    /// Runs a line until it waits for changes.
    fn watch(&self, line: &str) {
        let mut command = self.command(&format!("exec {line}"));
        command.stdout(Stdio::null()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        let told = BufReader::new(child.stderr.take().unwrap()).lines();
        let mut told = told.map(Result::unwrap);
        let waits = told.any(|line| line.contains("waiting for changes"));
        child.kill().unwrap();
        child.wait().unwrap();
        assert!(waits, "{line}");
    }
}

/// What `cargo` is asked for must be there; gives the command that its `run` stands for.
fn judge_cargo(line: &str) -> Option<String> {
    let manifest = fs::read_to_string(root().join("Cargo.toml")).unwrap();
    let words: Vec<&str> = line.split_whitespace().collect();
    let value = |flag: &str| words.iter().position(|w| *w == flag).map(|i| words[i + 1]);
    if let Some(features) = value("--features") {
        for feature in features.split(',') {
            assert!(manifest.contains(&format!("\n{feature} = ")), "{line}");
        }
    }
    match words[1] {
        "install" => assert_eq!(value("--path"), Some("."), "{line}"),
        "build" | "test" => {}
        "run" => {
            let program = value("--bin").unwrap_or("shaderlint");
            assert!(manifest.contains("default-run = \"shaderlint\""));
            let given = line.split_once(" -- ").map_or("", |(_, given)| given);
            return Some(format!("{program} {given}"));
        }
        other => panic!("`cargo {other}` is not known here: {line}"),
    }
    None
}

#[cfg(unix)]
#[test]
fn every_command_runs_in_an_empty_home() {
    let place = Place::new();
    let mut ran = 0;
    for fence in fences(&place.readme, "sh") {
        // Behind an installation with a feature, the programs of that feature are meant.
        let mut wants_feature = false;
        for line in fence.lines() {
            let line = line.split(" # ").next().unwrap().trim();
            let mut command = line.to_string();
            if line.is_empty() || line.starts_with('#') {
                continue;
            } else if line.starts_with("cargo ") {
                wants_feature |= line.contains("--features");
                match judge_cargo(line) {
                    Some(run) => command = run,
                    None => continue,
                }
            } else if line.starts_with("tests/") {
                let program = line.split_whitespace().next().unwrap();
                assert!(root().join(program).is_file(), "{line}");
                continue;
            }
            if wants_feature && !cfg!(feature = "naga") {
                continue;
            }
            ran += 1;
            if command.contains(" --watch") {
                place.watch(&command);
                continue;
            }
            let (code, told) = place.run(&command);
            let finds = command.starts_with("shaderlint ") && code == Some(1);
            assert!(code == Some(0) || finds, "{line}: {code:?}\n{told}");
        }
    }
    assert!(ran >= 8, "only {ran} commands were found");
}

#[test]
fn every_option_and_path_of_the_text_exists() {
    let place = Place::new();
    let (_, lint) =
        place.run("shaderlint --help; shaderlint rules --help; shaderlint reduce --help; shaderlint run --help; shaderlint test --help; shaderlint fmt --help");
    let (_, port) = place.run("shaderport --help");
    let is_end = |c: char| !c.is_ascii_alphanumeric() && c != '-';
    for code in place.readme.split('`').skip(1).step_by(2) {
        let is_option = |w: &&str| w.starts_with("--") && !w.starts_with("---");
        for word in code.split(is_end).filter(is_option) {
            let known = [&lint, &port].iter().any(|help| help.contains(word));
            let is_built = cfg!(feature = "naga") || !OF_NAGA.contains(&word);
            assert!(known || CARGO.contains(&word) || !is_built, "`{word}`");
        }
    }
    for link in place.readme.split("](").skip(1) {
        let target = link.split([')', '#']).next().unwrap();
        let is_here = target.contains("://") || target.is_empty();
        assert!(is_here || root().join(target).exists(), "{target}");
    }
}

/// A hook takes its programs from a tag that exists, or the reader is told to name one.
#[test]
fn the_hook_names_no_tag_that_does_not_exist() {
    let place = Place::new();
    let fences = fences(&place.readme, "yaml");
    let revisions = fences.iter().flat_map(|f| f.lines());
    let revisions = revisions.filter_map(|l| l.trim().strip_prefix("rev:"));
    for revision in revisions {
        let named = revision.split('#').next().unwrap().trim();
        let is_placeholder = !named.is_empty() && named.chars().all(|c| c.is_ascii_uppercase());
        let tags = Command::new("git")
            .args(["tag", "--list"])
            .current_dir(root())
            .output();
        let tags = tags.map_or(String::new(), |t| String::from_utf8(t.stdout).unwrap());
        assert!(
            is_placeholder || tags.lines().any(|t| t == named),
            "{named} is no tag"
        );
    }
}
