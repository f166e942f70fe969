//! `explain`, `rules`, `completions`, `man`, `--watch`.

use crate::scratch::{BROKEN, Scratch, mended};
use std::io::{BufRead, BufReader};
use std::process::Stdio;
use std::sync::mpsc;
use std::time::Duration;

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
    let ran = scratch.run(&["explain", "flaot-equality"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    assert!(
        ran.err.ends_with("did you mean `float-equality`?\n"),
        "{}",
        ran.err
    );
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
    }
    let man = scratch.run(&["man"]).out;
    assert!(man.contains(".TH shaderlint 1") && man.contains("\\-\\-write\\-baseline"));
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
    let (sender, lines) = mpsc::channel();
    let (out, err) = (child.stdout.take().unwrap(), child.stderr.take().unwrap());
    let other = sender.clone();
    std::thread::spawn(move || {
        BufReader::new(out)
            .lines()
            .for_each(|l| drop(sender.send(l.unwrap())));
    });
    std::thread::spawn(move || {
        BufReader::new(err)
            .lines()
            .for_each(|l| drop(other.send(l.unwrap())));
    });
    let until = |wanted: &str| {
        let mut seen = Vec::new();
        loop {
            let line = lines.recv_timeout(Duration::from_secs(30));
            let line = line.unwrap_or_else(|_| panic!("no `{wanted}` in {seen:?}"));
            let is_wanted = line.contains(wanted);
            seen.push(line);
            if is_wanted {
                return seen;
            }
        }
    };
    until("checking");
    until("a.glsl:5:24: error[int-float-mix]");
    until("waiting for changes");
    scratch.write("a.glsl", mended().replace("halfOf(a)", "halfOf(b)"));
    until("checking");
    until("undeclared");
    until("waiting for changes");
    scratch.write("a.glsl", mended());
    let seen = until("waiting for changes");
    assert!(seen.iter().all(|l| !l.contains("error")), "{seen:?}");
    child.kill().unwrap();
    child.wait().unwrap();
    let ran = scratch.run(&["--watch", "-"]);
    assert_eq!(ran.code, 2);
}
