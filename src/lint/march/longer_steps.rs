//! Steps that are needlessly short: a march with longer ones draws the same image.

use super::loops::{March, MarchGoal};
use super::stepped_over::{RayOutcome, StepLength, ray_probe};
use crate::facts::Facts;
use crate::sample::{INSTANTS, Instant, LATER, Round, SIZE, SampleFrame, colors, is_apart};
use shaderlint_exec::{Bytecode, CompileOptions, Sampled, Watch, quads_all_over};
use shaderlint_ir::LoopId;

/// Longer steps with which the image stays the same.
#[derive(Clone, PartialEq, Debug)]
pub struct LongerSteps {
    /// The literal factor of these steps.
    pub factor: f64,
    /// Iterations per ray, before and after.
    pub iterations: [f64; 2],
    /// What was sampled, as a note.
    pub sampled: String,
}

/// Fewest iterations per ray of a loop that is worth changing.
const LEAST_ITERATIONS: f64 = 10.0;
/// Share of the iterations that may be left with longer steps.
const LEFT: f64 = 0.8;
/// Least growth of a factor: steps that are shorter than that save too few iterations.
const LEAST_GROWTH: f64 = 1.2;
/// The factors that are candidates, in twentieths.
const TWENTIETHS: std::ops::RangeInclusive<u32> = 1..=20;
/// How many times the budget of a sample run one instant may use.
const CONFIRMED: u64 = 4;

/// The factors that are worth a try in place of another one, the smallest first.
pub fn longer_factors(factor: f64) -> Vec<f64> {
    let all = TWENTIETHS.map(|n| f64::from(n) / 20.0);
    all.filter(|longer| *longer >= factor * LEAST_GROWTH)
        .collect()
}

/// How a loop that marches by a distance with a literal factor is observed with another factor.
pub fn factor_length(factor: f64, other: f64) -> StepLength {
    StepLength {
        thousandths: (other / factor * 1000.0).round() as u32,
        times: 1,
    }
}

/// The largest of some factors, of which all below one that fits do; `None` if none does, or if a run
/// fails.
pub fn largest_factor(factors: &[f64], mut fits: impl FnMut(f64) -> Option<bool>) -> Option<f64> {
    let (mut from, mut to) = (0, factors.len());
    // Most loops cannot have longer steps at all.
    let mut middle = 0;
    while from < to {
        match fits(*factors.get(middle)?)? {
            true => from = middle + 1,
            false => to = middle,
        }
        middle = (from + to) / 2;
    }
    factors.get(from.checked_sub(1)?).copied()
}

/// The image and the rays of some pixels.
pub struct MarchSample {
    colors: Vec<[f32; 3]>,
    rays: Vec<RayOutcome>,
    entries: u64,
    iterations: u64,
}

impl MarchSample {
    /// What was sampled with bytecode that observes a loop.
    pub fn of(code: &Bytecode, sampled: &Sampled, looped: LoopId) -> MarchSample {
        let mut loops = sampled.seen.loops.iter();
        let seen = loops.find(|seen| seen.id == looped);
        MarchSample {
            colors: colors(code, sampled),
            rays: RayOutcome::all(&sampled.outputs),
            entries: seen.map_or(0, |seen| seen.entries),
            iterations: seen.map_or(0, |seen| seen.iterations),
        }
    }

    /// Whether no pixel looks different with longer steps, and no ray steps over a surface.
    pub fn is_kept_by(&self, longer: &MarchSample) -> bool {
        let mut colors = self.colors.iter().zip(&longer.colors);
        let mut rays = self.rays.iter().zip(&longer.rays);
        !colors.any(|(a, b)| is_apart(*a, *b)) && !rays.any(|(a, b)| b.steps_over([a, a]))
    }

    /// Iterations per ray.
    pub fn per_ray(all: &[MarchSample]) -> f64 {
        let entries: u64 = all.iter().map(|sample| sample.entries).sum();
        let iterations: u64 = all.iter().map(|sample| sample.iterations).sum();
        iterations as f64 / entries.max(1) as f64
    }
}

