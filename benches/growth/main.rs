//! Growth: eight times as much of a repeated text must take at most about eight times as long.
//! Prints the patterns that take longer and then exits with code 1.
//!
//! `SHADERLINT_REPEATED` sets the size of the larger text in bytes; larger texts detect weaker
//! quadratic growth. `tests/hostile/repetitions.rs` counts allocations for the same texts.

#[path = "../../tests/hostile/patterns.rs"]
mod patterns;

use patterns::{Input, examples, grown, listed, report};
use shaderlint::engine::Options;
use shaderlint::lint::sample::SampleLimit;
use std::fs;
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Size of the larger text in bytes; the smaller one has an eighth of it.
const SIZE: usize = 24_000;
/// Maximum ratio of the time for the larger text to eight times the time for the smaller one: 1 is
/// linear, 8 is quadratic.
const MAX_GROWTH: u32 = 2;
/// Times below this are not compared.
const NEGLIGIBLE: Duration = Duration::from_millis(30);
/// Number of measurements before growth is reported.
const TRIES: usize = 5;

/// CPU time of this thread so far, if the system reports it, so that other processes do not count.
fn worked() -> Option<Duration> {
    let text = fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    let nanoseconds = text.split(' ').next()?.parse().ok()?;
    Some(Duration::from_nanos(nanoseconds))
}

/// Time to check a text and print the findings.
fn work(text: &Input, options: &Options) -> Duration {
    let (before, start) = (worked(), Instant::now());
    report(text, options);
    match (before, worked()) {
        (Some(before), Some(now)) => now.saturating_sub(before),
        _ => start.elapsed(),
    }
}

/// The growth of a repetition, if it is more than linear.
fn growth(texts: &[Input; 2], options: &Options) -> Option<String> {
    let [mut small, mut large] = [Duration::MAX; 2];
    for _ in 0..TRIES {
        large = large.min(work(&texts[1], options));
        if large <= NEGLIGIBLE {
            return None;
        }
        // The system's clock has a resolution of some milliseconds.
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
    let problems = grown(&patterns, size, SampleLimit::default(), growth);
    println!(
        "{} repetitions, {} problems",
        patterns.len(),
        problems.len()
    );
    println!("{}", problems.join("\n"));
    ExitCode::from(u8::from(!problems.is_empty()))
}
