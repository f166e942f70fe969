//! `.shaderlint_cache`: findings of unchanged files are kept, and of nothing else.

use crate::scratch::{Scratch, WARNED};
use std::fs;
use std::path::PathBuf;
use std::process::Stdio;

/// Replaces a word of the message in every entry, and returns the number of entries: where the new word
/// is printed, the finding is from the cache.
fn mark(scratch: &Scratch) -> usize {
    let entries = entries(scratch);
    for entry in &entries {
        let bytes = fs::read(entry).unwrap();
        let (key, json) = bytes.split_at(16);
        let json = String::from_utf8(json.to_vec()).unwrap();
        let json = json.replace("may be negative", "is from the cache");
        fs::write(entry, [key, json.as_bytes()].concat()).unwrap();
    }
    entries.len()
}

fn entries(scratch: &Scratch) -> Vec<PathBuf> {
    let folder = fs::read_dir(scratch.path(".shaderlint_cache"));
    let all = folder.into_iter().flatten().map(|e| e.unwrap());
    let entries = all.filter(|e| e.file_name().len() == 32);
    entries.map(|e| e.path()).collect()
}

fn is_cached(scratch: &Scratch, args: &[&str]) -> bool {
    let out = scratch.run(args).out;
    assert!(out.contains("pow-negative-base"), "{out}");
    out.contains("is from the cache")
}

#[test]
fn unchanged_files_are_not_checked_again() {
    let scratch = Scratch::new(&[("a.glsl", WARNED)]);
    let first = scratch.run(&["a.glsl"]);
    assert_eq!(scratch.read(".shaderlint_cache/.gitignore"), "*\n");
    let second = scratch.run(&["a.glsl"]);
    assert_eq!((first.code, &first.out), (second.code, &second.out));
    assert_eq!(mark(&scratch), 1);
    assert!(is_cached(&scratch, &["a.glsl"]));
    assert!(!is_cached(&scratch, &["--no-cache", "a.glsl"]));
    // Every format prints the same, with and without the cache.
    for format in [
        "human", "short", "agent", "json", "jsonl", "sarif", "gitlab", "junit",
    ] {
        scratch.run(&["--format", format, "--info", "a.glsl"]);
        let [kept, new] = [&[][..], &["--no-cache"]].map(|more| {
            let args = [more, &["--format", format, "--info", "a.glsl"]].concat();
            scratch.run(&args).out
        });
        assert_eq!(kept, new, "{format}");
    }
}

#[test]
fn changed_dependencies_invalidate_the_cache() {
    let vertex = "#version 300 es\nin vec4 at;\nout vec2 uv;\nvoid main() { gl_Position = at; }\n";
    let fragment = "#version 300 es\nprecision highp float;\nin vec3 uv;\nout vec4 color;\n\
        uniform float x;\nvoid main() { color = vec4(uv, sqrt(x)); }\n";
    let including = format!("#include \"lib.glsl\"\n{WARNED}");
    let scratch = Scratch::new(&[
        ("a.glsl", &including),
        ("lib.glsl", "float one() { return 1.0; }\n"),
        ("b.vert", vertex),
        ("b.frag", fragment),
    ]);
    let changes: [(&str, &dyn Fn()); 4] = [
        ("the text", &|| {
            scratch.write("a.glsl", format!("{including}\n"))
        }),
        ("an include", &|| {
            scratch.write("lib.glsl", "float one() { return 2.0; }\n")
        }),
        ("the configuration", &|| {
            scratch.write("shaderlint.toml", "info = true\n")
        }),
        ("a lost include", &|| {
            fs::remove_file(scratch.path("lib.glsl")).unwrap()
        }),
    ];
    for (what, change) in changes {
        scratch.run(&["a.glsl"]);
        mark(&scratch);
        assert!(is_cached(&scratch, &["a.glsl"]), "before {what}");
        change();
        assert!(!is_cached(&scratch, &["a.glsl"]), "after {what}");
    }
    // The folder of a pass may get another.
    scratch.write("toy/image.glsl", WARNED);
    scratch.run(&["toy/image.glsl"]);
    mark(&scratch);
    assert!(is_cached(&scratch, &["toy/image.glsl"]));
    scratch.write("toy/common.glsl", "float one() { return 1.0; }\n");
    assert!(!is_cached(&scratch, &["toy/image.glsl"]));
    // Two stages report their link error once, whichever was checked before.
    let links = |args: &[&str]| scratch.run(args).out.matches("error[").count();
    let runs = [&["b.vert", "b.frag"][..], &["b.vert"], &["b.frag"]];
    for _ in 0..2 {
        assert_eq!(runs.map(links), [1, 1, 1]);
    }
    scratch.write(
        "b.frag",
        fragment
            .replace("in vec3 uv", "in vec2 uv")
            .replace("uv,", "uv, 0.0,"),
    );
    assert_eq!(links(&["b.vert"]), 0);
}

