//! What sampled rays hit: the outcome of marching loops, and the conditions after them.

use super::loops::{March, MarchGoal};
use crate::facts::Facts;
use crate::sample::{INSTANTS, Round, SIZE, SampleFrame, SampleRun};
use shaderlint_exec::{Observations, Watch};
use shaderlint_flow::{HitTest, Uniformity, Varying};
use shaderlint_ir::{Module, OpId, OpKind, Provenance, Region, Step};
use shaderlint_semantic::VariableId;

/// A condition after a marching loop that separates rays that hit something from those that miss: it
/// depends on the result of the loop, with most of the work on one side.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Hit {
    /// The operation that computes the condition.
    pub condition: OpId,
    /// The `if` or `?:`.
    pub origin: Provenance,
    /// The value of the condition for rays that hit.
    pub when: bool,
}

impl Hit {
    /// Number of sampled hits and misses; `None` if the condition did not run.
    pub fn seen(&self, seen: &Observations) -> Option<(u64, u64)> {
        let branch = seen.branches.iter().find(|b| b.at == self.origin)?;
        Some(match self.when {
            true => (branch.taken, branch.skipped),
            false => (branch.skipped, branch.taken),
        })
    }
}

/// The outcome of a marching loop.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct RayCounts {
    /// Number of rays.
    pub rays: u64,
    /// Number of tests for a hit.
    pub tests: u64,
    /// Number of hits.
    pub hits: u64,
}

/// A marching loop with the outcome of sampled rays from the camera.
#[derive(Clone, Debug)]
pub struct MarchOutcome {
    /// The marching loop.
    pub march: March,
    /// The condition that ends it at a hit.
    pub test: HitTest,
    /// The sampled rays of the exact run.
    pub counts: RayCounts,
}

/// The hit conditions of a shader.
fn hits(facts: &Facts) -> Vec<Hit> {
    let module = facts.module();
    let marches: Vec<(&March, HitTest)> = facts.camera_marches().collect();
    let stmts: Vec<_> = marches.iter().map(|(m, _)| m.looped.stmt).collect();
    if stmts.is_empty() {
        return Vec::new();
    }
    let found = Uniformity::spread(module, |_| {
        let marching = module.loops.iter().filter(|l| stmts.contains(&l.stmt));
        let ops = marching.flat_map(|l| l.ops.ops());
        ops.map(Varying::Value).collect()
    });
    // The condition is in the function of the loop, or in a caller.
    let holds = |function| marches.iter().any(|(m, _)| m.looped.function == function);
    let reaching = facts.calls().graph.reaching(holds);
    let mut hits = Vec::new();
    for (function, reaches) in module.functions.iter().zip(reaching) {
        if let Some(body) = function.body
            && reaches
        {
            hits.extend(condition(facts, &found, body));
        }
    }
    hits
}

/// The first condition of a region that depends on the result of a march, without those in loops.
/// Later ones may ask what was hit.
fn condition(facts: &Facts, found: &Uniformity, region: Region) -> Option<Hit> {
    let steps = facts.module().steps(region);
    for (at, step) in steps.iter().enumerate() {
        let Step::If {
            condition: op,
            then,
            otherwise,
            origin,
        } = *step
        else {
            continue;
        };
        // If one side returns, only the other continues.
        let after = || work_of(facts, steps.get(at + 1..).unwrap_or(&[]));
        let does = |side: Region, other: Region| match returns(facts, other) {
            true => work(facts, side) + after(),
            false => work(facts, side),
        };
        let (held, failed) = (does(then, otherwise), does(otherwise, then));
        if found.varies(Varying::Value(op)) && held.max(failed) >= LEAST_WORK {
            return Some(Hit {
                condition: op,
                origin,
                when: held > failed,
            });
        }
        let inside = condition(facts, found, then).or_else(|| condition(facts, found, otherwise));
        if inside.is_some() {
            return inside;
        }
    }
    None
}

fn returns(facts: &Facts, region: Region) -> bool {
    let last = facts.module().steps(region).last();
    matches!(last, Some(Step::Return(..)))
}

/// Least cost of the side that shades a surface.
const LEAST_WORK: f64 = 8.0;

/// Cost of a region, in operations.
fn work(facts: &Facts, region: Region) -> f64 {
    work_of(facts, facts.module().steps(region))
}

fn work_of(facts: &Facts, steps: &[Step]) -> f64 {
    let module = facts.module();
    let runs = module.steps_in(steps).filter_map(|step| match *step {
        Step::Run(run) => Some(run),
        _ => None,
    });
    let ops = runs.flat_map(|run| run.ops());
    ops.map(|op| operation(facts, module, op)).sum()
}

