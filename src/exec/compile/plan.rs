//! Analyses functions before code generation: lifetimes of values, variables that are aliases of
//! values, and stores that may ignore the execution mask because no inactive lane needs the old
//! value.
//!
//! A clock ticks at every operation and step. Code generation advances the same clock, so that
//! lifetimes planned in ticks end at the right instruction.

use rustc_hash::FxHashMap;
use shaderlint_ir::{
    Function, Loop, LoopId, Module, OpId, OpKind, PlaceId, Provenance, Region, Root, Step, Switch,
    Visit,
};
use shaderlint_semantic::BuiltinId as B;
use shaderlint_semantic::{FunctionRef, VariableId};
use shaderlint_syntax::ast::StmtId;
use shaderlint_text::SetAt;

/// A pseudo-function for the global initialisers.
pub(super) const GLOBALS: FunctionRef = FunctionRef(u32::MAX);

/// What may be released at a tick.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Releasable {
    /// The value of an operation.
    Value(OpId),
    /// The registers of a variable.
    Variable(VariableId),
}

/// The analysis of all functions that run.
#[derive(Default, Debug)]
pub(super) struct CompilePlan {
    /// By operation: the tick until which its registers must not change.
    stays: Vec<u32>,
    /// By operation: the tick of its last use.
    last: Vec<u32>,
    /// By operation: its own tick.
    made: Vec<u32>,
    /// By store: whether it may write all lanes instead of the active ones.
    writes_all: Vec<bool>,
    variables: Vec<About>,
    /// By function: what may be released, ordered by tick.
    ends: FxHashMap<FunctionRef, Vec<(u32, Releasable)>>,
    /// By function: whether it has early returns.
    leaves_early: Vec<bool>,
    /// By function: the tick before its first operation.
    starts: FxHashMap<FunctionRef, u32>,
    /// By variable: the ticks of its writes.
    writes: FxHashMap<VariableId, Vec<u32>>,
}

/// The analysis of a variable.
#[derive(Clone, Copy, Default, Debug)]
struct About {
    stores: u32,
    /// The value of its declaration, if that is the only store.
    value: Option<OpId>,
    /// Whether there is a store other than a declaration of the whole variable.
    is_changed: bool,
    /// The region that declares it, and the tick of the declaration.
    home: Option<(u32, u32)>,
    last: u32,
}

/// An enclosing loop.
struct OpenConstruct {
    start: u32,
    pending: Vec<Releasable>,
}

struct Planner<'m> {
    module: &'m Module,
    plan: CompilePlan,
    clock: u32,
    around: Vec<OpenConstruct>,
    /// The operations of the current function, and its variables.
    ops: Vec<OpId>,
    met: Vec<VariableId>,
    /// The enclosing regions, innermost last. The loop is set for the parts of a loop that start
    /// every iteration, so that a store may write all lanes of variables declared around the loop.
    regions: Vec<(u32, Option<LoopId>)>,
    next_region: u32,
    /// Stores that may write all lanes if the variable is not read after the loop.
    loose: Vec<(OpId, VariableId, LoopId)>,
    /// By loop: its last tick.
    loop_ends: FxHashMap<LoopId, u32>,
    /// By function: the globals and outputs that it writes, directly or indirectly.
    effects: FxHashMap<FunctionRef, Vec<VariableId>>,
}

/// Analyses the functions that run, given in post-order.
pub(super) fn plan(module: &Module, functions: &[FunctionRef]) -> CompilePlan {
    let ops = module.ops.len();
    let mut planner = Planner {
        module,
        plan: CompilePlan {
            stays: vec![0; ops],
            last: vec![0; ops],
            made: vec![0; ops],
            writes_all: vec![false; ops],
            variables: vec![About::default(); module.variables.len()],
            leaves_early: vec![false; module.functions.len()],
            ..CompilePlan::default()
        },
        clock: 0,
        around: Vec::new(),
        ops: Vec::new(),
        met: Vec::new(),
        regions: Vec::new(),
        next_region: 0,
        loose: Vec::new(),
        loop_ends: FxHashMap::default(),
        effects: FxHashMap::default(),
    };
    planner.stores(functions);
    planner.globals();
    for &function in functions {
        planner.function(function);
    }
    planner.plan
}

impl CompilePlan {
    /// The value that a variable is an alias of.
    pub fn value_of(&self, variable: VariableId) -> Option<OpId> {
        let about = self.variables.get(variable.0 as usize)?;
        about
            .value
            .filter(|_| about.stores == 1 && !about.is_changed)
    }

