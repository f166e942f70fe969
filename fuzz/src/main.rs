//! `shaderlint-fuzz TARGET|all [--seconds N] [--seed S] [FILE]...`
//! `shaderlint-fuzz write|pairs|drawn|builtins [--count N] [--seed S]`
//!
//! Breaks the shaders of the corpus and of the rules' pages in random ways and throws them at a
//! target. A panic or an answer that takes too long is a failure: its text is made as short as it
//! can be, stored in `fuzz/failures/`, and the exit code is 1. With files, those are thrown as they
//! are. `write` prints the programs of N seeds, each with shaderlint's verdict, as JSON lines for
//! `tests/browser/verdicts.js`, which asks Chromium.
//!
//! `shaderlint-fuzz pairs [--count N] [--seed S]` prints pairs of stages for a browser to link.
//! `shaderlint-fuzz drawn [--count N] [--seed S]` prints programs with what the machine draws of them,
//! for `tests/browser/drawn.js`, which draws them in Chromium; `builtins` prints those that compute
//! the built-in functions of random numbers. `shaderlint-fuzz played FILE.json...` prints what the
//! machine draws of exports, for `tests/browser/exports.js`, and `unsettled` which of their pixels other
//! GPUs may draw otherwise.

mod builtins;
mod compute;
mod edit;
mod generate;
mod metamorphic;
mod mutate;
mod pairs;
mod played;
mod run;
mod targets;

use compute::compute;
use generate::generate;
use mutate::{Random, mutate, split};
use shaderlint::semantic::Stage;
use std::panic::{catch_unwind, set_hook};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};
use std::{env, fs, thread};
use targets::{TARGETS, Target, Texts};

/// An answer that takes longer is a failure.
const TOO_LONG: Duration = Duration::from_secs(2);
/// An answer that takes longer ends the process.
const HANGS: Duration = Duration::from_secs(20);
/// Longest time spent on making a failing text shorter.
const MINIMISING: Duration = Duration::from_secs(30);

/// The text that is being thrown, and since when; the watchdog looks at it.
type Current = Arc<Mutex<(Instant, String)>>;

fn main() -> ExitCode {
    let mut seconds = 10;
    let mut seed = 1;
    let mut count = 1000;
    let mut words = Vec::new();
    let mut args = env::args().skip(1);
    while let Some(arg) = args.next() {
        let mut number = || args.next().and_then(|n| n.parse().ok());
        match arg.as_str() {
            "--seconds" => seconds = number().unwrap_or(seconds),
            "--seed" => seed = number().unwrap_or(seed),
            "--count" => count = number().unwrap_or(count),
            _ => words.push(arg),
        }
    }
    let name = words.first().map_or("all", String::as_str);
    if name == "write" {
        return write(seed, count);
    }
    if name == "builtins" {
        run::print_builtins();
        return ExitCode::SUCCESS;
    }
    if name == "drawn" {
        run::print(seed, count);
        return ExitCode::SUCCESS;
    }
    if name == "pairs" {
        pairs::print(seed, count as usize);
        return ExitCode::SUCCESS;
    }
    if name == "played" || name == "unsettled" {
        let print = match name {
            "played" => played::print,
            _ => played::print_unsettled,
        };
        words.iter().skip(1).for_each(|file| print(file));
        return ExitCode::SUCCESS;
    }
    let chosen: Vec<&Target> = TARGETS
        .iter()
        .filter(|t| name == "all" || t.name == name)
        .collect();
    if chosen.is_empty() {
        eprintln!(
            "there is no target `{name}`: lex, parse, check, link, fix, port, draw, programs, run, \
             metamorphic or all"
        );
        return ExitCode::from(2);
    }
    let files = words.get(1..).unwrap_or(&[]);
    let current: Current = Arc::new(Mutex::new((Instant::now(), String::new())));
    watch(current.clone());
    set_hook(Box::new(|_| {}));
    let mut failed = false;
    for target in chosen {
        failed |= if files.is_empty() {
            fuzz(target, Duration::from_secs(seconds), seed, &current)
        } else {
            files.iter().any(|file| throw_file(target, file, &current))
        };
    }
    ExitCode::from(failed as u8)
}

/// Prints the programs of `count` seeds with what shaderlint says of them.
fn write(seed: u64, count: u64) -> ExitCode {
    for seed in seed..seed + count {
        let program = generate(seed);
        let is_fragment = program.stage == Stage::Fragment;
        let verdict = serde_json::json!({
            "id": seed,
            "stage": if is_fragment { "fragment" } else { "vertex" },
            "ok": targets::is_accepted(&program.text, program.stage),
            "right": program.is_right,
            "source": program.text,
        });
        println!("{verdict}");
    }
    ExitCode::SUCCESS
}

