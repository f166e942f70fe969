//! Tests README.md and docs/*.md: every command runs, in an empty home and a copy of the corpus, every
//! option and link exists, and the README is short.
//!
//! Fences of `sh` are run line by line. Fences of `console` hold a command after `$` and exactly what it
//! prints; `INSTA_UPDATE=always cargo test` writes it. `cargo` is not run, but its package and features
//! must exist; a fence that installs a feature is run where the tests are built with it. What installs
//! packages is run by `tests/package/run`, which must contain it. Names of files that only a reader has
//! are fixtures.

use super::super::recorded::stale;
use crate::scratch::{BROKEN, Scratch, root};
use insta_cmd::get_cargo_bin;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};

/// Files that the documentation expects its reader to have, and the fixtures used in their place.
const READERS: [(&str, &str); 6] = [
    ("image.glsl", "tests/fixtures/clean.glsl"),
    ("water.glsl", "tests/fixtures/clean.glsl"),
    ("toys/sky.glsl", "tests/fixtures/clean.glsl"),
    ("photo.jpg", "tests/browser/page.png"),
    ("folder", "tests/fixtures/passes"),
    ("src", "tests/fixtures/passes"),
];

/// Options of `cargo`.
const CARGO: [&str; 6] = ["--", "--features", "--path", "--release", "--bin", "--git"];

/// Options of programs that install packages or run containers.
const INSTALLERS: [&str; 6] = [
    "--to",
    "--rm",
    "--volume",
    "--user",
    "--check",
    "--ignore-missing",
];

/// Words of the README, code included.
const MOST_WORDS: usize = 900;

/// Options of programs built with the feature `naga`.
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

/// The README and the pages of `docs`, by path in the repository.
fn texts() -> Vec<(String, String)> {
    let mut paths = vec!["README.md".to_string()];
    for entry in fs::read_dir(root().join("docs")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        paths.push(format!("docs/{name}"));
    }
    paths.sort();
    let read = |path: String| {
        let text = fs::read_to_string(root().join(&path)).unwrap();
        (path, text)
    };
    paths.into_iter().map(read).collect()
}

/// The folders of the corpus that the pages name.
const CORPUS: [&str; 4] = [
    "corpus/mistakes",
    "corpus/pitfalls",
    "corpus/templates",
    "corpus/tests",
];

/// A copy of the files that commands read, and an empty home.
struct Place {
    folder: Scratch,
}

impl Place {
    fn new() -> Place {
        let folder = Scratch::new(&[]);
        let work = folder.path("work");
        for name in CORPUS {
            copy(&root().join(name), &work.join(name));
        }
        for (name, fixture) in READERS {
            let to = work.join(name);
            fs::create_dir_all(to.parent().unwrap()).unwrap();
            copy(&root().join(fixture), &to);
        }
        for (name, text) in MESH {
            fs::write(work.join(name), text).unwrap();
        }
        fs::write(work.join("export.json"), EXPORT).unwrap();
        fs::write(work.join("old.glsl"), OLD).unwrap();
        fs::write(work.join("broken.frag"), BROKEN).unwrap();
        fs::create_dir(folder.path("home")).unwrap();
        Place { folder }
    }

    /// A command line with the programs on `PATH`.
    fn command(&self, line: &str) -> Command {
        let programs = get_cargo_bin("shaderlint");
        let path = std::env::var("PATH").unwrap_or_default();
        let path = format!("{}:{path}", programs.parent().unwrap().display());
        let mut command = Command::new("bash");
        command
            .args(["-c", line])
            .current_dir(self.folder.path("work"))
            .env("HOME", self.folder.path("home"))
            .env("PATH", path);
        command
    }

    /// Runs a line; gives the exit code and all that is printed.
    fn run(&self, line: &str) -> (Option<i32>, String) {
        let output = self.command(line).output().unwrap();
        let mut printed = String::from_utf8_lossy(&output.stdout).into_owned();
        printed.push_str(&String::from_utf8_lossy(&output.stderr));
        (output.status.code(), printed)
    }

