//! Setup and budget of sample runs. Cost is counted in instructions, so that every machine gives the same
//! result.

use super::{INSTANTS, Instant, SampleFrame, SampleRun, Supplier};
use crate::facts::Facts;
use shaderlint_exec::{
    Bytecode, CompileOptions, Draw, LANES, Observations, Sampled, Watch, quads_all_over, sample,
};
use shaderlint_semantic::Stage;

/// Width and height of the sampled frame, in pixels.
pub const SIZE: [u32; 2] = [1280, 720];

/// How much of a shader is sampled.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SampleLimit {
    /// Number of pixels; 0 turns sampling off.
    pub pixels: u32,
    /// Whether to sample all of them, whatever the cost.
    pub insists: bool,
}

impl Default for SampleLimit {
    /// With 9,216 pixels, a defect on one of 2,000 pixels is missed in less than 1 % of runs.
    fn default() -> SampleLimit {
        SampleLimit {
            pixels: 9216,
            insists: false,
        }
    }
}

impl SampleLimit {
    /// The number of pixels that a user asks for, whatever the cost.
    pub fn of(pixels: u32) -> SampleLimit {
        SampleLimit {
            pixels,
            insists: true,
        }
    }

    /// Most instructions of the bytecode; `None` without a limit.
    pub fn instructions(self) -> Option<usize> {
        (!self.insists).then_some(MOST_INSTRUCTIONS)
    }
}

/// Budget of a sample run in instructions times 32 lanes: about 10 ms on a core of 2020.
const BUDGET: u64 = 40_000_000;
/// Fewest pixels that are worth sampling.
const LEAST_PIXELS: u64 = 512;
/// Most operations of a shader, with calls inlined, that is compiled by default.
const MOST_CODE: f64 = 40_000.0;
/// Most instructions of its bytecode.
const MOST_INSTRUCTIONS: usize = 60_000;
/// Most uniforms and most varyings of a shader that is run: four times as many as common devices
/// link. Each of them is set by name in every draw.
const MOST_UNIFORMS: usize = 4 * 1_024;
const MOST_VARYINGS: usize = 4 * 32;
/// Number of quads for the cost estimate: enough to fill the lanes three times.
const PRICED: usize = 24;
/// Most instructions of 32 pixels if the user sets the number of pixels.
const MOST_FUEL: u64 = 20_000_000;

/// A shader that is ready for sample runs.
pub struct Bench {
    /// Bytecode that watches for faults.
    code: Bytecode,
    /// Number of quads per instant.
    pub quads: usize,
    /// Most instructions of 32 pixels.
    fuel: u64,
    /// Most instructions of all pixels of an instant.
    budget: u64,
}

impl Bench {
    /// Compiles a shader, and estimates how many pixels fit into the budget.
    pub(super) fn of(facts: &Facts, supplier: &dyn Supplier) -> Option<Bench> {
        let limit = facts.samples.limit;
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
        let code = facts.compiled(&options)?;
        if code.uniforms.len() > MOST_UNIFORMS || code.inputs.len() > MOST_VARYINGS {
            return None;
        }
        let pixels = u64::from(limit.pixels);
        let mut bench = Bench {
            code,
            quads: 0,
            fuel: MOST_FUEL,
            budget: u64::MAX,
        };
        if !limit.insists {
            bench.fuel = BUDGET / LEAST_PIXELS;
            // Twice the share of an instant, since one may cost more than another.
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

    /// The bytecode that watches for faults.
    pub fn watched(&self) -> &Bytecode {
        &self.code
    }

    /// Instructions per pixel, estimated from a few quads all over the frame.
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

    /// Runs some quads at an instant; `None` if they exceed the budget.
    pub fn sample(
        &self,
        code: &Bytecode,
        supplier: &dyn Supplier,
        instant: &Instant,
        quads: &[[u32; 2]],
    ) -> Option<Sampled> {
        self.sample_draw(supplier.draw(code, SIZE, instant), quads)
    }

    /// Runs some quads of a draw; `None` if they exceed the budget.
    pub fn sample_draw(&self, mut draw: Draw<'_>, quads: &[[u32; 2]]) -> Option<Sampled> {
        (draw.fuel, draw.budget) = (self.fuel, self.budget);
        sample(&draw, quads).ok()
    }

    /// Runs this number of quads at every instant; `None` if they exceed the budget.
    pub fn run(&self, code: &Bytecode, supplier: &dyn Supplier, quads: usize) -> Option<SampleRun> {
        self.run_at(&INSTANTS, code, supplier, quads)
    }

    /// Runs this number of quads at some instants; `None` if they exceed the budget.
    pub fn run_at(
        &self,
        instants: &[Instant],
        code: &Bytecode,
        supplier: &dyn Supplier,
        quads: usize,
    ) -> Option<SampleRun> {
        let mut sample_run = SampleRun {
            pixels: 0,
            seen: Observations::default(),
            frames: Vec::with_capacity(instants.len()),
        };
        for (instant, number) in instants.iter().zip(0..) {
            let sampled = self.sample(
                code,
                supplier,
                instant,
                &quads_all_over(SIZE, quads, number),
            )?;
            sample_run.pixels += sampled.pixels.len() as u64;
            sample_run.seen.add(sampled.seen.clone());
            sample_run.frames.push(SampleFrame {
                instant: *instant,
                colors: colors(code, &sampled),
                sampled,
            });
        }
        Some(sample_run)
    }
}

/// By pixel: the red, green and blue channels of the first output.
pub fn colors(code: &Bytecode, sampled: &Sampled) -> Vec<[f32; 3]> {
    let (Some(slot), Some(bits)) = (code.outputs.first(), sampled.outputs.first()) else {
        return Vec::new();
    };
    let colors = bits.iter().map(|[r, g, b, _]| {
        let mut color = [*r, *g, *b].map(|bits| slot.number(bits));
        // Missing channels are 0.
        let absent = color.iter_mut().skip(slot.lanes());
        absent.for_each(|lane| *lane = 0.0);
        color
    });
    colors.collect()
}
