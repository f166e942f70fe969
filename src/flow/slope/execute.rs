//! Executes a function symbolically: its result as nodes.
//!
//! Calls are inlined, loops are unrolled, and both sides of a branch are executed. What follows a jump
//! is executed under the condition that it was not taken.

use super::form::{ScalarFunction, ScalarId};
use super::interval::RealSpan;
use super::node::Scalars;
use super::verdict::{Obstacle, SlopeObstacle};
use rustc_hash::FxHashMap;
use shaderlint_ir::{
    Access, CaseLabel, Layout, Loop, Module, OpId, OpKind, Place, PlaceId, Region, Root, Run, Step,
    Switch, Variable,
};
use shaderlint_semantic::{FunctionRef, Program, Type, Value, VariableId};

/// Most operations that are executed.
const MAX_OPS: u32 = 120_000;
/// Most iterations of a loop.
const MAX_ITERATIONS: u32 = 256;
/// Most nested calls.
const MAX_DEPTH: u32 = 24;
/// Most scalars of a variable.
const MAX_VALUES: u32 = 1024;

/// The scalars of a value.
pub(super) type ScalarValues = Vec<ScalarId>;

/// An execution.
pub(super) struct SymbolicExecution<'a> {
    pub module: &'a Module,
    pub layout: Layout,
    pub scalars: &'a mut Scalars,
    /// By global variable: whether a function writes to it.
    written: &'a [bool],
    variables: FxHashMap<VariableId, ScalarValues>,
    ops: FxHashMap<OpId, ScalarValues>,
    returned: FxHashMap<OpId, Vec<ScalarValues>>,
    /// Whether control reaches this position, as a condition.
    active: ScalarId,
    /// Whether the function has returned, and with what.
    done: ScalarId,
    result: Option<ScalarValues>,
    left: u32,
    depth: u32,
    exits: Vec<ScalarId>,
    /// The function before whose call the execution ends.
    until: Option<FunctionRef>,
    /// In the step of a loop: the operations of the loop.
    private: Option<Run>,
    /// The values that vectors had.
    pub vectors: Vec<Vec<ScalarId>>,
}

/// A result of the execution, or why there is none.
pub(super) type Executed<T> = Result<T, Obstacle>;