    /// Whether a variable is only an alias: of the value in its declaration, or of an argument.
    pub fn is_name(&self, module: &Module, variable: VariableId) -> bool {
        let root = module.variable(variable).map(|v| v.root);
        match root {
            Some(Root::Local | Root::Global) => self.value_of(variable).is_some(),
            Some(Root::Parameter | Root::ParameterInout) => self.is_never_written(variable),
            _ => false,
        }
    }

    /// Whether a value is dead after a tick.
    pub fn is_last_use(&self, value: OpId, tick: u32) -> bool {
        at(&self.last, value) <= tick
    }

    /// Whether a variable is never written to.
    pub fn is_never_written(&self, variable: VariableId) -> bool {
        let about = self.variables.get(variable.0 as usize);
        about.is_some_and(|v| v.stores == 0)
    }

    /// What may be released in a function, ordered by tick.
    pub fn ends(&self, function: FunctionRef) -> &[(u32, Releasable)] {
        self.ends.get(&function).map_or(&[], |e| e)
    }

    /// Whether a function has early returns.
    pub fn leaves_early(&self, function: FunctionRef) -> bool {
        self.leaves_early.get(function.0 as usize) == Some(&true)
    }

    /// The tick before the first operation of a function.
    pub fn start(&self, function: FunctionRef) -> u32 {
        self.starts.get(&function).copied().unwrap_or(0)
    }

    /// Whether a store may write all lanes instead of the active ones.
    pub fn writes_all(&self, op: OpId) -> bool {
        self.writes_all.get(op.0 as usize) == Some(&true)
    }

    /// Whether a variable is not written to between a load and the last use of the loaded value.
    pub fn stays(&self, load: OpId, variable: VariableId) -> bool {
        let at = |all: &[u32]| all.get(load.0 as usize).copied().unwrap_or(u32::MAX);
        let (from, to) = (at(&self.made), at(&self.stays).max(at(&self.last)));
        let Some(writes) = self.writes.get(&variable) else {
            return true;
        };
        let next = writes.partition_point(|w| *w <= from);
        writes.get(next).is_none_or(|w| *w > to)
    }
}

/// Whether an operation only aliases the registers of its operands.
fn is_alias(kind: OpKind) -> bool {
    matches!(
        kind,
        OpKind::Swizzle(..)
            | OpKind::Splat(_)
            | OpKind::Compose(_)
            | OpKind::Extract(..)
            | OpKind::Convert(_)
            | OpKind::Builtin(B::Transpose | B::IntBitsToFloat | B::UintBitsToFloat, _)
    )
}

impl<'m> Visit<'m> for Planner<'m> {
    type Out = ();

    fn module(&self) -> &'m Module {
        self.module
    }

    fn region(&mut self, region: Region) {
        self.part(region, None);
    }

    fn op(&mut self, id: OpId) {
        self.clock += 1;
        set(&mut self.plan.made, id, self.clock);
        self.ops.push(id);
        let module = self.module;
        module.each_operand(id, |operand| self.used(operand));
        match module.op(id).kind {
            OpKind::Load(place) => self.touched(module.place(place).variable),
            OpKind::Store(place, _) => self.stored(id, place),
            OpKind::Call(callee, _) => {
                for variable in self.effects.get(&callee).into_iter().flatten() {
                    let writes = self.plan.writes.entry(*variable).or_default();
                    writes.push(self.clock);
                }
            }
            _ => {}
        }
    }

    fn branch(&mut self, condition: OpId, sides: [Region; 2], _: Provenance) {
        self.clock += 1;
        self.used(condition);
        sides.into_iter().for_each(|side| self.region(side));
    }

    fn looped(&mut self, id: LoopId, l: &'m Loop) {
        self.clock += 1;
        self.around.push(OpenConstruct {
            start: self.clock,
            pending: Vec::new(),
        });
        let module = self.module;
        let body = (!continues(module, module.steps(l.body))).then_some(id);
        if l.tests_first {
            self.test(id, l.test, l.condition);
            self.part(l.body, body);
            self.part(l.step, Some(id));
        } else {
            self.part(l.body, body);
            self.test(id, l.test, l.condition);
        }
        self.clock += 1;
        self.loop_ends.insert(id, self.clock);
        for held in self.around.pop().map_or(Vec::new(), |a| a.pending) {
            match held {
                Releasable::Value(op) => raise(&mut self.plan.last, op, self.clock),
                Releasable::Variable(variable) => {
                    if let Some(about) = self.plan.variables.get_mut(variable.0 as usize) {
                        about.last = about.last.max(self.clock);
                    }
                }
            }
        }
    }

    fn switch(&mut self, switch: &'m Switch) {
        self.clock += 1;
        self.used(switch.selector);
        for case in self.module.cases(switch) {
            self.region(case.body);
        }
    }

    fn breaks(&mut self, _: StmtId) {
        self.clock += 1;
    }

    fn continues(&mut self, _: StmtId) {
        self.clock += 1;
    }

    fn returns(&mut self, value: Option<OpId>, _: StmtId) {
        self.clock += 1;
        value.into_iter().for_each(|v| self.used(v));
    }

    fn discards(&mut self, _: StmtId) {
        self.clock += 1;
    }
}