fn operation(facts: &Facts, module: &Module, op: OpId) -> f64 {
    match module.op(op).kind {
        OpKind::Call(callee, _) => facts.work().operations(callee),
        OpKind::Const(_) | OpKind::Load(_) | OpKind::Store(..) => 0.0,
        _ => 1.0,
    }
}

/// Smallest share of rays that end at their first step, and of pixels with such a ray.
const STUCK: f64 = 0.98;

/// The same share in a few pixels.
const LIKELY: f64 = 0.9;

/// Share of all steps from which rays count as out of steps.
const TIRED: f64 = 0.9;
/// Fewest steps of a loop that can run out of them.
const LEAST_STEPS: u64 = 10;

impl MarchOutcome {
    /// Whether nearly all rays run out of steps, although they could have ended beyond the scene: they
    /// may be about to hit something.
    pub fn is_exhausted(&self) -> bool {
        let RayCounts { rays, tests, .. } = self.counts;
        let steps = self.march.looped.bound.iterations();
        let steps = steps.filter(|steps| *steps >= LEAST_STEPS && self.march.ray.ends_far);
        steps.is_some_and(|steps| tests as f64 > TIRED * steps as f64 * rays as f64)
    }
}

impl Facts<'_> {
    /// The conditions that test whether a ray has hit something.
    pub fn hits(&self) -> &[Hit] {
        self.samples.hits.get_or_init(|| hits(self))
    }

    /// The marching loops of rays from the camera, with the condition that ends them at a hit.
    pub fn camera_marches(&self) -> impl Iterator<Item = (&March, HitTest)> {
        let marches = self.marches().iter();
        let images = marches.filter(|m| m.goal == MarchGoal::Image && m.ray.start.is_some());
        images.filter_map(|m| Some((m, m.ray.hit?)))
    }

    /// The marching loops whose rays from the camera hit something at their first step, nearly all and
    /// at every instant.
    pub fn stuck_marches(&self) -> &[MarchOutcome] {
        self.samples.stuck.get_or_init(|| {
            // The first pixels rule most loops out.
            let mut likely = self.camera_marches().filter(|(march, _)| {
                let stays = |sample_run: &SampleRun| self.stays(march, &sample_run.seen);
                self.round(Round::First).is_some_and(stays)
            });
            match likely.next().is_some() {
                true => self.outcomes(|counts, march, pixels| {
                    let tests = counts.rays * if march.is_late { 2 } else { 1 };
                    let share = |part: u64, all: u64| part as f64 / all.max(1) as f64;
                    share(counts.rays, pixels) >= STUCK
                        && share(counts.hits, counts.rays) >= STUCK
                        && share(tests, counts.tests) >= STUCK
                }),
                false => Vec::new(),
            }
        })
    }

    /// The marching loops whose rays from the camera never hit anything, if that holds for all of them.
    pub fn missing_marches(&self) -> Vec<MarchOutcome> {
        let mut all = self.camera_marches();
        let is_glow = all.any(|(march, _)| march.ray.accumulates);
        let number = self.camera_marches().count();
        if is_glow || number == 0 || self.may_hit() {
            return Vec::new();
        }
        let found = self.outcomes(|counts, _, pixels| {
            counts.hits == 0 && counts.tests > 0 && counts.rays as f64 >= STUCK * pixels as f64
        });
        match found.len() == number {
            true => found,
            false => Vec::new(),
        }
    }

    /// Whether a few rays hit something.
    fn may_hit(&self) -> bool {
        let first = self.round(Round::First);
        let hit = |(_, test): (&March, HitTest)| {
            let branch = self.branch(&test);
            let observed = first?.seen.branches.iter().find(|b| Some(b.at) == branch)?;
            let hits = if test.truth {
                observed.taken
            } else {
                observed.skipped
            };
            (hits > 0).then_some(())
        };
        first.is_none()
            || self.camera_marches().any(|march| hit(march).is_some())
            || self.compares_hit()
    }

    /// The `if` that branches on the comparison of a hit test.
    fn branch(&self, test: &HitTest) -> Option<Provenance> {
        let module = self.module();
        let bodies = module.functions.iter().filter_map(|f| f.body);
        let mut steps = bodies.flat_map(|body| module.steps_in(module.steps(body)));
        steps.find_map(|step| match *step {
            Step::If {
                condition, origin, ..
            } if condition == test.condition => Some(origin),
            _ => None,
        })
    }

    /// Whether a comparison of a few rays ends in a hit.
    fn compares_hit(&self) -> bool {
        self.compared().is_none_or(|sample_run| {
            let mut marches = self.camera_marches();
            marches.any(|(_, test)| {
                self.tested(&test, &sample_run.seen)
                    .is_none_or(|(_, hits)| hits > 0)
            })
        })
    }

    /// The marching loops for whose rays a test holds at every instant, on all GPU profiles and at later
    /// instants. Nothing is known of cameras that move without bounds.
    fn outcomes(&self, holds: impl Fn(RayCounts, HitTest, u64) -> bool) -> Vec<MarchOutcome> {
        let marches: Vec<(&March, HitTest)> = self
            .camera_marches()
            .filter(|(march, test)| self.is_known(test.condition) && self.stays_near(march))
            .collect();
        if marches.is_empty() {
            return Vec::new();
        }
        let mut runs: Vec<SampleRun> = self.smaller_runs(Watch::Comparisons).flatten().collect();
        let Some(later) = self.later_run(Watch::Comparisons) else {
            return Vec::new();
        };
        runs.push(later);
        let outcome = |(march, test): (&March, HitTest)| {
            let counts = |seen: &Observations| self.counts(march, &test, seen);
            let is_one = |frame: &SampleFrame| {
                let seen = &frame.sampled.seen;
                counts(seen).is_some_and(|counts| holds(counts, test, seen.pixels))
            };
            let mut frames = runs.iter().flat_map(|sample_run| &sample_run.frames);
            frames.all(is_one).then_some(())?;
            Some(MarchOutcome {
                march: march.clone(),
                test,
                counts: counts(&runs.first()?.seen)?,
            })
        };
        marches.into_iter().filter_map(outcome).collect()
    }

    /// The outcome of a marching loop; `None` if it did not run.
    fn counts(&self, march: &March, test: &HitTest, seen: &Observations) -> Option<RayCounts> {
        let rays = self.loop_observation(seen, march.looped.stmt)?.entries;
        let (tests, hits) = self.tested(test, seen)?;
        Some(RayCounts { rays, tests, hits })
    }

    /// How often a hit was tested for, and how often there was one; `None` if that was not observed.
    fn tested(&self, test: &HitTest, seen: &Observations) -> Option<(u64, u64)> {
        let (held, failed) = match test.branch {
            _ if self.is_compared(test) => {
                let compared = seen.compared.iter().find(|c| c.op == test.condition);
                compared.map_or((0, 0), |c| (c.held, c.failed))
            }
            Some(at) => {
                let branch = seen.branches.iter().find(|b| b.at == at);
                branch.map_or((0, 0), |b| (b.taken, b.skipped))
            }
            None => return None,
        };
        let hits = if test.truth { held } else { failed };
        Some((held + failed, hits))
    }

    fn is_compared(&self, test: &HitTest) -> bool {
        let kind = self.module().op(test.condition).kind;
        matches!(kind, OpKind::Binary(binary, ..) if binary.compares())
    }

    /// Whether the rays of a loop start at a position that does not move, or not far.
    fn stays_near(&self, march: &March) -> bool {
        let Some(start) = &march.ray.start else {
            return false;
        };
        let is_near = |&(op, lane): &(OpId, u32)| {
            !self.may_move(op) || self.ranges().lane(op, lane).is_finite()
        };
        start.iter().all(is_near)
    }

    /// Whether a value may differ between instants.
    pub fn may_move(&self, op: OpId) -> bool {
        self.moving().varies(Varying::Value(op))
    }

    /// What may differ between instants.
    fn moving(&self) -> &Uniformity {
        self.samples.moving.get_or_init(|| {
            let names: Vec<String> = self.changing_uniforms();
            Uniformity::spread(self.module(), |_| {
                let variables = (0..).map(VariableId).zip(&self.program().variables);
                let text = |v: &shaderlint_semantic::Variable| self.program().names.text(v.name);
                let own = variables.filter(|(_, v)| names.iter().any(|name| name == text(v)));
                own.map(|(id, _)| Varying::Variable(id)).collect()
            })
        })
    }

    /// The uniforms whose values differ between instants.
    fn changing_uniforms(&self) -> Vec<String> {
        let Some((bench, supplier)) = self.bench() else {
            return Vec::new();
        };
        let code = bench.watched();
        let draws = INSTANTS.map(|instant| supplier.draw(code, SIZE, &instant));
        let Some((first, others)) = draws.split_first() else {
            return Vec::new();
        };
        let changed = others.iter().flat_map(|other| first.differences(other));
        changed.map(|uniform| uniform.name.clone()).collect()
    }

    /// Whether nearly all pixels reached a loop and left it within two iterations.
    fn stays(&self, march: &March, seen: &Observations) -> bool {
        let Some(looped) = self.loop_observation(seen, march.looped.stmt) else {
            return false;
        };
        let once: u32 = looped.histogram.iter().take(3).sum();
        let reached = looped.pixels as f64 / seen.pixels.max(1) as f64;
        let left = f64::from(once) / looped.pixels.max(1) as f64;
        reached >= LIKELY && left >= LIKELY
    }
}
