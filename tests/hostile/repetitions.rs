//! Growth: eight times as much of a repeated text must allocate at most about eight times the
//! memory, which is a measure of the work. `benches/growth` measures time and so detects work
//! without allocations.

use super::Verdict::Refused;
use super::counting::{Asked, asked};
use super::expect;
use super::patterns::{Input, Pattern, examples, grown, listed, repeat, report};
use shaderlint::engine::Options;
use shaderlint::lint::sample::SampleLimit;

/// Size of the larger text in bytes; the smaller one has an eighth of it. Larger texts detect
/// weaker quadratic growth.
const SIZE: usize = 8_000;
/// Maximum ratio of the allocations for the larger text to eight times those for the smaller one: 1
/// is linear, 8 is quadratic.
const MAX_GROWTH: u64 = 3;
/// Allocations below this, which correspond to some milliseconds, are not compared.
const NEGLIGIBLE: Asked = Asked {
    times: 50_000,
    bytes: 64 << 20,
};

/// The growth of a repetition, if it is more than linear.
fn growth(texts: &[Input; 2], options: &Options) -> Option<String> {
    let [small, large] = [0, 1].map(|i| asked(|| report(&texts[i], options)).0);
    let is_in_line = large.times <= small.times * 8 * MAX_GROWTH + NEGLIGIBLE.times
        && large.bytes <= small.bytes * 8 * MAX_GROWTH + NEGLIGIBLE.bytes;
    (!is_in_line).then(|| format!("{small:?} became {large:?}"))
}

fn all_grow_in_line(patterns: &[Pattern]) {
    // Additional pixels only repeat the same allocations.
    let limit = SampleLimit {
        pixels: 64,
        insists: false,
    };
    let problems = grown(patterns, SIZE, limit, growth);
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

#[test]
fn repetitions_take_linear_work() {
    all_grow_in_line(&listed());
}

#[test]
fn examples_take_linear_work() {
    all_grow_in_line(&examples());
}

#[test]
fn deeply_nested_macro_calls_are_limited() {
    let pattern = "#define F(x) x↵float f(float a) { return «F(»a«)»; }";
    expect(&repeat("pass", pattern, 1_000_000).1, Refused);
}
