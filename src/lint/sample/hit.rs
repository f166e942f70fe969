//! Conditions that test whether a marched ray has hit something: the condition after the loop that
//! depends on the result of the loop, with most of the work on one side.

use crate::facts::Facts;
use crate::march::{March, MarchGoal};
use shaderlint_exec::Observations;
use shaderlint_flow::{Uniformity, Varying};
use shaderlint_ir::{Module, OpId, OpKind, Provenance, Region, Step};
use shaderlint_syntax::ast::StmtId;

/// A condition that separates rays that hit something from those that miss.
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

/// The hit conditions of a shader.
pub(super) fn hits(facts: &Facts) -> Vec<Hit> {
    let module = facts.module();
    let marches = facts.marches().iter();
    let marches: Vec<&March> = marches.filter(|m| m.goal == MarchGoal::Image).collect();
    let stmts: Vec<_> = marches.iter().map(|m| m.looped.stmt).collect();
    if stmts.is_empty() {
        return Vec::new();
    }
    let found = Uniformity::spread(module, |_| {
        let marching = module.loops.iter().filter(|l| stmts.contains(&l.stmt));
        let ops = marching.flat_map(|l| l.ops.ops());
        ops.map(Varying::Value).collect()
    });
    // The condition is in the function of the loop, or in a caller.
    let holds = |function| {
        marches
            .iter()
            .any(|march| march.looped.function == function)
    };
    let reaching = facts.calls().graph().reaching(holds);
    let mut hits = Vec::new();
    for (function, reaches) in module.functions.iter().zip(reaching) {
        if let Some(body) = function.body
            && reaches
        {
            conditions(facts, &found, body, &mut hits);
        }
    }
    hits
}

/// The conditions of a region that depend on the result of a march, without those in loops.
fn conditions(facts: &Facts, found: &Uniformity, region: Region, hits: &mut Vec<Hit>) {
    let steps = facts.module().steps(region);
    for (at, step) in steps.iter().enumerate() {
        let Step::If {
            condition,
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
        if found.varies(Varying::Value(condition)) && held.max(failed) >= LEAST_WORK {
            hits.push(Hit {
                condition,
                origin,
                when: held > failed,
            });
            continue;
        }
        conditions(facts, found, then, hits);
        conditions(facts, found, otherwise, hits);
    }
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

/// Smallest share of pixels whose rays end in the first iteration.
const STUCK: f64 = 0.98;

impl Facts<'_> {
    /// The marching loops that nearly all rays leave in the first iteration, at every instant, and not
    /// because they miss everything.
    pub fn stuck_marches(&self) -> Vec<StmtId> {
        let marches = self.marches().iter();
        let images = marches.filter(|m| m.goal == MarchGoal::Image && m.looped.ends_early);
        let loops = images.map(|m| m.looped.stmt);
        let is_stuck = |stmt: &StmtId| {
            self.is_seen(|sample_run| {
                let mut frames = sample_run.frames.iter();
                frames.all(|frame| {
                    let seen = &frame.sampled.seen;
                    self.stays(*stmt, seen) && !self.misses(seen)
                })
            })
        };
        loops.filter(is_stuck).collect()
    }

    /// Whether a hit condition shows more misses than hits.
    fn misses(&self, seen: &Observations) -> bool {
        let mut counts = self.hits().iter().filter_map(|hit| hit.seen(seen));
        counts.any(|(hits, misses)| misses > hits)
    }

    /// Whether nearly all pixels reached a loop and left it in the first iteration.
    fn stays(&self, stmt: StmtId, seen: &Observations) -> bool {
        let Some(looped) = self.loop_observation(seen, stmt) else {
            return false;
        };
        let once: u32 = looped.histogram.iter().take(2).sum();
        let reached = looped.pixels as f64 / seen.pixels.max(1) as f64;
        let left = f64::from(once) / looped.pixels.max(1) as f64;
        reached >= STUCK && left >= STUCK && looped.exhausted_pixels == 0
    }
}
