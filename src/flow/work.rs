//! How much the functions of a shader do: operations, and turns of loops.

use super::calls::Calls;
use shaderlint_ir::{Loop, LoopId, Module, OpId, OpKind, Provenance, Region, Step};
use shaderlint_semantic::FunctionRef;
use shaderlint_syntax::ast::StmtId;

/// How often a loop is taken to turn where the text does not tell.
const UNKNOWN_TURNS: f64 = 8.0;
/// Nests of loops multiply; a figure past all measure must not become infinite.
const MOST: f64 = 1e30;
/// Most turns that are multiplied.
const MOST_OFTEN: f64 = 1e15;

/// Work of a shader's functions. All figures are of the worst case: no early exit, the longer side
/// of each `if`.
#[derive(Default, Debug)]
pub struct Work {
    functions: Vec<Cost>,
    /// By loop: turns of innermost loops each time that it runs.
    loops: Vec<f64>,
    /// By loop: how often it turns, where the text tells.
    counts: Vec<Option<u64>>,
}

/// What a function does.
#[derive(Clone, Copy, Default, Debug)]
struct Cost {
    /// Operations of one call, the functions that it calls included.
    operations: f64,
    /// Operations in its text when every call is replaced by the callee's text.
    size: f64,
    /// Turns of innermost loops in one call.
    turns: f64,
}

/// A loop on the way to where a shader spends its time.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Nest {
    /// The loop.
    pub stmt: StmtId,
    /// How often it turns each time that it is reached.
    pub turns: u64,
}

/// Where most turns are spent in a region.
#[derive(Clone, Copy)]
enum Heaviest {
    Loop(LoopId),
    Region(Region),
    Call(FunctionRef),
}

impl Work {
    /// Adds up the work of a shader; `turns` tells how often a loop turns.
    pub fn of(module: &Module, calls: &Calls, turns: impl Fn(&Loop) -> Option<u64>) -> Work {
        let mut work = Work {
            functions: vec![Cost::default(); module.functions.len()],
            loops: vec![0.0; module.loops.len()],
            counts: module.loops.iter().map(turns).collect(),
        };
        for id in calls.graph().bottom_up() {
            let Some(body) = module.function(id).and_then(|f| f.body) else {
                continue;
            };
            let mut cost = Cost::default();
            cost.turns = work.region(module, body, 1.0, &mut cost);
            if let Some(slot) = work.functions.get_mut(id.0 as usize) {
                *slot = cost;
            }
        }
        work
    }

    fn cost(&self, function: FunctionRef) -> Cost {
        let found = self.functions.get(function.0 as usize);
        found.copied().unwrap_or_default()
    }

    /// Operations of one call of a function.
    pub fn operations(&self, function: FunctionRef) -> f64 {
        self.cost(function).operations
    }

    /// Operations in the text of a function once all calls are replaced by what they call.
    pub fn size(&self, function: FunctionRef) -> f64 {
        self.cost(function).size
    }

    /// Turns of innermost loops in one call of a function. A loop whose turns are not known counts
    /// as one.
    pub fn turns(&self, function: FunctionRef) -> f64 {
        self.cost(function).turns
    }

    /// Adds the operations of a region that runs so often, and gives its turns.
    fn region(&mut self, module: &Module, region: Region, times: f64, cost: &mut Cost) -> f64 {
        let mut turns = 0.0;
        for step in module.steps(region) {
            turns += match *step {
                Step::Run(run) => run.ops().map(|op| self.op(module, op, times, cost)).sum(),
                Step::If {
                    then,
                    otherwise,
                    origin,
                    ..
                } => {
                    // A choice between values is an operation; what it passes over runs too.
                    if matches!(origin, Provenance::Expr(_)) {
                        cost.add(1.0, 1.0, times);
                    }
                    let then = self.region(module, then, times, cost);
                    let otherwise = self.region(module, otherwise, times, cost);
                    match origin {
                        Provenance::Expr(_) => then + otherwise,
                        _ => then.max(otherwise),
                    }
                }
                Step::Loop(id) => self.looped(module, id, times, cost),
                Step::Switch(id) => {
                    let cases = module.cases_of(id).iter().map(|c| c.body);
                    cases.map(|c| self.region(module, c, times, cost)).sum()
                }
                _ => 0.0,
            };
        }
        f64::min(turns, MOST)
    }

