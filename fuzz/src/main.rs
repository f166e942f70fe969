//! `shaderlint-fuzz TARGET|all [--rounds N | --seconds N] [--seed S] [FILE]...`
//! `shaderlint-fuzz write|pairs|drawn|builtins [--count N] [--seed S]`
//!
//! Mutates the shaders of the corpus and of the rules' pages at random and passes them to a target.
//! A panic or excessive memory use is a failure: the text is minimised and stored in
//! `fuzz/failures/`, and the exit code is 1. A round is the number of texts that the tests of this
//! program use, about as many as a target processes in two seconds. Given files, it passes those
//! unchanged. `write` prints the programs of N seeds, each with shaderlint's verdict, as JSON lines
//! for `tests/browser/verdicts.js`, which compares them with Chromium.
//!
//! `shaderlint-fuzz pairs [--count N] [--seed S]` prints pairs of stages for a browser to link.
//! `shaderlint-fuzz drawn [--count N] [--seed S]` prints programs with the image drawn by the VM,
//! for `tests/browser/drawn.js`, which draws them in Chromium; `builtins` prints the programs that
//! evaluate built-in functions for random arguments. `shaderlint-fuzz played FILE.json...` prints
//! what the VM draws for exports, for `tests/browser/exports.js`, and `unsettled` the pixels that
//! other GPUs may draw differently; `values FILE.jsonl...` which shaders do not draw white.

mod builtins;
mod compute;
#[path = "../../tests/hostile/counting.rs"]
mod counting;
mod edit;
mod generate;
mod metamorphic;
mod mutate;
mod pairs;
mod playback;
mod run;
mod targets;
mod texts;
mod throw;
mod values;

use generate::generate;
use shaderlint::semantic::Stage;
use std::env;
use std::process::ExitCode;
use std::time::Duration;
use targets::{TARGETS, Target};
use throw::{Length, fuzz, throw_file};

fn main() -> ExitCode {
    let mut length = Length::Rounds(1);
    let mut seed = 1;
    let mut count = 1000;
    let mut words = Vec::new();
    let mut args = env::args().skip(1);
    while let Some(arg) = args.next() {
        let mut number = || args.next().and_then(|n| n.parse().ok());
        match arg.as_str() {
            "--seconds" => {
                length = number().map_or(length, |n| Length::Time(Duration::from_secs(n)))
            }
            "--rounds" => length = number().map_or(length, Length::Rounds),
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
    if name == "values" {
        words.iter().skip(1).for_each(|file| values::print(file));
        return ExitCode::SUCCESS;
    }
    if name == "pairs" {
        pairs::print(seed, count as usize);
        return ExitCode::SUCCESS;
    }
    if name == "played" || name == "unsettled" {
        let print = match name {
            "played" => playback::print,
            _ => playback::print_unsettled,
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
            "unknown target `{name}`; expected lex, parse, check, link, fix, port, draw, programs, run, \
             metamorphic or all"
        );
        return ExitCode::from(2);
    }
    let files = words.get(1..).unwrap_or(&[]);
    let mut is_well = true;
    for target in chosen {
        is_well &= match files {
            [] => fuzz(target, length, seed),
            _ => files.iter().all(|file| throw_file(target, file)),
        };
    }
    ExitCode::from(u8::from(!is_well))
}

/// Prints the programs of `count` seeds with shaderlint's verdicts.
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
