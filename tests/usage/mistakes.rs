//! Wrong arguments: one line that says what is right, and exit code 2.

use crate::scratch::{CLEAN, Scratch};

/// The only line of a message.
fn line(ran: (Option<i32>, String), program: &str) -> String {
    let (code, message) = ran;
    assert_eq!(code, Some(2), "{message}");
    assert_eq!(message.trim_end().lines().count(), 1, "{message}");
    message.trim_end().replacen(&format!("{program}: "), "", 1)
}

fn folder() -> Scratch {
    Scratch::new(&[
        ("water.glsl", CLEAN),
        ("a/sky.glsl", CLEAN),
        ("none/readme.txt", ""),
    ])
}

#[test]
fn wrong_arguments_of_shaderlint_get_the_right_ones() {
    let scratch = folder();
    for (args, right) in [
        // Words that are no commands.
        ("fix water.glsl", "--fix"),
        ("lint water.glsl", "shaderlint"),
        ("format water.glsl", "shaderlint fmt"),
        ("rnu water.glsl", "shaderlint run"),
        ("debug water.glsl", "shaderlint dap"),
        ("version", "--version"),
        // Options that do not exist, or not there.
        ("--fix-unsafe water.glsl", "--unsafe-fixes"),
        ("--fxi water.glsl", "--fix"),
        ("-f json water.glsl", "--format json"),
        ("--json water.glsl", "--format json"),
        ("rules --json", "--format json"),
        ("--rules", "shaderlint rules"),
        ("-o a.png water.glsl", "shaderlint run --output"),
        ("fmt --fix water.glsl", "shaderlint --fix"),
        ("run water.glsl a.png", "-o a.png"),
    ] {
        let ran = scratch.run(&args.split(' ').collect::<Vec<_>>());
        let message = line((Some(ran.code), ran.err), "shaderlint");
        assert!(message.starts_with("unexpected argument `"), "{message}");
        let question = format!("; did you mean `{right}`?");
        assert!(message.ends_with(&question), "{args}: {message}");
        assert_eq!(ran.out, "", "{args}");
    }
    for (args, words) in [
        (
            "explain",
            "`explain` requires a name; `shaderlint rules` lists",
        ),
        (
            "draw water.glsl",
            "`draw` is neither a command nor a file; commands: `check`, ",
        ),
        (
            "--fix run water.glsl",
            "`--fix` is no option of all commands",
        ),
        (
            "run none",
            "none: no pass found; name the files `image.glsl`",
        ),
    ] {
        let ran = scratch.run(&args.split(' ').collect::<Vec<_>>());
        let message = line((Some(ran.code), ran.err), "shaderlint");
        assert!(message.starts_with(words), "{args}: {message}");
    }
    let format = scratch.run(&["--format", "yaml"]);
    assert!(format.err.contains("[possible values: human, short"));
}

#[cfg(feature = "mcp")]
#[test]
fn converting_is_porting() {
    let ran = folder().run(&["convert", "water.glsl"]);
    assert!(
        ran.err.ends_with("did you mean `shaderlint port`?\n"),
        "{ran:?}"
    );
}

#[test]
fn wrong_arguments_of_shaderport_get_the_right_ones() {
    let scratch = folder();
    for (args, message) in [
        (
            "water.glsl a.html",
            "unexpected argument `a.html`; did you mean `-o a.html`?",
        ),
        (
            "--lint water.glsl",
            "unexpected argument `--lint`; did you mean `shaderlint`?",
        ),
        (
            "lint water.glsl",
            "unexpected argument `lint`; did you mean `shaderlint`?",
        ),
        (
            "galery .",
            "unexpected argument `galery`; did you mean `shaderport gallery`?",
        ),
        ("help", "unexpected argument `help`; did you mean `--help`?"),
        (
            "water.glsl --html",
            "unexpected argument `--html`; did you mean `--target html`?",
        ),
        (
            "water.glsl --format html",
            "unexpected argument `--format`; did you mean `--target html`?",
        ),
        ("water.glsl --serve 8080", "8080: no such file or folder"),
    ] {
        scratch.port_fails(args, message);
    }
    let ran = scratch.port("water.glsl --output");
    assert!(
        ran.1
            .starts_with("error: a value is required for '--output <PATH>'")
    );
}

#[test]
fn missing_files_get_the_name_beside_them() {
    let scratch = folder();
    let near = "wate.glsl: no such file or folder; did you mean `water.glsl`?";
    let other = "a/skye.glsl: no such file or folder; did you mean `a/sky.glsl`?";
    for command in ["", "run", "references"] {
        for (path, message) in [("wate.glsl", near), ("a/skye.glsl", other)] {
            let rest = if command == "references" { "c" } else { "" };
            let args = [command, path, rest]
                .into_iter()
                .filter(|word| !word.is_empty());
            let ran = scratch.run(&args.collect::<Vec<_>>());
            assert_eq!(line((Some(ran.code), ran.err), "shaderlint"), message);
        }
    }
    scratch.port_fails("wate.glsl", near);
    scratch.port_fails("a/skye.glsl -o a.html", other);
    scratch.port_fails("gallery wate.glsl -o out", near);
    scratch.port_fails("sand.glsl", "sand.glsl: no such file or folder");
}

#[test]
fn addresses_get_the_way_to_a_file() {
    let scratch = folder();
    let address = "https://www.shadertoy.com/view/abcdef";
    let message = format!("{address}: addresses are not read; save a JSON export of ShaderToy");
    for args in [&[address][..], &["run", address]] {
        let ran = scratch.run(args);
        let found = line((Some(ran.code), ran.err), "shaderlint");
        assert!(found.starts_with(&message), "{found}");
    }
    let found = line(scratch.port(address), "shaderport");
    assert!(found.starts_with(&message), "{found}");
}
