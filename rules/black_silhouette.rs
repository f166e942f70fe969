//! Scenes in which no surface is lit.

use shaderlint_exec::Observations;
use shaderlint_lint::march::Hit;
use shaderlint_lint::prelude::*;
use std::collections::BTreeMap;

rule! { black_silhouette, Runtime, Warning, Recommended, Run(check) }

/// A pixel counts as black if no channel is brighter than this.
const BLACK: f32 = 3.0 / 255.0;
/// Least shares of the sampled quads that are entirely black, and entirely lit.
const SHARES: [f64; 2] = [0.03, 0.03];
/// The same shares of a few pixels.
const LIKELY: f64 = 0.01;
/// Least share of black pixels that hit a surface, of lit pixels that miss, and of hits that are
/// black.
const NEARLY_ALL: f64 = 0.99;

fn check(cx: &mut Context) {
    if !cx.facts.is_image_known() || cx.facts.hits().is_empty() {
        return;
    }
    let both = |few: &SampleRun| {
        let black = share(few.drawn(), is_black);
        (LIKELY..=1.0 - LIKELY).contains(&black)
    };
    if !cx.facts.round(Round::Second).is_some_and(both) {
        return;
    }
    let Some(sample_run) = cx.facts.sample_run() else {
        return;
    };
    let Some(usual) = halves(cx, sample_run) else {
        return;
    };
    let mut black: Vec<&Hit> = cx.facts.hits().iter().collect();
    black.retain(|hit| is_black_where_hit(hit, &usual));
    if black.is_empty() {
        return;
    }
    let later = cx.facts.later_run(Watch::Faults);
    let Some(later) = later.and_then(|later| halves(cx, &later)) else {
        return;
    };
    for hit in black {
        if is_black_where_hit(hit, &later) {
            let note = sample_run.sampled_note();
            let finding = cx.report_op(hit.condition, "all surfaces hit by rays are black");
            finding.note(note).help(
                "add ambient light, such as a constant term of 0.2, or move the light to the \
                visible side",
            );
            return;
        }
    }
}

/// Whether nearly all hits are black, and nearly all misses are not.
fn is_black_where_hit(hit: &Hit, [black, lit]: &[Observations; 2]) -> bool {
    let (Some(black), Some(lit)) = (hit.seen(black), hit.seen(lit)) else {
        return false;
    };
    let shares = [
        part(black.0, black.1),
        part(lit.1, lit.0),
        part(black.0, lit.0),
    ];
    shares.iter().all(|share| *share >= NEARLY_ALL)
}

/// The share of `some` in the sum of both; 0 if both are 0.
fn part(some: u64, others: u64) -> f64 {
    some as f64 / (some + others).max(1) as f64
}

/// What a run of the black quads shows, and one of the lit quads; `None` if there are too few of
/// either at any instant.
fn halves(cx: &Context, sample_run: &SampleRun) -> Option<[Observations; 2]> {
    let (bench, supplier) = cx.facts.bench()?;
    let mut seen = [Observations::default(), Observations::default()];
    for frame in &sample_run.frames {
        let mut quads: BTreeMap<[u32; 2], [u32; 2]> = BTreeMap::new();
        for pixel in frame.drawn() {
            let [lit, black] = quads.entry(pixel.at.map(|at| at & !1)).or_default();
            match is_black(&pixel) {
                true => *black += 1,
                false => *lit += 1,
            }
        }
        let all = quads.len().max(1) as f64;
        let sides = [[0, 4], [4, 0]];
        for ((seen, side), least) in seen.iter_mut().zip(sides).zip(SHARES) {
            let chosen = quads.iter().filter(|(_, counts)| **counts == side);
            let chosen: Vec<[u32; 2]> = chosen.map(|(quad, _)| *quad).collect();
            if (chosen.len() as f64) < least * all {
                return None;
            }
            let sampled = bench.sample(bench.watched(), supplier, &frame.instant, &chosen)?;
            seen.add(sampled.seen);
        }
    }
    Some(seen)
}

fn is_black(pixel: &SampledPixel) -> bool {
    pixel.shown().iter().all(|lane| *lane <= BLACK)
}
