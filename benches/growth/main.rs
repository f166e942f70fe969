//! Repetitions: whatever is repeated, eight times as much of it takes at most about eight times as long.
//! It says which take longer, and then ends with exit code 1.
//!
//! `SHADERLINT_REPEATED` sets another size than that of the larger text here, in bytes: the larger, the
//! milder a square is seen. `tests/hostile/repetitions.rs` counts what is asked for of the same texts.

#[path = "../../tests/hostile/patterns.rs"]
mod patterns;

use patterns::{Input, examples, grown, listed, report};
use shaderlint::engine::Options;
use shaderlint::lint::trial::TrialLimit;
use std::fs;
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Bytes of the larger text; the smaller is an eighth of it.
const SIZE: usize = 12_000;
/// Most that the work on the larger text may be, in times the work on the smaller done eight times:
/// once is in line, eight times with the square.
const MAX_GROWTH: u32 = 2;
/// Work that is too little to be measured, whatever it is a multiple of.
const NEGLIGIBLE: Duration = Duration::from_millis(30);
/// How often the work is measured before it counts as too much.
const TRIES: usize = 5;

/// What this thread has worked so far: the time that it had a processor, where the system tells,
/// so that it counts nothing what else the machine does.
fn worked() -> Option<Duration> {
    let text = fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    let nanoseconds = text.split(' ').next()?.parse().ok()?;
    Some(Duration::from_nanos(nanoseconds))
}

/// The time of checking a text and printing what is found.
fn work(text: &Input, options: &Options) -> Duration {
    let (before, start) = (worked(), Instant::now());
    report(text, options);
    match (before, worked()) {
        (Some(before), Some(now)) => now.saturating_sub(before),
        _ => start.elapsed(),
    }
}

/// By how much the work on a repetition grows, where that is not in line with its length.
fn growth(texts: &[Input; 2], options: &Options) -> Option<String> {
    let [mut small, mut large] = [Duration::MAX; 2];
    for _ in 0..TRIES {
        large = large.min(work(&texts[1], options));
        if large <= NEGLIGIBLE {
            return None;
        }
        // The system tells in steps of some milliseconds.
        small = small.min((0..8).map(|_| work(&texts[0], options)).sum());
        if large <= small * MAX_GROWTH + NEGLIGIBLE {
            return None;
        }
    }
    Some(format!("{small:?} became {large:?}"))
}

fn main() -> ExitCode {
    let size = std::env::var("SHADERLINT_REPEATED");
    let size = size.map_or(SIZE, |size| size.parse().unwrap());
    let patterns = [listed(), examples()].concat();
    let problems = grown(&patterns, size, TrialLimit::default(), growth);
    println!(
        "{} repetitions, {} problems",
        patterns.len(),
        problems.len()
    );
    println!("{}", problems.join("\n"));
    ExitCode::from(u8::from(!problems.is_empty()))
}
