//! Rays that step over a surface: the same march with shorter steps finds it before the place where a longer
//! step has passed it.

use super::loops::March;
use crate::facts::Facts;
use crate::sample::{Instant, Round, SampleFrame, SampleRun, colors, is_apart};
use shaderlint_exec::{Bytecode, CompileOptions, RayProbe, Sampled};
use shaderlint_flow::{Bound, RayKind};
use shaderlint_ir::{Module, Step};

/// The length of steps, in thousandths of that of the shader, and by what the limit of iterations is
/// multiplied.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct StepLength {
    /// Thousandths of the length in the shader.
    pub thousandths: u32,
    /// Factor of the limit.
    pub times: u32,
}

impl StepLength {
    /// As in the shader.
    pub const FULL: StepLength = StepLength {
        thousandths: 1000,
        times: 1,
    };
    /// The lengths that must agree on where a surface is. Rays with shorter steps need more of them to get
    /// as near, hence the limits.
    pub const SHORTER: [StepLength; 2] = [
        StepLength {
            thousandths: 250,
            times: 6,
        },
        StepLength {
            thousandths: 100,
            times: 16,
        },
    ];

    /// A length with enough iterations to get as far.
    pub const fn complete(thousandths: u32) -> StepLength {
        StepLength {
            thousandths,
            times: 1000_u32.div_ceil(thousandths),
        }
    }
}

/// How a loop that marches by a distance is observed; `None` if its hits are unknown or depend on the number
/// of steps, or its limit cannot be raised.
pub fn ray_probe(march: &March, module: &Module, length: StepLength) -> Option<RayProbe> {
    let ray = &march.ray;
    if ray.hit.is_none() || ray.motion.is_counted || ray.accumulates {
        return None;
    }
    let limit = match (march.looped.given, march.looped.bound) {
        (Some(given), _) => {
            let op = module.op_of(given)?;
            (!module.constant(op).is_empty()).then_some(())?;
            Some((op, length.times))
        }
        (None, Bound::Open) => None,
        (None, _) => return None,
    };
    // The condition of the loop is tested before an iteration starts.
    let is_before = ray.hit.is_some_and(|hit| {
        let test = module
            .looped(ray.looped)
            .map_or(&[][..], |l| module.steps(l.test));
        let mut steps = module.steps_in(test);
        steps.any(|step| matches!(step, Step::Run(run) if run.contains(hit.condition)))
    });
    let probe = slope_probe(march)?;
    Some(RayProbe {
        thousandths: length.thousandths,
        limit,
        is_late: probe.is_late && !is_before,
        ..probe
    })
}

/// How the slope along the rays of a loop is observed; `None` for loops that do not march by a distance.
pub fn slope_probe(march: &March) -> Option<RayProbe> {
    let (ray, motion) = (&march.ray, &march.ray.motion);
    if ray.kind != RayKind::Distance || motion.steps.len() > RayProbe::STEPS {
        return None;
    }
    let (moved, lanes) = motion.moved.as_ref()?;
    let mut scalars = [None; 4];
    for (slot, lane) in scalars.iter_mut().zip(lanes) {
        *slot = Some(*lane);
    }
    let mut steps = [None; RayProbe::STEPS];
    for (slot, step) in steps.iter_mut().zip(&motion.steps) {
        *slot = Some((step.sum, step.term));
    }
    Some(RayProbe {
        looped: ray.looped,
        moved: *moved,
        scalars,
        steps,
        condition: ray.hit.map(|hit| hit.condition),
        truth: ray.hit.is_some_and(|hit| hit.truth),
        is_late: ray.hit.is_some_and(|hit| hit.is_late),
        point: motion.point,
        field: motion.field,
        thousandths: StepLength::FULL.thousandths,
        limit: None,
    })
}

/// How the first march of a pixel went. Distances are from the start of the ray.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RayOutcome {
    /// Whether the loop was reached.
    pub is_reached: bool,
    /// The largest slope of the scene's distance between two steps.
    pub slope: f32,
    /// The largest change of that distance between two steps, relative to itself: above 1, a step may
    /// have been longer than the distance to a surface.
    change: f32,
    /// Whether the last test was a hit, and the distance there.
    is_hit: bool,
    tested: f32,
    /// The distance of the last place that was tested without a hit.
    passed: f32,
    /// The point at the last test.
    pub point: Option<[f32; 3]>,
}