    /// Runs a line until it waits for changes.
    fn watch(&self, line: &str) {
        let mut command = self.command(&format!("exec {line}"));
        command.stdout(Stdio::null()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        let lines = BufReader::new(child.stderr.take().unwrap()).lines();
        let mut lines = lines.map(Result::unwrap);
        let waits = lines.any(|line| line.contains("waiting for changes"));
        child.kill().unwrap();
        child.wait().unwrap();
        assert!(waits, "{line}");
    }
}

/// What `cargo` is asked for must be there; gives the command that its `run` stands for.
fn check_cargo(line: &str) -> Option<String> {
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

/// Runs the commands of a fence; gives how many.
fn run_fence(place: &Place, fence: &str) -> usize {
    let mut ran = 0;
    // After an installation with a feature, the programs of that feature are meant.
    let mut needs_feature = false;
    for line in fence.lines() {
        let line = line.split(" # ").next().unwrap().trim();
        let mut command = line.to_string();
        if line.is_empty() || line.starts_with('#') {
            continue;
        } else if line.starts_with("cargo ") {
            needs_feature |= line.contains("--features");
            match check_cargo(line) {
                Some(run) => command = run,
                None => continue,
            }
        } else if ["pip ", "npm ", "npx "].iter().any(|p| line.starts_with(p)) {
            let test = fs::read_to_string(root().join("tests/package/run")).unwrap();
            assert!(
                test.contains(line),
                "tests/package/run does not run: {line}"
            );
            continue;
        } else if line.starts_with("tests/") || line.starts_with("src/") {
            let program = line.split_whitespace().next().unwrap();
            assert!(root().join(program).is_file(), "{line}");
            continue;
        }
        if needs_feature && !cfg!(feature = "naga") {
            continue;
        }
        ran += 1;
        if command.contains(" --watch") {
            place.watch(&command);
            continue;
        }
        let (code, printed) = place.run(&command);
        let finds = command.split(' ').next() == Some("shaderlint") && code == Some(1);
        assert!(code == Some(0) || finds, "{line}: {code:?}\n{printed}");
    }
    ran
}

#[cfg(unix)]
#[test]
fn documented_commands_run_in_an_empty_home() {
    let check = |path: &str, text: &str| {
        let place = Place::new();
        let ran = fences(text, "sh").into_iter().map(|f| run_fence(&place, f));
        let ran: usize = ran.sum();
        println!("{path}: {ran}");
        assert!(path != "README.md" || ran >= 8, "only {ran} commands");
    };
    let texts = texts();
    std::thread::scope(|scope| {
        for (path, text) in &texts {
            scope.spawn(|| check(path, text));
        }
    });
}

#[cfg(unix)]
#[test]
fn documented_output_is_up_to_date() {
    let place = Place::new();
    let mut shown = 0;
    for (path, text) in texts() {
        let mut fresh = text.clone();
        for fence in fences(&text, "console") {
            let command = fence.lines().next().and_then(|l| l.strip_prefix("$ "));
            let command = command.expect("a fence of `console` starts with a command");
            let (_, printed) = place.run(command);
            let printed = format!("$ {command}\n{}", printed.trim_end());
            fresh = fresh.replacen(fence, &printed, 1);
            shown += 1;
        }
        assert_eq!(stale(&root().join(&path), &fresh), None);
    }
    assert!(shown > 0, "no fence of `console` was found");
}

#[test]
fn documented_options_and_paths_exist() {
    let place = Place::new();
    let (_, lint) = place.run(
        "shaderlint --help; for c in rules reduce run test fmt types reflect; do shaderlint $c --help; done",
    );
    let (_, port) = place.run("shaderport --help; shaderport gallery --help");
    let others = [CARGO.as_slice(), &INSTALLERS].concat();
    let is_end = |c: char| !c.is_ascii_alphanumeric() && c != '-';
    for (path, text) in texts() {
        for code in text.split('`').skip(1).step_by(2) {
            let is_option = |w: &&str| w.starts_with("--") && !w.starts_with("---");
            for word in code.split(is_end).filter(is_option) {
                let known = [&lint, &port].iter().any(|help| help.contains(word));
                let is_built = cfg!(feature = "naga") || !OF_NAGA.contains(&word);
                assert!(
                    known || others.contains(&word) || !is_built,
                    "{path}: `{word}`"
                );
            }
        }
        for link in text.split("](").skip(1) {
            let target = link.split([')', '#']).next().unwrap();
            let from = root().join(&path);
            let exists = from.parent().unwrap().join(target).exists();
            let is_elsewhere = target.contains("://") || target.is_empty();
            assert!(is_elsewhere || exists, "{path}: {target}");
        }
    }
}

#[test]
fn the_readme_is_short_and_links_every_page() {
    let texts = texts();
    let (_, readme) = texts.iter().find(|(path, _)| path == "README.md").unwrap();
    let words = readme.split_whitespace().count();
    assert!(words <= MOST_WORDS, "{words} words in README.md");
    for (path, _) in &texts {
        let named = readme.contains(&format!("]({path})"));
        assert!(
            path == "README.md" || named,
            "README.md does not link {path}"
        );
    }
}

/// A hook takes its programs from a tag that exists, or the reader is told to name one.
#[test]
fn the_documented_hook_uses_an_existing_tag() {
    let texts = texts();
    let fences: Vec<&str> = texts.iter().flat_map(|(_, t)| fences(t, "yaml")).collect();
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
            "{named} is not a tag"
        );
    }
}

/// `packaging/released` says whether packages are published. Until they are, every page that installs
/// one says so, and the README starts with what works from a clone.
#[test]
fn pages_state_whether_packages_are_released() {
    const NOTE: &str = "after the first release";
    let read = |path: &str| fs::read_to_string(root().join(path)).unwrap();
    let is_released = match read("packaging/released").trim() {
        "yes" => true,
        "no" => false,
        other => panic!("packaging/released is `yes` or `no`, not `{other}`"),
    };
    let mut texts = texts();
    texts.push(("editors/README.md".into(), read("editors/README.md")));
    let mut pages = 0;
    for (path, text) in texts {
        let sections = text.split("\n## ").filter(|section| {
            let installs = ["pip install", "pipx install", "npm i -D", "npm i -g"];
            let package = |i: &&str| section.contains(&format!("{i} shaderlint"));
            installs.iter().any(package) || section.contains("/shaderlint-pre-commit")
        });
        for section in sections {
            let title = section.lines().next().unwrap();
            let help = if is_released { "remove" } else { "write" };
            let says = section.contains(NOTE);
            assert!(says != is_released, "{path}, {title}: {help} \"{NOTE}\"");
            pages += 1;
        }
        let clone = text.find("cargo run --release");
        let first = clone < text.find("pip install") || is_released;
        assert!(path != "README.md" || first, "a clone comes first");
    }
    assert!(pages > 5, "only {pages} sections install packages");
}