/// Whether a loop takes so many iterations less that it is worth a change.
pub fn are_clearly_fewer([before, after]: [f64; 2]) -> bool {
    before >= LEAST_ITERATIONS && after <= before * LEFT
}

/// Pixels of a frame: their quads.
type FrameQuads = (Instant, Vec<[u32; 2]>);

/// The same rays with steps of other lengths.
struct FactorSearch<'f, 'a> {
    facts: &'f Facts<'a>,
    march: &'f March,
    factor: f64,
}

impl FactorSearch<'_, '_> {
    fn code(&self, factor: f64) -> Option<Bytecode> {
        let length = factor_length(self.factor, factor);
        self.facts.compiled(&CompileOptions {
            watch: Watch::Flow,
            rays: Some(ray_probe(self.march, self.facts.module(), length)?),
            ..CompileOptions::default()
        })
    }

    fn samples(&self, code: &Bytecode, frames: &[FrameQuads]) -> Option<Vec<MarchSample>> {
        let (bench, supplier) = self.facts.bench()?;
        let all = frames.iter().map(|(instant, quads)| {
            let sampled = bench.sample_costly(code, supplier, instant, (quads, CONFIRMED))?;
            Some(MarchSample::of(code, &sampled, self.march.ray.looped))
        });
        all.collect()
    }

    /// Whether all pixels stay as they were, frame by frame.
    fn is_kept(
        &self,
        before: &[MarchSample],
        code: &Bytecode,
        frames: &[FrameQuads],
    ) -> Option<bool> {
        let (bench, supplier) = self.facts.bench()?;
        for (before, (instant, quads)) in before.iter().zip(frames) {
            let sampled = bench.sample_costly(code, supplier, instant, (quads, CONFIRMED))?;
            if !before.is_kept_by(&MarchSample::of(code, &sampled, self.march.ray.looped)) {
                return Some(false);
            }
        }
        Some(true)
    }

    /// The largest factor that keeps the pixels of some frames.
    fn largest(&self, factors: &[f64], frames: &[FrameQuads]) -> Option<f64> {
        let before = self.samples(&self.code(self.factor)?, frames)?;
        largest_factor(factors, |factor| {
            self.is_kept(&before, &self.code(factor)?, frames)
        })
    }
}

fn frame_quads(frames: &[SampleFrame]) -> Vec<FrameQuads> {
    let frames = frames.iter();
    frames.map(|frame| (frame.instant, frame.quads())).collect()
}

impl Facts<'_> {
    /// The longest steps of a loop with this literal factor that keep the image and save iterations; `None`
    /// where there are none, or where the shader cannot be run.
    pub fn longer_steps(&self, march: &March, factor: f64) -> Option<LongerSteps> {
        if march.goal == MarchGoal::Shadow || !self.is_image_known() {
            return None;
        }
        let first = self.round(Round::First)?;
        let seen = self.loop_observation(&first.seen, march.looped.stmt)?;
        if (seen.iterations as f64) < LEAST_ITERATIONS * seen.entries as f64 {
            return None;
        }
        let search = FactorSearch {
            facts: self,
            march,
            factor,
        };
        // Each run leaves less to try for the next one, which is larger.
        let mut factors = longer_factors(factor);
        let few = frame_quads(&first.frames);
        let last = self.sample_run()?;
        let all = frame_quads(&last.frames);
        let quads = self.fewer_quads()?;
        let later = LATER.iter().zip(INSTANTS.len() as u32..);
        let later: Vec<FrameQuads> = later
            .map(|(instant, seed)| (*instant, quads_all_over(SIZE, quads, seed)))
            .collect();
        for frames in [&few, &all, &later] {
            let largest = search.largest(&factors, frames)?;
            factors.retain(|factor| *factor <= largest);
        }
        let longest = *factors.last()?;
        let [before, after] = [factor, longest].map(|factor| {
            let samples = search.samples(&search.code(factor)?, &all)?;
            Some(MarchSample::per_ray(&samples))
        });
        let iterations = [before?, after?];
        are_clearly_fewer(iterations).then(|| LongerSteps {
            factor: longest,
            iterations,
            sampled: last.sampled_note(),
        })
    }
}
