//! Repetitions: whatever is repeated, eight times as much of it asks for at most about eight times the
//! memory, which is a measure of the work. `benches/growth` measures the time, which sees the work that
//! asks for none.

use super::Verdict::Refused;
use super::counting::{Asked, asked};
use super::judge;
use super::patterns::{Input, Pattern, examples, grown, listed, repeat, report};
use shaderlint::engine::Options;
use shaderlint::lint::trial::TrialLimit;

/// Bytes of the larger text; the smaller is an eighth of it. The larger, the milder a square is seen.
const SIZE: usize = 8_000;
/// Most that may be asked for of the larger text, in times what is asked for of the smaller done eight
/// times: once is in line, eight times with the square.
const MAX_GROWTH: u64 = 3;
/// What takes some milliseconds, whatever it is a multiple of.
const NEGLIGIBLE: Asked = Asked {
    times: 50_000,
    bytes: 64 << 20,
};

/// By how much the work on a repetition grows, where that is not in line with its length.
fn growth(texts: &[Input; 2], options: &Options) -> Option<String> {
    let [small, large] = [0, 1].map(|i| asked(|| report(&texts[i], options)).0);
    let is_in_line = large.times <= small.times * 8 * MAX_GROWTH + NEGLIGIBLE.times
        && large.bytes <= small.bytes * 8 * MAX_GROWTH + NEGLIGIBLE.bytes;
    (!is_in_line).then(|| format!("{small:?} became {large:?}"))
}

fn all_grow_in_line(patterns: &[Pattern]) {
    // Pixels beyond the first few ask for the same again.
    let limit = TrialLimit {
        pixels: 64,
        insists: false,
    };
    let problems = grown(patterns, SIZE, limit, growth);
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

#[test]
fn repetitions_are_read_in_line() {
    all_grow_in_line(&listed());
}

#[test]
fn examples_are_read_in_line() {
    all_grow_in_line(&examples());
}

#[test]
fn a_tower_of_calls_is_read_where_it_stands() {
    let pattern = "#define F(x) x↵float f(float a) { return «F(»a«)»; }";
    judge(&repeat("pass", pattern, 1_000_000).1, Refused);
}
