//! `shaderlint-fuzz TARGET|all [--rounds N | --seconds N] [--seed S] [FILE]...`
//! `shaderlint-fuzz write|pairs|drawn|builtins [--count N] [--seed S]`
//!
//! Breaks the shaders of the corpus and of the rules' pages in random ways and throws them at a
//! target. A panic or an answer that asks for too much memory is a failure: its text is made as short
//! as it can be, stored in `fuzz/failures/`, and the exit code is 1. A round is so many texts as the
//! tests of this program throw, about as many as a target answers in two seconds. With files, those
//! are thrown as they are. `write` prints the programs of N seeds, each with shaderlint's verdict, as
//! JSON lines for `tests/browser/verdicts.js`, which asks Chromium.
//!
//! `shaderlint-fuzz pairs [--count N] [--seed S]` prints pairs of stages for a browser to link.
//! `shaderlint-fuzz drawn [--count N] [--seed S]` prints programs with what the machine draws of them,
//! for `tests/browser/drawn.js`, which draws them in Chromium; `builtins` prints those that compute
//! the built-in functions of random numbers. `shaderlint-fuzz played FILE.json...` prints what the
//! machine draws of exports, for `tests/browser/exports.js`, and `unsettled` which of their pixels other
//! GPUs may draw otherwise.

mod builtins;
mod compute;
#[path = "../../tests/hostile/counting.rs"]
mod counting;
mod edit;
mod generate;
mod metamorphic;
mod mutate;
mod pairs;
mod played;
mod run;
mod targets;
mod texts;
mod throw;

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
    let mut is_well = true;
    for target in chosen {
        is_well &= match files {
            [] => fuzz(target, length, seed),
            _ => files.iter().all(|file| throw_file(target, file)),
        };
    }
    ExitCode::from(u8::from(!is_well))
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
