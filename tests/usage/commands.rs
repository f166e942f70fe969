//! Global options, `explain`, `rules`, `reduce`, `completions`, `man`, `--watch`.

use crate::scratch::{BROKEN, Scratch, after_fix};
use shaderlint::cli::{ProgramName, described};
use shaderlint::lint::ALIASES;
use shaderlint::rules::RULES;
use std::io::{BufRead, BufReader, Read};
use std::process::Stdio;
use std::sync::mpsc::{self, Receiver};

#[test]
fn aliases_of_rules_are_accepted_everywhere() {
    let code = "void mainImage(out vec4 c, in vec2 p) {\n    bool b = p.x > 9.0;\n    c = vec4(b == true ? 1.0 : 0.5);\n}\n";
    let allowed = format!("// shaderlint: allow-file(redundant-bool)\n{code}");
    let scratch = Scratch::new(&[
        ("a.glsl", code),
        ("allowed.glsl", &allowed),
        ("off.toml", "[rules]\nredundant-bool = \"off\"\n"),
    ]);
    let only = |arguments: &[&str]| {
        scratch
            .run(&[&["-q", "--format", "short"], arguments].concat())
            .out
    };
    let found = only(&["--only", "redundant-bool", "a.glsl"]);
    assert!(found.contains("[needless-bool]"), "{found}");
    let selected = only(&["--select", "redundant-bool", "a.glsl"]);
    assert!(selected.contains("[needless-bool]"), "{selected}");
    assert_eq!(
        only(&["--select", "tidy", "--ignore", "redundant-bool", "a.glsl"]),
        ""
    );
    assert_eq!(only(&["--config", "off.toml", "--info", "a.glsl"]), "");
    assert_eq!(only(&["allowed.glsl"]), "");
    let pages = ["redundant-bool", "needless-bool"].map(|n| scratch.run(&["explain", n]).out);
    assert_eq!(pages[0], pages[1]);
    assert!(pages[0].contains("**Alias:** `redundant-bool`"));
    for (alias, name) in ALIASES {
        assert!(RULES.iter().any(|r| r.name == *name), "{name}");
        assert!(RULES.iter().all(|r| r.name != *alias), "{alias}");
    }
}