#[test]
fn damaged_or_unwritable_caches_are_ignored() {
    let scratch = Scratch::new(&[("a.glsl", WARNED)]);
    let expected = scratch.run(&["--no-cache", "a.glsl"]).out;
    assert!(entries(&scratch).is_empty());
    for keep in [0, 7, 16, 40, 200] {
        scratch.run(&["a.glsl"]);
        for entry in entries(&scratch) {
            let bytes = fs::read(&entry).unwrap();
            fs::write(&entry, &bytes[..keep]).unwrap();
        }
        assert_eq!(scratch.run(&["a.glsl"]).out, expected, "{keep} bytes");
    }
    // A file in place of the folder cannot be written to, even by an administrator.
    fs::remove_dir_all(scratch.path(".shaderlint_cache")).unwrap();
    scratch.write(".shaderlint_cache", "");
    let ran = scratch.run(&["a.glsl"]);
    assert_eq!((ran.out, ran.err.as_str()), (expected, ""));
}

#[cfg(unix)]
#[test]
fn caches_of_other_builds_are_ignored() {
    let scratch = Scratch::new(&[("a.glsl", WARNED)]);
    scratch.run(&["a.glsl"]);
    mark(&scratch);
    let copy = scratch.path("shaderlint-copy");
    // Copied by another process: a file that a concurrent test inherited open cannot be executed.
    let mut cp = std::process::Command::new("cp");
    let cp = cp.arg(insta_cmd::get_cargo_bin("shaderlint")).arg(&copy);
    assert!(cp.status().unwrap().success());
    let mut command = std::process::Command::new(copy);
    let done = command
        .args(["--no-run", "a.glsl"])
        .current_dir(scratch.path(""))
        .output();
    let out = String::from_utf8(done.unwrap().stdout).unwrap();
    assert!(out.contains("may be negative"), "{out}");
    assert_eq!(entries(&scratch).len(), 1);
}

#[test]
fn concurrent_runs_share_the_cache() {
    let scratch = Scratch::new(&[]);
    for number in 0..20 {
        scratch.write(&format!("{number}.glsl"), format!("// {number}\n{WARNED}"));
    }
    let expected = scratch.run(&["--no-cache", "."]).out;
    for _ in 0..3 {
        let start = |_| {
            scratch
                .command(&["."])
                .stdout(Stdio::piped())
                .spawn()
                .unwrap()
        };
        let children: Vec<_> = (0..4).map(start).collect();
        for child in children {
            let out = child.wait_with_output().unwrap().stdout;
            assert_eq!(String::from_utf8(out).unwrap(), expected);
        }
    }
    // Nothing is left of what was written meanwhile.
    let all = fs::read_dir(scratch.path(".shaderlint_cache"))
        .unwrap()
        .count();
    assert_eq!((entries(&scratch).len(), all), (20, 22));
}
