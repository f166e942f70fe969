//! Where a shader that marches decides whether a ray has hit something: the condition behind the loop
//! that hangs on what the loop found, and on whose one side the shader does most.

use crate::facts::Facts;
use crate::march::{March, MarchGoal};
use shaderlint_exec::Seen;
use shaderlint_flow::{Uniformity, Varying};
use shaderlint_ir::{Module, OpId, OpKind, Provenance, Region, Step};
use shaderlint_syntax::ast::StmtId;

/// A condition that tells rays that hit something from those that do not.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Hit {
    /// The condition.
    pub condition: OpId,
    /// The `if` or `?:`.
    pub origin: Provenance,
    /// What the condition is for rays that hit.
    pub when: bool,
}

impl Hit {
    /// How often rays were seen to hit, and to miss, where the condition stands in what ran.
    pub fn seen(&self, seen: &Seen) -> Option<(u64, u64)> {
        let branch = seen.branches.iter().find(|b| b.at == self.origin)?;
        Some(match self.when {
            true => (branch.taken, branch.skipped),
            false => (branch.skipped, branch.taken),
        })
    }
}

/// The conditions of a shader that tell rays that hit something from others.
pub(super) fn hits(facts: &Facts) -> Vec<Hit> {
    let module = facts.module();
    let marches = facts.marches().iter();
    let marches: Vec<&March> = marches.filter(|m| m.goal == MarchGoal::Picture).collect();
    let stmts: Vec<_> = marches.iter().map(|m| m.looped.stmt).collect();
    if stmts.is_empty() {
        return Vec::new();
    }
    let found = Uniformity::spread(module, |_| {
        let marching = module.loops.iter().filter(|l| stmts.contains(&l.stmt));
        let ops = marching.flat_map(|l| l.ops.ops());
        ops.map(Varying::Value).collect()
    });
    // Whoever calls the march decides, or whoever holds the loop, behind it.
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

/// The conditions of a region that hang on what a march found, those inside of loops left out.
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
        // Behind a side that returns only the other goes on.
        let behind = || work_of(facts, steps.get(at + 1..).unwrap_or(&[]));
        let does = |side: Region, other: Region| match returns(facts, other) {
            true => work(facts, side) + behind(),
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

/// A side that does less shows no surface.
const LEAST_WORK: f64 = 8.0;

/// How much a region does.
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

/// The share of the pixels whose rays have to end at once.
const STUCK: f64 = 0.98;

impl Facts<'_> {
    /// The marching loops that nearly all rays leave in their first turn, at every instant, and not
    /// since they go past everything.
    pub fn stuck_marches(&self) -> Vec<StmtId> {
        let marches = self.marches().iter();
        let picture = marches.filter(|m| m.goal == MarchGoal::Picture && m.looped.ends_early);
        let loops = picture.map(|m| m.looped.stmt);
        let is_stuck = |stmt: &StmtId| {
            self.is_seen(|trial| {
                let mut shots = trial.shots.iter();
                shots.all(|shot| {
                    let seen = &shot.sampled.seen;
                    self.stays(*stmt, seen) && !self.misses(seen)
                })
            })
        };
        loops.filter(is_stuck).collect()
    }

    /// Whether a condition that tells rays that hit something says that most do not.
    fn misses(&self, seen: &Seen) -> bool {
        let mut told = self.hits().iter().filter_map(|hit| hit.seen(seen));
        told.any(|(hits, misses)| misses > hits)
    }

    /// Whether nearly all pixels came to a loop, and left it in its first turn.
    fn stays(&self, stmt: StmtId, seen: &Seen) -> bool {
        let Some(looped) = self.loop_seen(seen, stmt) else {
            return false;
        };
        let once: u32 = looped.histogram.iter().take(2).sum();
        let reached = looped.pixels as f64 / seen.pixels.max(1) as f64;
        let left = f64::from(once) / looped.pixels.max(1) as f64;
        reached >= STUCK && left >= STUCK && looped.exhausted_pixels == 0
    }
}