impl RayOutcome {
    /// The outcomes of all pixels, from the outputs of a draw with a ray probe.
    pub fn all(outputs: &[Vec<[u32; 4]>]) -> Vec<RayOutcome> {
        let [.., marches, tests, points] = outputs else {
            return Vec::new();
        };
        let numbers = |bits: &[u32; 4]| bits.map(f32::from_bits);
        let all = marches.iter().zip(tests).zip(points);
        let one = |((march, test), point): ((&[u32; 4], &[u32; 4]), &[u32; 4])| {
            let [reached, slope, change, _] = numbers(march);
            let [hit, tested, passed, _] = numbers(test);
            let [x, y, z, is_known] = numbers(point);
            RayOutcome {
                is_reached: reached != 0.0,
                slope,
                change,
                is_hit: hit != 0.0,
                tested,
                passed,
                point: (is_known != 0.0).then_some([x, y, z]),
            }
        };
        all.map(one).collect()
    }

    /// Whether the ray has stepped over a surface that two marches with shorter steps have found: it has
    /// tested a place beyond without a hit, and did not return.
    pub fn steps_over(&self, shorter: [&RayOutcome; 2]) -> bool {
        let [short, shortest] = shorter;
        let passed = match self.is_hit {
            true => self.passed.min(self.tested),
            false => self.passed,
        };
        let is_before = |other: &RayOutcome| {
            let is_hit = other.is_reached && other.is_hit;
            is_hit && other.tested < passed * (1.0 - MARGIN) - MARGIN
        };
        let apart = shortest.tested - short.tested;
        self.is_reached
            && is_before(short)
            && is_before(shortest)
            && apart <= AGREED * (passed - short.tested)
    }
}

/// By how much a place must be farther than another, relative to the distance from the start.
const MARGIN: f32 = 1e-3;
/// How far apart the marches with shorter steps may find the surface, relative to how far it was passed.
const AGREED: f32 = 0.25;

/// What the shorter steps of a loop find in the sampled pixels.
#[derive(Clone, Debug)]
pub struct SteppedOver {
    /// Share of the sampled pixels whose ray steps over a surface, so that the pixel looks different.
    pub share: f64,
    /// What was sampled, as a note.
    pub sampled: String,
    /// The first such pixel, the time of its frame, and the point of the surface.
    pub first: ([u32; 2], f64, Option<[f32; 3]>),
    /// The longest steps with which nearly all of these rays find the surface.
    pub repair: Option<StepLength>,
}

/// How many times the budget of a sample run may be spent to confirm and to fix what a few pixels have shown.
const CONFIRMED: u64 = 8;
/// Largest relative change of a distance between two steps that is due to rounding.
const LARGEST_CHANGE: f32 = 1.02;
/// Fewest affected pixels.
const LEAST_PIXELS: usize = 2;
/// Least share of affected pixels.
const OFTEN: f64 = 0.005;
/// Share of the affected rays that may still step over the surface with shorter steps.
const REST: f64 = 0.01;
/// The lengths of steps that are candidate, longest first.
const LENGTHS: [u32; 8] = [900, 800, 700, 600, 500, 400, 300, 200];
/// Share of pixels that may look different because the limit of iterations is not raised.
const UNFINISHED: f64 = 0.005;

/// The quads of a frame in which rays may step over a surface.
struct SuspectQuads {
    instant: Instant,
    quads: Vec<[u32; 2]>,
}

/// A ray that steps over a surface.
struct MissedRay {
    /// Index of the frame and of the pixel in it.
    at: (usize, usize),
    pixel: [u32; 2],
    time: f64,
    point: Option<[f32; 3]>,
}