    fn looped(&mut self, module: &Module, id: LoopId, times: f64, cost: &mut Cost) -> f64 {
        let Some(&found) = module.looped(id) else {
            return 0.0;
        };
        let count = self.count(id);
        let inside = f64::min(
            times * count.map_or(UNKNOWN_TURNS, |t| t as f64),
            MOST_OFTEN,
        );
        let mut turns = 0.0;
        for region in [found.test, found.body, found.step] {
            turns += self.region(module, region, inside, cost);
        }
        let turns = f64::min(turns.max(1.0) * count.unwrap_or(1) as f64, MOST);
        if let Some(slot) = self.loops.get_mut(id.0 as usize) {
            *slot = turns;
        }
        turns
    }

    fn count(&self, id: LoopId) -> Option<u64> {
        self.counts.get(id.0 as usize).copied().flatten()
    }

    /// Adds an operation, and gives the turns that it calls for.
    fn op(&self, module: &Module, op: OpId, times: f64, cost: &mut Cost) -> f64 {
        match module.op(op).kind {
            OpKind::Unary(..)
            | OpKind::Binary(..)
            | OpKind::MatrixProduct(..)
            | OpKind::Same { .. }
            | OpKind::Select { .. } => cost.add(1.0, 1.0, times),
            OpKind::Builtin(function, _) => cost.add(function.cost(), function.cost(), times),
            OpKind::Call(callee, _) => {
                let callee = self.cost(callee);
                cost.add(callee.operations, callee.size, times);
                return callee.turns;
            }
            _ => {}
        }
        0.0
    }

    /// The loops, outermost first, in which a call of a function spends most turns.
    pub fn heaviest(&self, module: &Module, entry: FunctionRef) -> Vec<Nest> {
        let mut nests = Vec::new();
        let body = |f: FunctionRef| module.function(f).and_then(|f| f.body);
        let mut todo: Vec<Region> = body(entry).into_iter().collect();
        while !todo.is_empty() {
            let parts = todo.iter().flat_map(|r| module.steps(*r));
            let parts = parts.flat_map(|step| self.parts(module, step));
            let most = parts
                .filter(|(turns, _)| *turns > 0.0)
                .reduce(|most, next| if next.0 > most.0 { next } else { most });
            todo = match most.map(|(_, part)| part) {
                None => Vec::new(),
                Some(Heaviest::Region(region)) => vec![region],
                Some(Heaviest::Call(callee)) => body(callee).into_iter().collect(),
                Some(Heaviest::Loop(id)) => module.looped(id).map_or(Vec::new(), |found| {
                    nests.push(Nest {
                        stmt: found.stmt,
                        turns: self.count(id).unwrap_or(1),
                    });
                    vec![found.test, found.body, found.step]
                }),
            };
        }
        nests
    }

    /// What may take turns in a step.
    fn parts(&self, module: &Module, step: &Step) -> Vec<(f64, Heaviest)> {
        let region = |region: Region| (self.turns_in(module, region), Heaviest::Region(region));
        match *step {
            Step::Run(run) => {
                let calls = run.ops().filter_map(|op| match module.op(op).kind {
                    OpKind::Call(callee, _) => Some((self.turns(callee), Heaviest::Call(callee))),
                    _ => None,
                });
                calls.collect()
            }
            Step::Loop(id) => vec![(self.turns_of(id), Heaviest::Loop(id))],
            _ => module.inside(step).into_iter().map(region).collect(),
        }
    }

    fn turns_of(&self, id: LoopId) -> f64 {
        self.loops.get(id.0 as usize).copied().unwrap_or(0.0)
    }

    fn turns_in(&self, module: &Module, region: Region) -> f64 {
        let steps = module.steps(region).iter();
        let parts = steps.flat_map(|step| self.parts(module, step));
        parts.map(|(turns, _)| turns).sum()
    }
}

impl Cost {
    fn add(&mut self, operations: f64, size: f64, times: f64) {
        self.operations = (self.operations + operations * times).min(MOST);
        self.size = (self.size + size).min(MOST);
    }
}
