//! Setup and budget of sample runs. Cost is counted in instructions, so that every machine gives the same
//! result.

use super::{INSTANTS, Instant, SampleFrame, SampleRun, Supplier};
use crate::facts::Facts;
use shaderlint_exec::{
    Bytecode, CompileOptions, Draw, LANES, Sampled, Watch, quads_all_over, sample,
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
    /// With 4,096 pixels, a defect on one of 900 pixels is missed in less than 1 % of runs.
    fn default() -> SampleLimit {
        SampleLimit {
            pixels: 4096,
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
/// Most instructions of 32 pixels if the user sets the number of pixels.
const MOST_FUEL: u64 = 20_000_000;

/// How far a sample run goes. Each round continues the previous one.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Round {
    /// 128 pixels: one step of the VM at each instant. Enough to see that an image is neither dark nor
    /// flat.
    First,
    /// 512 pixels: a fault in 1 % of the evaluations is missed in less than 1 % of runs.
    Second,
    /// All pixels, once there is something to claim.
    Last,
}

impl Round {
    /// Number of rounds.
    pub const COUNT: usize = 3;

    /// Number of pixels of this round and those before.
    const fn pixels(self) -> Option<u32> {
        match self {
            Round::First => Some(128),
            Round::Second => Some(512),
            Round::Last => None,
        }
    }
}

/// A shader that is ready for sample runs.
pub struct Bench {
    /// Bytecode that watches for faults.
    code: Bytecode,
    limit: SampleLimit,
    /// Most instructions of 32 pixels.
    fuel: u64,
    /// Most instructions of all pixels of an instant.
    budget: u64,
}

impl Bench {
    /// Compiles a shader; `None` if it is too large or cannot be run.
    pub(super) fn of(facts: &Facts) -> Option<Bench> {
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
        // An instant may use twice its share of the budget, since one may cost more than another.
        let (fuel, budget) = match limit.insists {
            true => (MOST_FUEL, u64::MAX),
            false => (BUDGET / LEAST_PIXELS, BUDGET / LANES as u64 / 2),
        };
        Some(Bench {
            code,
            limit,
            fuel,
            budget,
        })
    }

    /// The bytecode that watches for faults.
    pub fn watched(&self) -> &Bytecode {
        &self.code
    }

    /// Number of quads per instant of a round and those before; `None` if fewer fit into the budget than
    /// are worth it, by the price of the rounds `before`.
    pub(super) fn quads(&self, round: Round, before: Option<&SampleRun>) -> Option<usize> {
        let pixels = round.pixels().unwrap_or(u32::MAX).min(self.limit.pixels);
        let least = LEAST_PIXELS.min(pixels.into());
        let affordable = match before {
            Some(before) if !self.limit.insists => BUDGET / before.price().max(1),
            _ => u64::MAX,
        };
        let pixels = affordable.min(pixels.into());
        (pixels >= least).then_some(pixels as usize / 4 / INSTANTS.len())
    }

    /// Number of pixels that fit into the budget at this price.
    pub(crate) fn affordable(&self, price: u64) -> usize {
        match self.limit.insists {
            true => usize::MAX,
            false => (BUDGET / price.max(1)) as usize,
        }
    }

    /// Continues a sample run from one number of quads per instant to another; `None` if they exceed the
    /// budget.
    pub(super) fn extend(
        &self,
        sample_run: &SampleRun,
        supplier: &dyn Supplier,
        quads: usize,
        round: Round,
    ) -> Option<SampleRun> {
        let before = sample_run.pixels as usize / 4 / INSTANTS.len();
        let seed = round as u32 * INSTANTS.len() as u32;
        let more = quads.saturating_sub(before);
        let more = self.run_at(&INSTANTS, &self.code, supplier, (more, seed))?;
        let mut all = sample_run.clone();
        all.add(more);
        Some(all)
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

    /// Runs some quads at an instant, of which a few may use the whole budget; `None` if they exceed it
    /// this many times over.
    pub fn sample_costly(
        &self,
        code: &Bytecode,
        supplier: &dyn Supplier,
        instant: &Instant,
        (quads, times): (&[[u32; 2]], u64),
    ) -> Option<Sampled> {
        let mut draw = supplier.draw(code, SIZE, instant);
        let budget = self.budget.saturating_mul(times);
        (draw.fuel, draw.budget) = (budget.min(MOST_FUEL), budget);
        sample(&draw, quads).ok()
    }

    /// Runs some quads of a draw; `None` if they exceed the budget.
    pub fn sample_draw(&self, mut draw: Draw<'_>, quads: &[[u32; 2]]) -> Option<Sampled> {
        (draw.fuel, draw.budget) = (self.fuel, self.budget);
        sample(&draw, quads).ok()
    }

    /// Runs this number of quads at every instant; `None` if they exceed the budget.
    pub fn run(&self, code: &Bytecode, supplier: &dyn Supplier, quads: usize) -> Option<SampleRun> {
        self.run_at(&INSTANTS, code, supplier, (quads, 0))
    }

    /// Runs this number of quads at some instants, from this seed on; `None` if they exceed the budget.
    pub fn run_at(
        &self,
        instants: &[Instant],
        code: &Bytecode,
        supplier: &dyn Supplier,
        (quads, seed): (usize, u32),
    ) -> Option<SampleRun> {
        let mut sample_run = SampleRun::empty();
        for (instant, number) in instants.iter().zip(seed..) {
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