impl Facts<'_> {
    /// What shorter steps of a loop find; `None` where rays hardly ever step over a surface, where that is
    /// not visible, or where the shader cannot be run.
    pub fn stepped_over(&self, march: &March) -> Option<SteppedOver> {
        if !self.is_image_known() {
            return None;
        }
        let full = self.with_steps(march, StepLength::FULL)?;
        if !self.may_step_over(march, &full)? {
            return None;
        }
        let [short, shortest] = StepLength::SHORTER;
        let short = self.with_steps(march, short)?;
        let first = self.round(Round::First)?;
        let (count, suspects, price) = self.suspects(&first.frames, &short)?;
        if count == 0 {
            return None;
        }
        let codes = [&full, &short, &self.with_steps(march, shortest)?];
        if self.missed(&suspects, codes)?.is_empty() {
            return None;
        }
        let more = self.affordable(price).unwrap_or_else(|| first.clone());
        let (_, suspects, _) = self.suspects(&more.frames, &short)?;
        let missed = self.missed(&suspects, codes)?;
        let share = missed.len() as f64 / more.pixels.max(1) as f64;
        let is_often = missed.len() >= LEAST_PIXELS && share >= OFTEN;
        let first = missed.first().filter(|_| is_often)?;
        Some(SteppedOver {
            share,
            sampled: more.sampled_note(),
            first: (first.pixel, first.time, first.point),
            repair: self.repair(march, (&suspects, &missed), [codes[1], codes[2]]),
        })
    }

    /// Whether steps of the first pixels are longer than the distance to a surface may be.
    fn may_step_over(&self, march: &March, full: &Bytecode) -> Option<bool> {
        if march.ray.motion.field.is_none() {
            return Some(true);
        }
        let (bench, supplier) = self.bench()?;
        for frame in &self.round(Round::First)?.frames {
            let quads = frame.quads();
            let sampled = bench.sample_costly(full, supplier, &frame.instant, (&quads, 1))?;
            let mut rays = RayOutcome::all(&sampled.outputs).into_iter();
            if rays.any(|ray| ray.change > LARGEST_CHANGE) {
                return Some(true);
            }
        }
        Some(false)
    }

    /// The shader with steps of another length in a loop, and its march observed.
    fn with_steps(&self, march: &March, length: StepLength) -> Option<Bytecode> {
        self.compiled(&CompileOptions {
            rays: Some(ray_probe(march, self.module(), length)?),
            ..CompileOptions::default()
        })
    }

    /// The part of the sample run with as many pixels as the budget permits at this price.
    fn affordable(&self, price: u64) -> Option<SampleRun> {
        let (bench, _) = self.bench()?;
        let mut all = self.sample_run()?.clone();
        let quads = bench.affordable(price) / 4 / all.frames.len().max(1);
        all.pixels = 0;
        for frame in &mut all.frames {
            let pixels = (quads * 4).min(frame.sampled.pixels.len());
            frame.sampled.pixels.truncate(pixels);
            frame.colors.truncate(pixels);
            all.pixels += pixels as u64;
        }
        (quads > 0).then_some(all)
    }

    /// The pixels that look different with shorter steps and then hit something: their number, their quads,
    /// and the price of a pixel.
    fn suspects(
        &self,
        frames: &[SampleFrame],
        short: &Bytecode,
    ) -> Option<(usize, Vec<SuspectQuads>, u64)> {
        let (bench, supplier) = self.bench()?;
        let (mut count, mut spent, mut pixels) = (0, 0, 0);
        let mut all = Vec::new();
        for frame in frames {
            let sampled =
                bench.sample_costly(short, supplier, &frame.instant, (&frame.quads(), 1))?;
            spent += sampled.spent;
            pixels += sampled.pixels.len() as u64;
            let after = colors(short, &sampled);
            let changed = frame.colors.iter().zip(after);
            let hits = RayOutcome::all(&sampled.outputs);
            let is_suspect: Vec<bool> = changed
                .zip(hits)
                .map(|((a, b), ray)| ray.is_hit && is_apart(*a, b))
                .collect();
            count += is_suspect.iter().filter(|is| **is).count();
            let quads = frame.quads().into_iter().zip(is_suspect.chunks(4));
            all.push(SuspectQuads {
                instant: frame.instant,
                quads: quads
                    .filter(|(_, quad)| quad.contains(&true))
                    .map(|(quad, _)| quad)
                    .collect(),
            });
        }
        let price = spent * shaderlint_exec::LANES as u64 / pixels.max(1);
        Some((count, all, price))
    }

    fn sampled_at(&self, code: &Bytecode, suspects: &SuspectQuads) -> Option<Sampled> {
        let (bench, supplier) = self.bench()?;
        bench.sample_costly(
            code,
            supplier,
            &suspects.instant,
            (&suspects.quads, CONFIRMED),
        )
    }

    /// The rays that step over a surface, so that their pixels look different.
    fn missed(&self, suspects: &[SuspectQuads], codes: [&Bytecode; 3]) -> Option<Vec<MissedRay>> {
        let mut missed = Vec::new();
        for (frame, own) in suspects.iter().enumerate() {
            if own.quads.is_empty() {
                continue;
            }
            let [full, short, shortest] = codes.map(|code| self.sampled_at(code, own));
            let runs = [full?, short?, shortest?];
            let [full, short, shortest] = runs.each_ref().map(|run| RayOutcome::all(&run.outputs));
            let before = colors(codes[0], &runs[0]);
            let after = colors(codes[1], &runs[1]);
            let looks = before.into_iter().zip(after);
            let rays = full.iter().zip(short.iter().zip(&shortest));
            let all = rays.zip(looks).zip(&runs[0].pixels).enumerate();
            for (at, (((real, (short, shortest)), (before, after)), pixel)) in all {
                if real.steps_over([short, shortest]) && is_apart(before, after) {
                    missed.push(MissedRay {
                        at: (frame, at),
                        pixel: *pixel,
                        time: own.instant.time,
                        point: shortest.point,
                    });
                }
            }
        }
        Some(missed)
    }

    /// The longest steps with which nearly all rays find the surface that they step over.
    fn repair(
        &self,
        march: &March,
        (suspects, missed): (&[SuspectQuads], &[MissedRay]),
        [short, shortest]: [&Bytecode; 2],
    ) -> Option<StepLength> {
        let outcomes = |code: &Bytecode| -> Option<Vec<Vec<RayOutcome>>> {
            let all = suspects.iter().map(|own| {
                if own.quads.is_empty() {
                    return Some(Vec::new());
                }
                Some(RayOutcome::all(&self.sampled_at(code, own)?.outputs))
            });
            all.collect()
        };
        let (short, shortest) = (outcomes(short)?, outcomes(shortest)?);
        let get = |all: &[Vec<RayOutcome>], (frame, at): (usize, usize)| {
            all.get(frame).and_then(|frame| frame.get(at)).copied()
        };
        let is_repaired = |thousandths: u32| -> Option<bool> {
            let length = StepLength::complete(thousandths);
            let candidate = outcomes(&self.with_steps(march, length)?)?;
            let rest = missed.iter().filter(|ray| {
                let all = [&candidate, &short, &shortest].map(|all| get(all, ray.at));
                let [Some(candidate), Some(short), Some(shortest)] = all else {
                    return true;
                };
                candidate.steps_over([&short, &shortest])
            });
            Some(rest.count() as f64 <= REST * missed.len() as f64)
        };
        // Shorter steps pass fewer surfaces.
        let (mut from, mut to) = (0, LENGTHS.len());
        while from < to {
            let middle = (from + to) / 2;
            match is_repaired(*LENGTHS.get(middle)?)? {
                true => to = middle,
                false => from = middle + 1,
            }
        }
        let length = StepLength::complete(*LENGTHS.get(from)?);
        Some(match self.needs_more(march, length)? {
            true => length,
            false => StepLength { times: 1, ..length },
        })
    }

    /// Whether shorter steps change other pixels because rays run out of them.
    fn needs_more(&self, march: &March, length: StepLength) -> Option<bool> {
        let few = self.round(Round::Second)?;
        let [complete, limited] = [length, StepLength { times: 1, ..length }]
            .map(|length| self.with_steps(march, length));
        let (complete, limited) = (complete?, limited?);
        let (bench, supplier) = self.bench()?;
        let mut changed = 0;
        for frame in &few.frames {
            let [complete, limited] = [&complete, &limited].map(|code| {
                let sampled = bench.sample_costly(
                    code,
                    supplier,
                    &frame.instant,
                    (&frame.quads(), CONFIRMED),
                )?;
                Some(colors(code, &sampled))
            });
            let pairs = complete?.into_iter().zip(limited?);
            changed += pairs.filter(|(a, b)| is_apart(*a, *b)).count();
        }
        Some(changed as f64 > UNFINISHED * few.pixels as f64)
    }
}
