//! Static cost of functions: operations and loop iterations.

use super::calls::Calls;
use shaderlint_ir::{Loop, LoopId, Module, OpId, OpKind, Provenance, Region, Step};
use shaderlint_semantic::FunctionRef;
use shaderlint_syntax::ast::StmtId;
use shaderlint_text::SetAt;

/// Assumed trip count of a loop whose bound is unknown.
const UNKNOWN_ITERATIONS: f64 = 8.0;
/// Upper limit of all figures, so that nested loops do not overflow to infinity.
const MOST: f64 = 1e30;
/// Upper limit of the multiplied trip counts of nested loops.
const MOST_OFTEN: f64 = 1e15;

/// The static cost of each function in the worst case: no early exit, and the longer side of each
/// `if`.
#[derive(Default, Debug)]
pub struct Work {
    functions: Vec<Cost>,
    /// The initial values of globals.
    globals: Cost,
    /// By loop: iterations of innermost loops per execution.
    loops: Vec<f64>,
    /// By loop: the trip count, if it is known.
    counts: Vec<Option<u64>>,
}

/// The cost of a function.
#[derive(Clone, Copy, Default, Debug)]
struct Cost {
    /// Operations of one call, including the functions that it calls.
    operations: f64,
    /// Operations in its code after inlining all calls.
    size: f64,
    /// Iterations of innermost loops in one call.
    iterations: f64,
    /// Whether it contains a loop with an unknown trip count.
    is_guess: bool,
}

/// How often the parts of a loop are executed.
#[derive(Clone, Copy)]
struct LoopTimes {
    /// The body and the step.
    inside: f64,
    /// The test.
    tests: f64,
}

/// What [`Work::visit`] finds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CostPart {
    /// So many operations.
    Operations(u32),
    /// A call of a function.
    Call(FunctionRef),
}

/// A loop on the path to the most expensive code.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Nest {
    /// The loop statement.
    pub stmt: StmtId,
    /// Iterations per execution of the loop.
    pub iterations: u64,
}

/// The part of a region with most iterations.
#[derive(Clone, Copy)]
enum Heaviest {
    Loop(LoopId),
    Region(Region),
    Call(FunctionRef),
}

impl Work {
    /// Computes the cost of each function; `iterations` returns the trip count of a loop.
    pub fn of(module: &Module, calls: &Calls, iterations: impl Fn(&Loop) -> Option<u64>) -> Work {
        let mut work = Work {
            functions: vec![Cost::default(); module.functions.len()],
            globals: Cost::default(),
            loops: vec![0.0; module.loops.len()],
            counts: module.loops.iter().map(iterations).collect(),
        };
        for id in calls.graph.bottom_up() {
            let Some(body) = module.function(id).and_then(|f| f.body) else {
                continue;
            };
            let mut cost = Cost::default();
            cost.iterations = work.region(module, body, 1.0, &mut cost);
            work.functions.set_at(id.0 as usize, cost);
        }
        let mut globals = Cost::default();
        work.region(module, module.globals, 1.0, &mut globals);
        work.globals = globals;
        work
    }

    /// Operations of a shader that starts with a function, and whether it never takes more: all
    /// trip counts are known.
    pub fn of_shader(&self, entry: FunctionRef) -> (f64, bool) {
        let (own, globals) = (self.cost(entry), self.globals);
        let operations = f64::min(own.operations + globals.operations, MOST);
        (operations, !own.is_guess && !globals.is_guess)
    }

    fn cost(&self, function: FunctionRef) -> Cost {
        let found = self.functions.get(function.0 as usize);
        found.copied().unwrap_or_default()
    }

    /// Operations of one call of a function, including the functions that it calls.
    pub fn operations(&self, function: FunctionRef) -> f64 {
        self.cost(function).operations
    }

    /// Operations in the code of a function after inlining all calls.
    pub fn size(&self, function: FunctionRef) -> f64 {
        self.cost(function).size
    }

    /// Iterations of innermost loops in one call of a function. A loop with an unknown trip count
    /// counts as one iteration.
    pub fn iterations(&self, function: FunctionRef) -> f64 {
        self.cost(function).iterations
    }