impl Planner<'_> {
    /// Counts the stores in the functions that run.
    fn stores(&mut self, functions: &[FunctionRef]) {
        let module = self.module;
        let mut runs = Vec::new();
        let globals = module.steps(module.globals);
        runs.extend(globals.iter().filter_map(|s| match s {
            Step::Run(run) => Some(*run),
            _ => None,
        }));
        let bodies = functions.iter().filter_map(|f| module.function(*f));
        runs.extend(bodies.map(|f| f.ops));
        for id in runs.into_iter().flat_map(|r| r.ops()) {
            if let OpKind::Store(place, value) = module.op(id).kind {
                self.count_store(id, place, value);
            }
        }
    }

    fn count_store(&mut self, id: OpId, place: PlaceId, value: OpId) {
        let module = self.module;
        let place = module.place(place);
        let is_complete = module.path(place).is_empty();
        let declares = matches!(module.provenance(id), Provenance::Declaration(_));
        let root = module.variable(place.variable).map(|v| v.root);
        let is_name = matches!(root, Some(Root::Local | Root::Global));
        if let Some(about) = self.plan.variables.get_mut(place.variable.0 as usize) {
            about.stores += 1;
            about.is_changed |= !is_complete || !declares || !is_name;
            about.value = about.value.or(Some(value));
        }
    }

    fn globals(&mut self) {
        let body = self.module.globals;
        self.walk(GLOBALS, body);
        // Global values live as long as the shader runs.
        for step in self.module.steps(body) {
            let Step::Run(run) = step else { continue };
            for op in run.ops() {
                set(&mut self.plan.stays, op, u32::MAX);
            }
        }
    }

    fn function(&mut self, id: FunctionRef) {
        let Some(function) = self.module.function(id).copied() else {
            return;
        };
        let Some(body) = function.body else {
            return;
        };
        self.effects_of(id, &function);
        let home = (self.next_region, self.clock);
        let leaves = leaves(self.module, self.module.steps(body));
        for variable in self.module.parameters(&function) {
            let root = self.module.variable(*variable).map(|v| v.root);
            let is_given_back = matches!(root, Some(Root::ParameterOut | Root::ParameterInout));
            if let Some(about) = self.plan.variables.get_mut(variable.0 as usize) {
                // Lanes that return before a write must keep the old value.
                about.home = Some(home).filter(|_| !(leaves && is_given_back));
                about.last = self.clock;
                self.met.push(*variable);
            }
        }
        self.walk(id, body);
        self.plan.leaves_early.set_at(id.0 as usize, leaves);
    }

    fn effects_of(&mut self, id: FunctionRef, function: &Function) {
        let module = self.module;
        let mut written = Vec::new();
        for op in function.ops.ops() {
            match module.op(op).kind {
                OpKind::Store(place, _) => {
                    let variable = module.place(place).variable;
                    if module
                        .variable(variable)
                        .is_some_and(|v| v.function.is_none())
                    {
                        written.push(variable);
                    }
                }
                OpKind::Call(callee, _) => {
                    written.extend(self.effects.get(&callee).into_iter().flatten());
                }
                _ => {}
            }
        }
        written.sort_unstable();
        written.dedup();
        self.effects.insert(id, written);
    }

    /// Walks a body, then resolves what is only known at its end.
    fn walk(&mut self, function: FunctionRef, body: Region) {
        self.plan.starts.insert(function, self.clock);
        self.region(body);
        self.clock += 1;
        let known = self.module.function(function);
        for variable in known.map_or(&[][..], |f| self.module.parameters(f)) {
            let root = self.module.variable(*variable).map(|v| v.root);
            if matches!(root, Some(Root::ParameterOut | Root::ParameterInout)) {
                self.touched(*variable);
            }
        }
        let plan = &mut self.plan;
        for (store, variable, id) in self.loose.drain(..) {
            let last = plan.variables.get(variable.0 as usize).map(|v| v.last);
            if last <= self.loop_ends.get(&id).copied() {
                set_flag(&mut plan.writes_all, store);
            }
        }
        let mut ends = Vec::with_capacity(self.ops.len() + self.met.len());
        for op in self.ops.drain(..).rev() {
            let last = at(&plan.last, op).max(at(&plan.made, op));
            ends.push((last, Releasable::Value(op)));
            plan.lengthen(self.module, op, last);
        }
        for variable in self.met.drain(..) {
            let last = plan
                .variables
                .get(variable.0 as usize)
                .map_or(0, |v| v.last);
            ends.push((last, Releasable::Variable(variable)));
        }
        ends.sort_unstable();
        ends.dedup();
        plan.ends.insert(function, ends);
    }

    /// Walks a region. `part` is the loop if every iteration starts with this region.
    fn part(&mut self, region: Region, part: Option<LoopId>) {
        self.regions.push((self.next_region, part));
        self.next_region += 1;
        for step in self.module.steps(region) {
            self.step(step);
        }
        self.regions.pop();
    }

    fn test(&mut self, id: LoopId, test: Region, condition: Option<OpId>) {
        self.part(test, Some(id));
        self.clock += 1;
        condition.into_iter().for_each(|c| self.used(c));
    }

    /// Records a use of a value at this tick. Values made before the enclosing loop live until its
    /// end.
    fn used(&mut self, op: OpId) {
        raise(&mut self.plan.last, op, self.clock);
        let made = at(&self.plan.made, op);
        if let Some(around) = self.around.iter_mut().find(|a| made < a.start) {
            around.pending.push(Releasable::Value(op));
        }
    }

    /// Records a read or write of a variable at this tick.
    fn touched(&mut self, variable: VariableId) {
        let Some(about) = self.plan.variables.get_mut(variable.0 as usize) else {
            return;
        };
        about.last = about.last.max(self.clock);
        let Some((_, made)) = about.home else {
            return;
        };
        if let Some(around) = self.around.iter_mut().find(|a| made < a.start) {
            around.pending.push(Releasable::Variable(variable));
        }
    }

    fn stored(&mut self, id: OpId, place: PlaceId) {
        let module = self.module;
        let place = module.place(place);
        let variable = place.variable;
        let root = module.variable(variable).map(|v| v.root);
        self.plan
            .writes
            .entry(variable)
            .or_default()
            .push(self.clock);
        let Some(&(region, part)) = self.regions.last() else {
            return;
        };
        let outer = self.regions.iter().rev().nth(1).map(|r| r.0);
        let declares = matches!(module.provenance(id), Provenance::Declaration(_));
        let Some(about) = self.plan.variables.get_mut(variable.0 as usize) else {
            return;
        };
        match (root, about.home) {
            (Some(Root::Local), _) if declares => about.home = Some((region, self.clock)),
            (Some(Root::Temporary), None) => about.home = Some((region, self.clock)),
            _ => {}
        }
        match (about.home, part) {
            (Some((home, _)), _) if home == region => set_flag(&mut self.plan.writes_all, id),
            (Some((home, _)), Some(around)) if Some(home) == outer => {
                self.loose.push((id, variable, around));
            }
            _ => {}
        }
        if matches!(root, Some(Root::Local | Root::Temporary)) {
            self.met.push(variable);
        }
        self.touched(variable);
    }
}