impl<'a> SymbolicExecution<'a> {
    pub fn new(
        (program, module): (&'a Program, &'a Module),
        written: &'a [bool],
        scalars: &'a mut Scalars,
    ) -> SymbolicExecution<'a> {
        let active = scalars.truth(true);
        let done = scalars.truth(false);
        SymbolicExecution {
            module,
            layout: Layout::of(program),
            scalars,
            written,
            variables: FxHashMap::default(),
            ops: FxHashMap::default(),
            returned: FxHashMap::default(),
            active,
            done,
            result: None,
            left: MAX_OPS,
            depth: 0,
            exits: Vec::new(),
            until: None,
            private: None,
            vectors: Vec::new(),
        }
    }

    /// The values of some global variables where a function is called first.
    pub fn run_until(
        &mut self,
        entry: FunctionRef,
        function: FunctionRef,
        globals: &[VariableId],
    ) -> Vec<(VariableId, ScalarValues)> {
        self.until = Some(function);
        let body = self.module.function(entry).and_then(|f| f.body);
        if let (Ok(()), Some(body)) = (self.region(self.module.globals), body) {
            self.variables.retain(|id, _| !globals.contains(id));
            // It ends with an error, at the call or before.
            let _ended = self.region(body);
        }
        let known = globals.iter().filter_map(|id| {
            let values = self.variables.get(id)?;
            Some((*id, values.clone()))
        });
        known.collect()
    }

    /// The result of a function at a point. `globals` are values of global variables.
    pub fn run(
        &mut self,
        (function, point): (FunctionRef, VariableId),
        globals: Vec<(VariableId, ScalarValues)>,
    ) -> Executed<ScalarValues> {
        self.region(self.module.globals)?;
        // What functions write to globals is not known at the call.
        let is_written = |id: &VariableId| self.written.get(id.0 as usize) == Some(&true);
        self.variables.retain(|id, _| !is_written(id));
        self.variables.extend(globals);
        let found = self.module.function(function);
        let found = found.ok_or_else(|| self.blocked(SlopeObstacle::Body))?;
        for &parameter in self.module.parameters(found) {
            if parameter == point {
                let count = self.count(parameter)?;
                let point = (0..count).map(|n| self.scalars.coordinate(n)).collect();
                self.variables.insert(parameter, point);
            }
        }
        let body = found
            .body
            .ok_or_else(|| self.blocked(SlopeObstacle::Body))?;
        self.region(body)?;
        self.result
            .take()
            .ok_or_else(|| self.blocked(SlopeObstacle::Body))
    }

    pub fn blocked(&self, why: SlopeObstacle) -> Obstacle {
        Obstacle {
            why,
            at: self.scalars.at,
        }
    }

    fn count(&self, variable: VariableId) -> Executed<u32> {
        let ty = self.module.variable(variable).map_or(Type::ERROR, |v| v.ty);
        self.count_of(ty)
    }

    fn count_of(&self, ty: Type) -> Executed<u32> {
        let count = self.layout.scalars(ty).filter(|count| *count <= MAX_VALUES);
        count.ok_or_else(|| self.blocked(SlopeObstacle::Value))
    }

    /// New values that do not depend on the point.
    pub fn fixed(&mut self, count: u32) -> ScalarValues {
        (0..count)
            .map(|_| self.scalars.fixed(RealSpan::ANY))
            .collect()
    }

    /// New values that may depend on it.
    pub fn unknown(&mut self, count: u32) -> ScalarValues {
        (0..count).map(|_| self.scalars.unknown()).collect()
    }

    /// The value of a variable.
    fn variable(&mut self, id: VariableId) -> Executed<ScalarValues> {
        if let Some(values) = self.variables.get(&id) {
            return Ok(values.clone());
        }
        let count = self.count(id)?;
        let values = match self.module.variable(id).map(|v| v.root) {
            Some(Root::Local | Root::Temporary | Root::ParameterOut) => {
                let zero = self.scalars.number(0.0);
                vec![zero; count as usize]
            }
            _ => self.fixed(count),
        };
        self.variables.insert(id, values.clone());
        Ok(values)
    }

    pub fn values(&self, op: OpId) -> Executed<ScalarValues> {
        let values = self.ops.get(&op).cloned();
        values.ok_or_else(|| self.blocked(SlopeObstacle::Value))
    }

    /// The scalars of a place: an index per component, or the index that is not known.
    fn place(
        &mut self,
        place: PlaceId,
    ) -> Executed<(VariableId, Result<Vec<usize>, ScalarValues>)> {
        let place: Place = *self.module.place(place);
        let mut ty = self
            .module
            .variable(place.variable)
            .map_or(Type::ERROR, |v| v.ty);
        let mut first = 0;
        for access in self.module.path(&place) {
            let index = match access {
                Access::Lanes(lanes) => {
                    let all = lanes.numbers().iter().map(|n| first + *n as usize);
                    return Ok((place.variable, Ok(all.collect())));
                }
                Access::Member(index) | Access::Element(index) => *index,
                Access::Computed(op) => {
                    let index = self.values(*op)?;
                    let known = index.first().and_then(|id| self.scalars.value(*id));
                    match known {
                        Some(known) if known >= 0.0 => {
                            (known as u32).min(self.layout.count(ty).saturating_sub(1))
                        }
                        _ => return Ok((place.variable, Err(index))),
                    }
                }
            };
            let part = self.layout.part(ty, index);
            let part = part.and_then(|part| Some((part.ty, part.scalar?)));
            let (of, scalar) = part.ok_or_else(|| self.blocked(SlopeObstacle::Value))?;
            ty = of;
            first += scalar as usize;
        }
        let count = self.count_of(ty)? as usize;
        Ok((place.variable, Ok((first..first + count).collect())))
    }

    fn load(&mut self, op: OpId, place: PlaceId) -> Executed<ScalarValues> {
        let (variable, indices) = self.place(place)?;
        let values = self.variable(variable)?;
        match indices {
            Ok(indices) => {
                let all = indices.iter().map(|at| values.get(*at).copied());
                let all: Option<ScalarValues> = all.collect();
                all.ok_or_else(|| self.blocked(SlopeObstacle::Value))
            }
            Err(index) => {
                let count = self.count_of(self.module.ty(op))?;
                let mut all = values.iter().chain(&index);
                Ok(match all.any(|id| self.scalars.varies(*id)) {
                    true => self.unknown(count),
                    false => self.fixed(count),
                })
            }
        }
    }

    fn store(&mut self, place: PlaceId, value: OpId) -> Executed<()> {
        let new = self.values(value)?;
        let (variable, indices) = self.place(place)?;
        let mut values = self.variable(variable)?;
        match indices {
            Ok(indices) => {
                let is_private = self
                    .private
                    .is_some_and(|ops| self.is_private(variable, ops));
                for (at, new) in indices.iter().zip(new) {
                    if let Some(old) = values.get_mut(*at) {
                        *old = match is_private {
                            true => new,
                            false => self.guarded(new, *old),
                        };
                    }
                }
            }
            Err(_) => {
                let count = values.len() as u32;
                values = self.unknown(count);
            }
        }
        self.keep_vector(&values);
        self.variables.insert(variable, values);
        Ok(())
    }

    fn keep_vector(&mut self, values: &[ScalarId]) {
        let is_vector = (2..=3).contains(&values.len());
        if is_vector && values.iter().all(|id| self.scalars.varies(*id)) {
            self.vectors.push(values.to_vec());
        }
    }

    /// A new value where control reaches this position, and the old one elsewhere.
    fn guarded(&mut self, new: ScalarId, old: ScalarId) -> ScalarId {
        self.scalars.select(self.active, new, old)
    }

    /// Whether a variable is read in a loop only. Where control has left the loop, its value does not
    /// matter, so that a counter stays a constant.
    fn is_private(&self, variable: VariableId, ops: Run) -> bool {
        let is_local = |v: &Variable| v.root == Root::Local;
        let mut others = (0..).map(OpId).zip(&self.module.ops);
        self.module.variable(variable).is_some_and(is_local)
            && others.all(|(id, op)| match op.kind {
                OpKind::Load(place) => {
                    ops.contains(id) || self.module.place(place).variable != variable
                }
                _ => true,
            })
    }

    fn is_dead(&self) -> bool {
        self.scalars.value(self.active) == Some(0.0)
    }

    pub fn region(&mut self, region: Region) -> Executed<()> {
        for step in self.module.steps(region) {
            if self.is_dead() {
                return Ok(());
            }
            match *step {
                Step::Run(run) => {
                    for op in run.ops() {
                        self.op(op)?;
                    }
                }
                Step::If {
                    condition,
                    then,
                    otherwise,
                    ..
                } => self.branch(condition, then, otherwise)?,
                Step::Loop(id) => {
                    let looped = self.module.looped(id).copied();
                    let looped = looped.ok_or_else(|| self.blocked(SlopeObstacle::Loop))?;
                    self.looped(&looped)?;
                }
                Step::Switch(id) => {
                    let switch = self.module.switch(id).copied();
                    let switch = switch.ok_or_else(|| self.blocked(SlopeObstacle::Jump))?;
                    self.switch(&switch)?;
                }
                Step::Break(_) => {
                    let before = self.exits.pop();
                    let before = before.ok_or_else(|| self.blocked(SlopeObstacle::Jump))?;
                    let exit = self.scalars.or(before, self.active);
                    self.exits.push(exit);
                    self.active = self.scalars.truth(false);
                }
                Step::Continue(_) => self.active = self.scalars.truth(false),
                Step::Return(value, _) => self.leave(value)?,
                Step::Discard(_) => self.active = self.scalars.truth(false),
            }
        }
        Ok(())
    }

    fn leave(&mut self, value: Option<OpId>) -> Executed<()> {
        if let Some(op) = value {
            let new = self.values(op)?;
            let values = match self.result.take() {
                // The first result: what is elsewhere is not known yet, and never used.
                None => new,
                Some(old) => {
                    let both = new.iter().zip(old);
                    both.map(|(new, old)| self.guarded(*new, old)).collect()
                }
            };
            self.result = Some(values);
        }
        self.done = self.scalars.or(self.done, self.active);
        self.active = self.scalars.truth(false);
        Ok(())
    }

    fn branch(&mut self, condition: OpId, then: Region, otherwise: Region) -> Executed<()> {
        let condition = self.values(condition)?.first().copied();
        let condition = condition.ok_or_else(|| self.blocked(SlopeObstacle::Value))?;
        if let Some(known) = self.scalars.value(condition) {
            return self.region(if known != 0.0 { then } else { otherwise });
        }
        let before = self.variables.clone();
        let (active, done, exits) = (self.active, self.done, self.exits.clone());
        let result = self.result.clone();
        self.region(then)?;
        let first = std::mem::replace(&mut self.variables, before);
        let first_active = std::mem::replace(&mut self.active, active);
        let first_done = std::mem::replace(&mut self.done, done);
        let first_exits = std::mem::replace(&mut self.exits, exits);
        let first_result = std::mem::replace(&mut self.result, result);
        self.region(otherwise)?;
        let mut first: Vec<(VariableId, ScalarValues)> = first.into_iter().collect();
        first.sort_by_key(|(variable, _)| variable.0);
        for (variable, values) in first {
            let Some(others) = self.variables.get_mut(&variable) else {
                self.variables.insert(variable, values);
                continue;
            };
            for (value, other) in values.into_iter().zip(others.iter_mut()) {
                *other = self.scalars.select(condition, value, *other);
            }
            let values = others.clone();
            self.keep_vector(&values);
        }
        self.result = match (first_result, self.result.take()) {
            (Some(first), Some(second)) => {
                let both = first.into_iter().zip(second);
                Some(
                    both.map(|(a, b)| self.scalars.select(condition, a, b))
                        .collect(),
                )
            }
            (first, second) => first.or(second),
        };
        let mut meet = |a, b| self.scalars.select_condition(condition, a, b);
        self.active = meet(first_active, self.active);
        self.done = meet(first_done, self.done);
        for (exit, first) in self.exits.iter_mut().zip(first_exits) {
            *exit = meet(first, *exit);
        }
        Ok(())
    }

    fn looped(&mut self, looped: &Loop) -> Executed<()> {
        let before = self.active;
        let none = self.scalars.truth(false);
        self.exits.push(none);
        for iteration in 0.. {
            if looped.tests_first || iteration > 0 {
                self.region(looped.test)?;
                if !self.test(looped.condition)? {
                    break;
                }
            }
            if iteration == MAX_ITERATIONS {
                return Err(self.blocked(SlopeObstacle::Loop));
            }
            let start = self.active;
            self.region(looped.body)?;
            // Those that continue meet here.
            let exited = self.exits.last().copied().unwrap_or(none);
            let left = self.scalars.or(exited, self.done);
            let stays = self.scalars.not(left);
            self.active = self.scalars.and(start, stays);
            if self.is_dead() {
                break;
            }
            self.private = Some(looped.ops);
            self.region(looped.step)?;
            self.private = None;
        }
        self.exits.pop();
        let stays = self.scalars.not(self.done);
        self.active = self.scalars.and(before, stays);
        Ok(())
    }

    /// Goes on where the condition of a loop holds; whether it may.
    fn test(&mut self, condition: Option<OpId>) -> Executed<bool> {
        if let Some(op) = condition {
            let condition = self.values(op)?.first().copied();
            let condition = condition.ok_or_else(|| self.blocked(SlopeObstacle::Loop))?;
            self.active = self.scalars.and(self.active, condition);
        }
        Ok(!self.is_dead())
    }

    fn switch(&mut self, switch: &Switch) -> Executed<()> {
        let selector = self.values(switch.selector)?.first().copied();
        let selector = selector.and_then(|id| self.scalars.value(id));
        let selector = selector.ok_or_else(|| self.blocked(SlopeObstacle::Jump))?;
        let before = self.active;
        let none = self.scalars.truth(false);
        self.exits.push(none);
        let cases = self.module.cases(switch);
        let has = |label: CaseLabel| {
            let mut all = cases.iter();
            all.position(|case| self.module.labels(case).contains(&label))
        };
        let value = CaseLabel::Value(selector as i64 as u32);
        let first = has(value).or_else(|| has(CaseLabel::Default));
        for case in cases.iter().skip(first.unwrap_or(cases.len())) {
            self.region(case.body)?;
        }
        self.exits.pop();
        let stays = self.scalars.not(self.done);
        self.active = self.scalars.and(before, stays);
        Ok(())
    }

    fn op(&mut self, id: OpId) -> Executed<()> {
        self.scalars.at = Some(id);
        self.left = self.left.saturating_sub(1);
        if self.left == 0 || self.scalars.is_full() {
            return Err(self.blocked(SlopeObstacle::Size));
        }
        let op = *self.module.op(id);
        let values = match op.kind {
            OpKind::Store(place, value) => return self.store(place, value),
            OpKind::Load(place) => match self.module.place(place).ty.is_sampler() {
                true => ScalarValues::new(),
                false => self.load(id, place)?,
            },
            OpKind::Const(_) => {
                let constant = self.module.constant(id).to_vec();
                let numbers = constant.into_iter().map(|value| match value {
                    Value::Bool(is) => f64::from(u8::from(is)),
                    Value::Int(value) => f64::from(value),
                    Value::Uint(value) => f64::from(value),
                    Value::Float(value) => f64::from(value),
                });
                numbers.map(|value| self.scalars.number(value)).collect()
            }
            OpKind::Call(function, list) => self.call(id, function, list)?,
            OpKind::Returned(call, index) => {
                let returned = self.returned.get(&call);
                let values = returned.and_then(|all| all.get(index as usize)).cloned();
                values.ok_or_else(|| self.blocked(SlopeObstacle::Value))?
            }
            OpKind::Undef => {
                let count = self.count_of(op.ty)?;
                let zero = self.scalars.number(0.0);
                vec![zero; count as usize]
            }
            _ => self.compute(id, &op)?,
        };
        self.ops.insert(id, values);
        Ok(())
    }

    fn call(
        &mut self,
        id: OpId,
        function: FunctionRef,
        list: shaderlint_syntax::ast::List,
    ) -> Executed<ScalarValues> {
        let found = self.module.function(function).copied();
        let found = found.ok_or_else(|| self.blocked(SlopeObstacle::Body))?;
        let body = found
            .body
            .ok_or_else(|| self.blocked(SlopeObstacle::Body))?;
        if self.depth >= MAX_DEPTH || self.until == Some(function) {
            return Err(self.blocked(SlopeObstacle::Size));
        }
        let parameters = self.module.parameters(&found);
        for (parameter, argument) in parameters.iter().zip(self.module.operands(list)) {
            let mut values = self.values(*argument)?;
            // The operands of a smooth minimum, whose difference would not show them.
            if let [value] = values.as_mut_slice() {
                *value = self.scalars.of(ScalarFunction::Same, *value);
            }
            self.variables.insert(*parameter, values);
        }
        let none = self.scalars.truth(false);
        let (active, done) = (self.active, std::mem::replace(&mut self.done, none));
        let result = self.result.take();
        let exits = std::mem::take(&mut self.exits);
        self.active = self.scalars.truth(true);
        self.depth += 1;
        // Stores to globals depend on the condition of the call.
        let globals: Vec<(VariableId, ScalarValues)> = match self.scalars.value(active) {
            Some(_) => Vec::new(),
            None => self.globals(),
        };
        self.region(body)?;
        self.depth -= 1;
        self.scalars.at = Some(id);
        for (variable, old) in globals {
            if let Some(new) = self.variables.get_mut(&variable) {
                for (new, old) in new.iter_mut().zip(old) {
                    *new = self.scalars.select(active, *new, old);
                }
            }
        }
        (self.active, self.done, self.exits) = (active, done, exits);
        let value = std::mem::replace(&mut self.result, result);
        let mut returned = Vec::new();
        for parameter in parameters {
            returned.push(self.variable(*parameter)?);
        }
        self.returned.insert(id, returned);
        match value {
            Some(values) => Ok(values),
            None if found.returns == Type::VOID => Ok(ScalarValues::new()),
            None => Err(self.blocked(SlopeObstacle::Body)),
        }
    }

    fn globals(&self) -> Vec<(VariableId, ScalarValues)> {
        let is_global = |id: &VariableId| {
            let variable = self.module.variable(*id);
            variable.is_some_and(|v| v.function.is_none())
        };
        let all = self.variables.iter().filter(|(id, _)| is_global(id));
        let mut all: Vec<_> = all.map(|(id, values)| (*id, values.clone())).collect();
        all.sort_by_key(|(id, _)| id.0);
        all
    }
}