#[test]
fn every_rule_is_listed_and_explained() {
    let scratch = Scratch::new(&[]);
    let list = scratch.run(&["rules"]).out;
    assert_eq!(list.lines().count(), shaderlint::rules::RULES.len());
    for line in list.lines() {
        let name = line.split_whitespace().next().unwrap();
        let ran = scratch.run(&["explain", name]);
        assert!(ran.out.starts_with(&format!("# {name}\n")), "{name}");
    }
    assert!(
        scratch
            .run(&["explain", "vector-size"])
            .out
            .starts_with("# vector-size\n")
    );
    let page = scratch.run(&["--explain", "vector-size"]);
    assert!(page.out.starts_with("# vector-size\n"));
    // A part of a name is enough if no other name contains it; words find pages by their text.
    let part = scratch.run(&["explain", "negative-base"]);
    assert!(
        part.out.starts_with("# pow-negative-base\n"),
        "{}",
        part.out
    );
    let list = scratch.run(&["explain", "division"]).out;
    assert!(list.contains("\nzero-division  "), "{list}");
    let list = scratch.run(&["explain", "march", "steps"]).out;
    assert!(list.lines().count() > 1, "{list}");
    let ran = scratch.run(&["explain", "flaot-equality"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    assert!(
        ran.err.ends_with("did you mean `float-equality`?\n"),
        "{}",
        ran.err
    );
}

#[test]
fn check_help_and_init_are_commands() {
    let scratch = Scratch::new(&[("a.glsl", crate::scratch::WARNED)]);
    let plain = scratch.run(&["--info", "--no-run", "a.glsl"]);
    assert_eq!(
        scratch.run(&["check", "--info", "--no-run", "a.glsl"]).out,
        plain.out
    );
    assert!(
        scratch
            .run(&["help", "fmt"])
            .out
            .starts_with("Format shaders")
    );
    assert_eq!(scratch.run(&["init"]).code, 0);
    let before = scratch.read("shaderlint.toml");
    assert_eq!(scratch.run(&["a.glsl"]).code, 0);
    // An existing configuration is kept.
    let again = scratch.run(&["init"]);
    assert_eq!(again.code, 2);
    assert!(again.err.contains("exists already"), "{}", again.err);
    assert_eq!(scratch.read("shaderlint.toml"), before);
}

/// Every global option, with a value if it takes one.
fn global_options(program: &clap::Command) -> Vec<Vec<String>> {
    let globals = program.get_arguments().filter(|arg| arg.is_global_set());
    let globals = globals.map(|arg| {
        let long = format!("--{}", arg.get_long().unwrap());
        let values = arg.get_possible_values();
        let value = values.first().map_or("none.toml", |value| value.get_name());
        let takes = arg.get_action().takes_values();
        let value = takes.then(|| value.to_string());
        [Some(long), value].into_iter().flatten().collect()
    });
    globals.collect()
}

#[test]
fn global_options_are_accepted_before_and_after_every_command() {
    let mut program = described(ProgramName::Shaderlint);
    program.build();
    let globals = global_options(&program);
    assert!(globals.len() >= 5, "{globals:?}");
    let scratch = Scratch::new(&[]);
    let names = program.get_subcommands().map(|c| c.get_name());
    for name in names.filter(|name| *name != "help") {
        let help = scratch.run(&[name, "--help"]);
        assert_eq!((help.code, help.err.as_str()), (0, ""), "{name}");
        assert!(help.out.contains("Usage: "), "{name}: {}", help.out);
        for global in &globals {
            let global: Vec<&str> = global.iter().map(String::as_str).collect();
            let before = scratch.run(&[&global, &[name, "--help"][..]].concat());
            let after = scratch.run(&[&[name][..], &global, &["--help"]].concat());
            for ran in [before, after] {
                assert_eq!((ran.code, &ran.out), (0, &help.out), "{global:?} {name}");
            }
        }
    }
    for global in &globals {
        let global: Vec<&str> = global.iter().map(String::as_str).collect();
        let before = scratch.run(&[&global, &["--explain", "vector-size"][..]].concat());
        let after = scratch.run(&[&["--explain", "vector-size"][..], &global].concat());
        for ran in [before, after] {
            assert!(
                ran.out.starts_with("# vector-size\n"),
                "{global:?}: {ran:?}"
            );
        }
    }
}

#[test]
fn global_options_before_a_command_have_an_effect() {
    let shader = "void mainImage(out vec4 c, in vec2 p) {\n  c = vec4(iTime);\n}\n";
    let scratch = Scratch::new(&[
        ("a.glsl", shader),
        ("wide.toml", "[format]\nindent = 8\n"),
        ("kodi.toml", "host = \"kodi\"\n"),
        (
            "k.glsl",
            include_str!("../fixtures/dialects/kodi/bars.glsl"),
        ),
    ]);
    let bars = ["run", "k.glsl", "--size", "4x4"];
    let by_name = scratch.run(&[&bars[..], &["--host", "kodi"]].concat());
    let by_config = scratch.run(&[&["--config", "kodi.toml"], &bars[..]].concat());
    assert_eq!((by_config.code, &by_config.out), (0, &by_name.out));
    assert_ne!(by_config.out, scratch.run(&bars).out);
    let wide = scratch.run(&["--config", "wide.toml", "fmt", "--diff", "a.glsl"]);
    assert!(wide.out.contains("\n+        c = "), "{}", wide.out);
    let quiet = scratch.run(&["-q", "fmt", "--check", "a.glsl"]);
    assert_eq!((quiet.code, quiet.err.as_str()), (1, ""));
    let run = ["run", "a.glsl", "--size", "4x4"];
    let colored = scratch.run(&[&["--color", "always"], &run[..]].concat());
    assert!(colored.out.contains('\u{1b}'), "{}", colored.out);
    let missing = scratch.run(&[&["--config", "missing.toml"], &run[..]].concat());
    assert!(missing.err.contains("missing.toml"), "{}", missing.err);
    let nothing = scratch.run(&["-qq", "run", "missing.glsl"]);
    assert_eq!((nothing.code, nothing.err.as_str()), (2, ""));
}

#[test]
fn completions_and_the_man_page_name_the_options() {
    let scratch = Scratch::new(&[]);
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let ran = scratch.run(&["completions", shell]);
        assert_eq!((ran.code, ran.err.as_str()), (0, ""), "{shell}");
        assert!(
            ran.out.contains("unsafe-fixes") && ran.out.contains("explain"),
            "{shell}"
        );
        let port = scratch.run(&["completions", shell, "shaderport"]).out;
        assert!(port.contains("shaderport") && port.contains("verify"));
    }
    let man = scratch.run(&["man"]).out;
    assert!(man.contains(".TH shaderlint 1") && man.contains("\\-\\-write\\-baseline"));
    let man = scratch.run(&["man", "shaderport"]).out;
    assert!(man.contains(".TH shaderport 1") && man.contains("\\-\\-verify"));
}

/// A shader with one error and a lot of unrelated code.
const LARGE: &str = "#version 300 es
precision highp float;
uniform float time;
out vec4 color;
float wave(float x) { return sin(x) * 0.5; }
void main() {
    float sum = 0.0;
    for (int i = 0; i < 5; i++) { sum += wave(float(i) + time); }
    vec3 c = vec3(sum);
    if (time > 1.0) { c = c * vec2(time); }
    color = vec4(c, 1.0);
}
";

#[test]
fn reduce_keeps_an_error() {
    let scratch = Scratch::new(&[("a.frag", LARGE)]);
    let ran = scratch.run(&["reduce", "a.frag"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert!(
        ran.out.len() < 100 && !ran.out.contains("wave"),
        "{}",
        ran.out
    );
    scratch.write("b.frag", &ran.out);
    let left = scratch.run(&["--format", "short", "b.frag"]);
    assert!(left.out.contains("[vector-size]"), "{}", left.out);
    assert_eq!(scratch.read("a.frag"), LARGE);
}

#[test]
fn reduce_keeps_a_rule_or_a_command_result() {
    let clean = LARGE.replace("vec2(time)", "time");
    let scratch = Scratch::new(&[("a.frag", LARGE), ("c.frag", &clean)]);
    let ran = scratch.run(&[
        "reduce",
        "a.frag",
        "--rule",
        "vector-size",
        "-o",
        "small.frag",
    ]);
    assert_eq!((ran.code, ran.out.as_str()), (0, ""), "{}", ran.err);
    assert!(scratch.read("small.frag").len() < 100);
    // Existing files are not overwritten.
    let ran = scratch.run(&["reduce", "a.frag", "-o", "a.frag"]);
    assert_eq!((ran.code, scratch.read("a.frag").as_str()), (2, LARGE));
    for (args, complaint) in [
        (&["reduce", "c.frag"][..], "no errors to keep"),
        (
            &["reduce", "c.frag", "--rule", "nonsense"],
            "unknown rule or compile error",
        ),
        (
            &["reduce", "c.frag", "--rule", "vector-size"],
            "not all of the given rules",
        ),
        (&["reduce", "c.frag", "--keep", "true"], "no `{}`"),
        (
            &["reduce", "c.frag", "--keep", "test -d {}"],
            "does not exit with code 0",
        ),
        (&["reduce", "missing.frag"], "missing.frag"),
    ] {
        let ran = scratch.run(args);
        assert_eq!((ran.code, ran.out.as_str()), (2, ""), "{args:?}");
        assert!(ran.err.contains(complaint), "{args:?}: {}", ran.err);
    }
}

#[cfg(unix)]
#[test]
fn reduce_keeps_a_successful_command() {
    let scratch = Scratch::new(&[("it's.frag", LARGE)]);
    let ran = scratch.run(&["reduce", "it's.frag", "--keep", "grep -q wave {}"]);
    assert_eq!((ran.code, ran.out.trim()), (0, "wave"), "{}", ran.err);
}

/// The lines that a process writes, as they arrive.
fn lines_of(stream: impl Read + Send + 'static) -> Receiver<String> {
    let (sender, lines) = mpsc::channel();
    std::thread::spawn(move || {
        let lines = BufReader::new(stream).lines();
        lines.for_each(|l| drop(sender.send(l.unwrap())));
    });
    lines
}

/// Waits for a line that contains `expected`, at most until the process ends.
fn until(lines: &Receiver<String>, expected: &str) {
    let mut seen = Vec::new();
    for line in lines {
        if line.contains(expected) {
            return;
        }
        seen.push(line);
    }
    panic!("no `{expected}` in {seen:?}");
}

#[test]
fn watching_checks_again_when_a_file_changes() {
    let scratch = Scratch::new(&[("a.glsl", BROKEN)]);
    let args = ["--watch", "--format", "short", "a.glsl"];
    let mut child = scratch
        .command(&args)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let found = lines_of(child.stdout.take().unwrap());
    let reported = lines_of(child.stderr.take().unwrap());
    until(&reported, "checking");
    until(&found, "a.glsl:5:24: error[int-float-mix]");
    until(&reported, "waiting for changes");
    scratch.write("a.glsl", after_fix().replace("halfOf(a)", "halfOf(b)"));
    until(&reported, "checking");
    until(&found, "undeclared");
    until(&reported, "waiting for changes");
    scratch.write("a.glsl", after_fix());
    until(&reported, "waiting for changes");
    child.kill().unwrap();
    child.wait().unwrap();
    let rest: Vec<String> = found.iter().collect();
    assert!(rest.iter().all(|l| !l.contains("error")), "{rest:?}");
    for never_a_file in ["-", "b.glsl"] {
        let ran = scratch.run(&["--watch", never_a_file]);
        assert_eq!(ran.code, 2);
    }
}
