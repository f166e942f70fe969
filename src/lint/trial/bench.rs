//! How a shader is run for a trial, and how much of it: what a run costs is counted in operations, so
//! that every machine gives the same answer.

use super::{INSTANTS, Instant, Supplier, Trial, TrialShot};
use crate::facts::Facts;
use shaderlint_exec::{
    Code, CompileOptions, Draw, LANES, Sampled, Seen, Watch, quads_all_over, sample,
};
use shaderlint_semantic::Stage;

/// The size of the picture whose pixels are run.
pub const SIZE: [u32; 2] = [1280, 720];

/// How much of a shader is run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TrialLimit {
    /// How many pixels; none where this is zero.
    pub pixels: u32,
    /// Whether they are run whatever that takes.
    pub insists: bool,
}

impl Default for TrialLimit {
    /// A defect on one of 2,000 pixels is missed less than once in a hundred times.
    fn default() -> TrialLimit {
        TrialLimit {
            pixels: 9216,
            insists: false,
        }
    }
}

impl TrialLimit {
    /// So many pixels as a user asks for, whatever they take.
    pub fn of(pixels: u32) -> TrialLimit {
        TrialLimit {
            pixels,
            insists: true,
        }
    }

    /// How many instructions a shader may become.
    pub fn instructions(self) -> Option<usize> {
        (!self.insists).then_some(MOST_INSTRUCTIONS)
    }
}

/// Instructions, times 32 lanes, that a trial may take: some 10 ms on a core of 2020.
const BUDGET: u64 = 40_000_000;
/// Fewer pixels than these tell nothing.
const LEAST_PIXELS: u64 = 512;
/// Operations in a shader's text, calls replaced by what they call, that are compiled unasked.
const MOST_CODE: f64 = 40_000.0;
/// Instructions that they may become.
const MOST_INSTRUCTIONS: usize = 60_000;
/// Quads whose cost tells what all will cost: as many as fill the lanes three times.
const PRICED: usize = 24;
/// Instructions that 32 pixels may take where a user insists.
const MOST_FUEL: u64 = 20_000_000;

/// How a shader is run.
pub struct Bench {
    /// Watched for faults.
    code: Code,
    /// How many quads are run at each instant.
    pub quads: usize,
    /// Instructions that 32 pixels may take.
    fuel: u64,
    /// Instructions that the pixels of an instant may take together.
    budget: u64,
}

impl Bench {
    /// Makes a shader ready, and finds out how much of it may be run.
    pub(super) fn of(facts: &Facts, supplier: &dyn Supplier) -> Option<Bench> {
        let limit = facts.tried.limit;
        let program = facts.program();
        let entry = facts.entry()?;
        if limit.pixels == 0 || program.stage != Stage::Fragment || facts.broken.any() {
            return None;
        }
        if !limit.insists && facts.work().size(entry) > MOST_CODE {
            return None;
        }
        let options = CompileOptions {
            watch: Watch::Faults,
            ..CompileOptions::default()
        };
        let pixels = u64::from(limit.pixels);
        let mut bench = Bench {
            code: facts.compiled(&options)?,
            quads: 0,
            fuel: MOST_FUEL,
            budget: u64::MAX,
        };
        if !limit.insists {
            bench.fuel = BUDGET / LEAST_PIXELS;
            // Twice the share of an instant: it may cost more than another.
            bench.budget = BUDGET / LANES as u64 / 2;
        }
        let affordable = match limit.insists {
            true => pixels,
            false => pixels.min(BUDGET / bench.price(supplier)?.max(1)),
        };
        let by_instant = affordable / 4 / INSTANTS.len() as u64;
        bench.quads = by_instant as usize;
        (limit.insists || affordable >= LEAST_PIXELS.min(pixels)).then_some(bench)
    }

    /// What it is run as.
    pub fn watched(&self) -> &Code {
        &self.code
    }

    /// Instructions of a pixel, by a few quads from all over the picture.
    fn price(&self, supplier: &dyn Supplier) -> Option<u64> {
        let few = quads_all_over(SIZE, PRICED, 0);
        let (mut spent, mut pixels) = (0, 0);
        for instant in [INSTANTS.first()?, INSTANTS.last()?] {
            let sampled = self.sample(&self.code, supplier, instant, &few)?;
            spent += sampled.spent * LANES as u64;
            pixels += sampled.pixels.len() as u64;
        }
        spent.checked_div(pixels)
    }

    /// Runs some quads at an instant; `None` where they take too long.
    pub fn sample(
        &self,
        code: &Code,
        supplier: &dyn Supplier,
        instant: &Instant,
        quads: &[[u32; 2]],
    ) -> Option<Sampled> {
        self.sample_draw(supplier.draw(code, SIZE, instant), quads)
    }

    /// Runs some quads of a draw; `None` where they take too long.
    pub fn sample_draw(&self, mut draw: Draw<'_>, quads: &[[u32; 2]]) -> Option<Sampled> {
        (draw.fuel, draw.budget) = (self.fuel, self.budget);
        sample(&draw, quads).ok()
    }

    /// Runs so many quads at every instant; `None` where they take too long.
    pub fn run(&self, code: &Code, supplier: &dyn Supplier, quads: usize) -> Option<Trial> {
        let mut trial = Trial {
            pixels: 0,
            seen: Seen::default(),
            shots: Vec::with_capacity(INSTANTS.len()),
        };
        for (instant, number) in INSTANTS.iter().zip(0..) {
            let sampled = self.sample(
                code,
                supplier,
                instant,
                &quads_all_over(SIZE, quads, number),
            )?;
            trial.pixels += sampled.pixels.len() as u64;
            trial.seen.add(sampled.seen.clone());
            trial.shots.push(TrialShot {
                instant: *instant,
                colors: colors(code, &sampled),
                sampled,
            });
        }
        Some(trial)
    }
}

/// By pixel: what the first output holds, as far as it is shown.
pub fn colors(code: &Code, sampled: &Sampled) -> Vec<[f32; 3]> {
    let (Some(slot), Some(bits)) = (code.outputs.first(), sampled.outputs.first()) else {
        return Vec::new();
    };
    let colors = bits.iter().map(|[r, g, b, _]| {
        let mut color = [*r, *g, *b].map(|bits| slot.number(bits));
        // What an output has not is black.
        let absent = color.iter_mut().skip(slot.lanes());
        absent.for_each(|lane| *lane = 0.0);
        color
    });
    colors.collect()
}