/// Ends the process when one text takes far too long.
fn watch(current: Current) {
    thread::spawn(move || {
        loop {
            thread::sleep(Duration::from_secs(1));
            let Ok(now) = current.lock() else { return };
            if now.0.elapsed() > HANGS && !now.1.is_empty() {
                println!(
                    "a text of {} bytes hangs: {}",
                    now.1.len(),
                    store("hang", &now.1)
                );
                std::process::exit(1);
            }
        }
    });
}

fn throw_file(target: &Target, file: &str, current: &Current) -> bool {
    let text = String::from_utf8_lossy(&fs::read(file).unwrap_or_default()).into_owned();
    let failure = throw(target, &text, current);
    println!(
        "{} {file}: {}",
        target.name,
        failure.as_deref().unwrap_or("well")
    );
    failure.is_some()
}

/// Throws broken texts at a target until the time is over or one fails.
fn fuzz(target: &Target, time: Duration, seed: u64, current: &Current) -> bool {
    let seeds = seeds();
    let mut random = Random::new(seed);
    let start = Instant::now();
    let mut count: u64 = 0;
    while start.elapsed() < time {
        let text = match target.texts {
            Texts::Broken => mutate(&mut random, &seeds),
            Texts::Programs => generate(seed + count).text,
            Texts::Computing => compute(seed + count).text,
        };
        if let Some(failure) = throw(target, &text, current) {
            let small = minimise(target, &text, current);
            let path = store(target.name, &small);
            println!(
                "{} failed on text {count} of seed {seed}: {failure}\n  {} bytes in {path}",
                target.name,
                small.len()
            );
            return true;
        }
        count += 1;
    }
    println!(
        "{}: {count} texts from {} seeds, all well",
        target.name,
        seeds.len()
    );
    false
}

/// What went wrong with a text, if something did.
fn throw(target: &Target, text: &str, current: &Current) -> Option<String> {
    let start = Instant::now();
    if let Ok(mut now) = current.lock() {
        *now = (start, text.to_string());
    }
    let outcome = catch_unwind(|| (target.run)(text));
    let time = start.elapsed();
    if let Ok(mut now) = current.lock() {
        now.1.clear();
    }
    match outcome {
        Ok(()) => (time > TOO_LONG).then(|| format!("it took {time:?}")),
        Err(panic) => {
            let message = panic.downcast_ref::<String>().cloned();
            let plain = || panic.downcast_ref::<&str>().map(|s| s.to_string());
            Some(message.or_else(plain).unwrap_or_default())
        }
    }
}

/// Takes tokens away, halves first, as long as the text still fails.
fn minimise(target: &Target, text: &str, current: &Current) -> String {
    let start = Instant::now();
    let mut tokens = split(text);
    let mut size = tokens.len() / 2;
    while size > 0 && start.elapsed() < MINIMISING {
        let mut at = 0;
        while at < tokens.len() && start.elapsed() < MINIMISING {
            let mut fewer = tokens.clone();
            fewer.drain(at..(at + size).min(tokens.len()));
            match throw(target, &fewer.concat(), current) {
                Some(_) => tokens = fewer,
                None => at += size,
            }
        }
        size /= 2;
    }
    tokens.concat()
}

/// Keeps a failing text and gives its path.
fn store(name: &str, text: &str) -> String {
    let hash = text.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |h, b| {
        (h ^ b as u64).wrapping_mul(0x100_0000_01b3)
    });
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("failures");
    let path = folder.join(format!("{name}-{hash:016x}.glsl"));
    let stored = fs::create_dir_all(&folder).and_then(|()| fs::write(&path, text));
    stored.map_or_else(
        |e| format!("(not stored: {e})"),
        |()| path.display().to_string(),
    )
}

/// The shaders of the corpus, and those in the fences of the rules' pages.
fn seeds() -> Vec<String> {
    let top = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut paths = Vec::new();
    walk(&top.join("corpus"), &mut paths);
    walk(&top.join("rules"), &mut paths);
    paths.sort();
    let mut seeds = Vec::new();
    for path in paths {
        let text = fs::read_to_string(&path).unwrap_or_default();
        match path.extension().and_then(|e| e.to_str()) {
            Some("glsl" | "frag" | "vert" | "json") => seeds.extend(cases(&text)),
            Some("md") => seeds.extend(fences(&text)),
            _ => {}
        }
    }
    seeds
}

/// The cases of a file in `corpus/verdicts`. Any other file is one.
fn cases(text: &str) -> Vec<String> {
    let Some((head, rest)) = text.split_once("\n//: ") else {
        return vec![text.to_string()];
    };
    let all = std::iter::once(head).chain(rest.split("\n//: "));
    let code = all.filter_map(|case| case.split_once('\n'));
    code.map(|(_, code)| code.to_string()).collect()
}

fn fences(page: &str) -> Vec<String> {
    let parts = page.split("\n```").skip(1).step_by(2);
    let code = parts
        .filter_map(|p| p.strip_prefix("glsl"))
        .filter_map(|p| p.split_once('\n'));
    code.map(|(_, code)| code.to_string()).collect()
}

fn walk(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            walk(&path, found);
        } else {
            found.push(path);
        }
    }
}