impl CompilePlan {
    /// Extends the lifetime of values for as long as an alias of them is needed.
    fn lengthen(&mut self, module: &Module, op: OpId, last: u32) {
        let until = at(&self.stays, op).max(last);
        let kind = module.op(op).kind;
        match kind {
            OpKind::Load(place) => {
                let variable = module.place(place).variable;
                let last = self
                    .variables
                    .get(variable.0 as usize)
                    .map_or(0, |v| v.last);
                if let Some(value) = self.value_of(variable) {
                    raise(&mut self.stays, value, until.max(last));
                }
            }
            _ if is_alias(kind) => {
                module.each_operand(op, |operand| raise(&mut self.stays, operand, until));
            }
            _ => {}
        }
    }
}

/// Whether the steps contain a `continue` of the enclosing loop.
fn continues(module: &Module, steps: &[Step]) -> bool {
    steps.iter().any(|step| match step {
        Step::Continue(_) => true,
        Step::Loop(_) => false,
        _ => {
            let mut inside = module.inside(step).into_iter();
            inside.any(|region| continues(module, module.steps(region)))
        }
    })
}

/// Whether there is a `return` other than as the last step.
fn leaves(module: &Module, steps: &[Step]) -> bool {
    let early = match steps {
        [early @ .., Step::Return(..)] => early,
        all => all,
    };
    let mut inside = module.steps_in(early);
    inside.any(|step| matches!(step, Step::Return(..)))
}

fn at(ticks: &[u32], op: OpId) -> u32 {
    ticks.get(op.0 as usize).copied().unwrap_or(0)
}

fn set(ticks: &mut [u32], op: OpId, tick: u32) {
    ticks.set_at(op.0 as usize, tick);
}

fn raise(ticks: &mut [u32], op: OpId, tick: u32) {
    set(ticks, op, at(ticks, op).max(tick));
}

fn set_flag(flags: &mut [bool], op: OpId) {
    flags.set_at(op.0 as usize, true);
}