    /// Adds the cost of a region that is executed `times` times. Returns its iterations.
    fn region(&mut self, module: &Module, region: Region, times: f64, cost: &mut Cost) -> f64 {
        let mut iterations = 0.0;
        for step in module.steps(region) {
            iterations += match *step {
                Step::Run(run) => run.ops().map(|op| self.op(module, op, times, cost)).sum(),
                Step::If {
                    then,
                    otherwise,
                    origin,
                    ..
                } => {
                    let own = f64::from(module.step_cost(step));
                    cost.add(own, own, times);
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
        f64::min(iterations, MOST)
    }

    fn looped(&mut self, module: &Module, id: LoopId, times: f64, cost: &mut Cost) -> f64 {
        let Some(&found) = module.looped(id) else {
            return 0.0;
        };
        let count = self.count(id);
        cost.is_guess |= count.is_none();
        let LoopTimes { inside, tests } = self.loop_times(id, times);
        let mut iterations = self.region(module, found.test, tests, cost);
        for region in [found.body, found.step] {
            iterations += self.region(module, region, inside, cost);
        }
        let iterations = f64::min(iterations.max(1.0) * count.unwrap_or(1) as f64, MOST);
        self.loops.set_at(id.0 as usize, iterations);
        iterations
    }

    /// How often the parts of a loop are executed that is executed `times` times.
    fn loop_times(&self, id: LoopId, times: f64) -> LoopTimes {
        let count = self.count(id).map_or(UNKNOWN_ITERATIONS, |t| t as f64);
        let inside = f64::min(times * count, MOST_OFTEN);
        LoopTimes {
            inside,
            // The test runs once more, when the loop ends.
            tests: f64::min(inside + times, MOST_OFTEN),
        }
    }

    /// Calls a function for each part of a region that is executed `times` times: what costs
    /// something, and calls.
    pub fn visit(
        &self,
        module: &Module,
        region: Region,
        times: f64,
        on: &mut impl FnMut(Provenance, CostPart, f64),
    ) {
        for step in module.steps(region) {
            for (at, cost) in module.step_costs(step) {
                on(at, CostPart::Operations(cost), times);
            }
            match *step {
                Step::Run(run) => {
                    for op in run.ops() {
                        if let OpKind::Call(callee, _) = module.op(op).kind {
                            on(module.provenance(op), CostPart::Call(callee), times);
                        }
                    }
                }
                Step::Loop(id) => {
                    let Some(&found) = module.looped(id) else {
                        continue;
                    };
                    let LoopTimes { inside, tests } = self.loop_times(id, times);
                    self.visit(module, found.test, tests, on);
                    self.visit(module, found.body, inside, on);
                    self.visit(module, found.step, inside, on);
                }
                _ => {
                    for inside in module.inside(step) {
                        self.visit(module, inside, times, on);
                    }
                }
            }
        }
    }

    fn count(&self, id: LoopId) -> Option<u64> {
        self.counts.get(id.0 as usize).copied().flatten()
    }

    /// Adds the cost of an operation. Returns the iterations in the function that it calls.
    fn op(&self, module: &Module, op: OpId, times: f64, cost: &mut Cost) -> f64 {
        if let OpKind::Call(callee, _) = module.op(op).kind {
            let callee = self.cost(callee);
            cost.add(callee.operations, callee.size, times);
            cost.is_guess |= callee.is_guess;
            return callee.iterations;
        }
        let own = f64::from(module.cost(op));
        cost.add(own, own, times);
        0.0
    }

    /// The nest of loops, outermost first, in which a call of `entry` spends most iterations.
    pub fn heaviest(&self, module: &Module, entry: FunctionRef) -> Vec<Nest> {
        let mut nests = Vec::new();
        let body = |f: FunctionRef| module.function(f).and_then(|f| f.body);
        let mut todo: Vec<Region> = body(entry).into_iter().collect();
        while !todo.is_empty() {
            let parts = todo.iter().flat_map(|r| module.steps(*r));
            let parts = parts.flat_map(|step| self.parts(module, step));
            let most = parts
                .filter(|(iterations, _)| *iterations > 0.0)
                .reduce(|most, next| if next.0 > most.0 { next } else { most });
            todo = match most.map(|(_, part)| part) {
                None => Vec::new(),
                Some(Heaviest::Region(region)) => vec![region],
                Some(Heaviest::Call(callee)) => body(callee).into_iter().collect(),
                Some(Heaviest::Loop(id)) => module.looped(id).map_or(Vec::new(), |found| {
                    nests.push(Nest {
                        stmt: found.stmt,
                        iterations: self.count(id).unwrap_or(1),
                    });
                    vec![found.test, found.body, found.step]
                }),
            };
        }
        nests
    }

    /// The loops, calls and regions in a step, with their iterations.
    fn parts(&self, module: &Module, step: &Step) -> Vec<(f64, Heaviest)> {
        let region =
            |region: Region| (self.iterations_in(module, region), Heaviest::Region(region));
        match *step {
            Step::Run(run) => {
                let calls = run.ops().filter_map(|op| match module.op(op).kind {
                    OpKind::Call(callee, _) => {
                        Some((self.iterations(callee), Heaviest::Call(callee)))
                    }
                    _ => None,
                });
                calls.collect()
            }
            Step::Loop(id) => vec![(self.iterations_of(id), Heaviest::Loop(id))],
            _ => module.inside(step).into_iter().map(region).collect(),
        }
    }

    fn iterations_of(&self, id: LoopId) -> f64 {
        self.loops.get(id.0 as usize).copied().unwrap_or(0.0)
    }

    fn iterations_in(&self, module: &Module, region: Region) -> f64 {
        let steps = module.steps(region).iter();
        let parts = steps.flat_map(|step| self.parts(module, step));
        parts.map(|(iterations, _)| iterations).sum()
    }
}

impl Cost {
    fn add(&mut self, operations: f64, size: f64, times: f64) {
        self.operations = (self.operations + operations * times).min(MOST);
        self.size = (self.size + size).min(MOST);
    }
}
