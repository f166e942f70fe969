//! Evaluates control flow: what follows depends on all ways that lead there.

use super::evaluate::{
    CallVariable, EvaluatedCall, Evaluation, Exits, MAX_INLINED, VariableValues,
};
use super::nodes::{Meeting, NodeId, NodeTag};
use rustc_hash::FxHashMap;
use shaderlint_ir::{CaseLabel, Loop, LoopId, OpId, OpKind, Region, Run, Step, Switch};
use shaderlint_semantic::{Type, VariableId};
use std::collections::BTreeSet;

/// A variable that a loop changes: its node at the start of an iteration, and its value before.
struct LoopVariable {
    key: CallVariable,
    name: String,
    start: NodeId,
    before: NodeId,
}

impl Evaluation<'_, '_> {
    /// Evaluates a region; whether its end is reached.
    pub fn region(&mut self, region: Region, frame: &mut EvaluatedCall) -> Option<bool> {
        let steps = self.module.steps(region);
        for (at, step) in steps.iter().enumerate() {
            let is_alive = match *step {
                Step::Run(run) => {
                    for op in run.ops() {
                        self.op(op, frame)?;
                    }
                    true
                }
                Step::If {
                    condition,
                    then,
                    otherwise,
                    ..
                } => self.branch(condition, [then, otherwise], frame)?,
                Step::Loop(id) => self.looped(id, frame)?,
                Step::Switch(id) => {
                    let switch = *self.module.switch(id)?;
                    self.switch(&switch, frame)?
                }
                Step::Break(_) => self.jump(NodeTag::Break, frame)?,
                Step::Continue(_) => self.jump(NodeTag::Continue, frame)?,
                Step::Return(value, _) => {
                    let value = match value {
                        Some(op) => Some((op, *frame.ops.get(&op)?)),
                        None => None,
                    };
                    if frame.is_inlined {
                        // Only a `return` at the end of the body can be inlined.
                        let body = self.module.function(frame.function?)?.body?;
                        let is_last = body == region && at + 1 == steps.len();
                        frame.result = value;
                        return is_last.then_some(true);
                    }
                    self.leave(value.map(|(_, value)| value), frame)?;
                    false
                }
                Step::Discard(_) => {
                    let effect = self.node(NodeTag::Discard, Vec::new());
                    self.effects.push(effect);
                    false
                }
            };
            if !is_alive {
                return Some(false);
            }
        }
        Some(true)
    }

    fn jump(&mut self, tag: NodeTag, frame: &mut EvaluatedCall) -> Option<bool> {
        let values = self.values.clone();
        let is_continue = tag == NodeTag::Continue;
        let mut around = frame.exits.iter_mut().rev();
        let target = around.find(|exits| exits.is_loop || !is_continue)?;
        match is_continue {
            true => target.continues.push(values),
            false => target.breaks.push(values),
        }
        let effect = self.node(tag, Vec::new());
        self.effects.push(effect);
        Some(false)
    }

    /// Evaluates a region on its own: its side effects, and whether its end is reached.
    fn inner(&mut self, region: Region, frame: &mut EvaluatedCall) -> Option<(NodeId, bool)> {
        let outer = std::mem::take(&mut self.effects);
        let is_alive = self.region(region, frame)?;
        let effects = std::mem::replace(&mut self.effects, outer);
        Some((self.node(NodeTag::Effects, effects), is_alive))
    }

    fn branch(
        &mut self,
        condition: OpId,
        regions: [Region; 2],
        frame: &mut EvaluatedCall,
    ) -> Option<bool> {
        let condition = *frame.ops.get(&condition)?;
        let (before, position) = (self.values.clone(), self.position);
        let mut ends = Vec::new();
        let mut effects = vec![condition];
        for (number, region) in (0..).zip(regions) {
            self.values = before.clone();
            self.position = self.node(NodeTag::Within(number), vec![position, condition]);
            let (made, is_alive) = self.inner(region, frame)?;
            effects.push(made);
            ends.push(is_alive.then(|| std::mem::take(&mut self.values)));
        }
        self.position = position;
        if !effects.iter().skip(1).all(|e| self.nodes.is_idle(*e)) {
            self.act(NodeTag::If, effects);
        }
        let mut ends = ends.into_iter();
        self.values = match (ends.next().flatten(), ends.next().flatten()) {
            (Some(then), Some(otherwise)) => self.selected(condition, then, &otherwise),
            (Some(values), None) | (None, Some(values)) => values,
            (None, None) => return Some(false),
        };
        Some(true)
    }

    /// Adds a side effect that changes which pixels are there.
    fn act(&mut self, tag: NodeTag, operands: Vec<NodeId>) {
        let effect = self.node(tag, operands);
        self.effects.push(effect);
        self.position = self.node(NodeTag::Past, vec![self.position, effect]);
    }

    fn type_of(&self, id: VariableId) -> Type {
        self.module.variable(id).map_or(Type::ERROR, |v| v.ty)
    }

    fn selected(
        &mut self,
        condition: NodeId,
        then: VariableValues,
        otherwise: &VariableValues,
    ) -> VariableValues {
        let both = then.into_iter().filter_map(|(key, a)| {
            let b = *otherwise.get(&key)?;
            let ty = self.type_of(key.1);
            let value = match a == b {
                true => a,
                false => self.nodes.add(NodeTag::Select, ty, vec![condition, a, b]),
            };
            Some((key, value))
        });
        both.collect()
    }

    /// The values where several ways meet; `None` if there is no way.
    fn joined(
        &mut self,
        meeting: Meeting,
        number: u32,
        mut ways: Vec<VariableValues>,
    ) -> Option<VariableValues> {
        if ways.len() < 2 {
            return ways.pop();
        }
        let first = ways.first()?;
        let keys: Vec<CallVariable> = first.keys().copied().collect();
        let mut values = VariableValues::default();
        for key in keys {
            let all = ways.iter().map(|way| way.get(&key).copied());
            let Some(all) = all.collect::<Option<Vec<NodeId>>>() else {
                continue;
            };
            let ty = self.type_of(key.1);
            let value = self.nodes.add(NodeTag::Join(meeting, number), ty, all);
            values.insert(key, value);
        }
        Some(values)
    }

    /// Collects the variables that operations may change.
    fn changed(&self, ops: Run, call: u32, depth: u32, keys: &mut BTreeSet<CallVariable>) {
        for op in ops.ops() {
            match self.module.op(op).kind {
                OpKind::Store(place, _) => {
                    let variable = self.module.place(place).variable;
                    keys.insert(self.key(variable, call));
                }
                OpKind::Call(callee, _) => match self.is_pure(callee) {
                    Some(true) => {}
                    Some(false) => keys.extend(self.shared_keys()),
                    // Its own variables begin at its call.
                    None if depth < MAX_INLINED => {
                        let function = self.module.function(callee);
                        if let Some(function) = function {
                            self.changed(function.ops, u32::MAX, depth + 1, keys);
                        }
                    }
                    None => {}
                },
                _ => {}
            }
        }
    }

    /// The variables that a loop may change, in the order of their names.
    fn carried(&mut self, looped: &Loop, number: u32, frame: &EvaluatedCall) -> Vec<LoopVariable> {
        let mut keys: BTreeSet<CallVariable> = BTreeSet::new();
        self.changed(looped.ops, frame.number, 0, &mut keys);
        let mut same: FxHashMap<&str, u32> = FxHashMap::default();
        let mut all = Vec::new();
        for key in keys {
            // A variable of the loop has no value before it.
            let is_shared = key.0 == 0;
            if !is_shared && !self.values.contains_key(&key) {
                continue;
            }
            let name = self.side.name(key.1);
            let position = same.entry(name).or_default();
            let tag = NodeTag::Carried(number, name.to_string(), *position);
            *position += 1;
            let start = self.nodes.add(tag, self.type_of(key.1), Vec::new());
            all.push(LoopVariable {
                key,
                name: name.to_string(),
                start,
                before: self.whole(key.0, key.1),
            });
        }
        all.sort_by(|a, b| a.name.cmp(&b.name));
        all
    }

    fn looped(&mut self, id: LoopId, frame: &mut EvaluatedCall) -> Option<bool> {
        let looped = *self.module.looped(id)?;
        let number = self.loops;
        self.loops += 1;
        let carried = self.carried(&looped, number, frame);
        for variable in &carried {
            self.values.insert(variable.key, variable.start);
        }
        let position = self.position;
        self.position = self.node(NodeTag::Within(number), vec![position]);
        frame.exits.push(Exits {
            is_loop: true,
            ..Exits::default()
        });
        let mut ways_out = Vec::new();
        let mut effects = Vec::new();
        if looped.tests_first {
            self.test(&looped, frame, &mut effects, &mut ways_out)?;
        }
        let (body, is_alive) = self.inner(looped.body, frame)?;
        effects.push(body);
        let mut ways = frame
            .exits
            .last_mut()
            .map(|e| std::mem::take(&mut e.continues))?;
        if is_alive {
            ways.push(std::mem::take(&mut self.values));
        }
        if let Some(values) = self.joined(Meeting::Iteration, number, ways) {
            self.values = values;
            if !looped.tests_first {
                self.test(&looped, frame, &mut effects, &mut ways_out)?;
            }
            effects.push(self.inner(looped.step, frame)?.0);
            for variable in &carried {
                effects.push(variable.start);
                effects.push(variable.before);
                effects.push(self.whole(variable.key.0, variable.key.1));
            }
        }
        ways_out.extend(frame.exits.pop()?.breaks);
        self.position = position;
        self.act(NodeTag::Loop(number), effects);
        match self.joined(Meeting::LoopExit, number, ways_out) {
            Some(values) => self.values = values,
            None => return Some(false),
        }
        Some(true)
    }

    /// Evaluates the condition of a loop.
    fn test(
        &mut self,
        looped: &Loop,
        frame: &mut EvaluatedCall,
        effects: &mut Vec<NodeId>,
        ways_out: &mut Vec<VariableValues>,
    ) -> Option<()> {
        effects.push(self.inner(looped.test, frame)?.0);
        if let Some(condition) = looped.condition {
            effects.push(*frame.ops.get(&condition)?);
            ways_out.push(self.values.clone());
        }
        Some(())
    }

    fn switch(&mut self, switch: &Switch, frame: &mut EvaluatedCall) -> Option<bool> {
        let selector = *frame.ops.get(&switch.selector)?;
        let number = self.loops;
        self.loops += 1;
        let (before, position) = (self.values.clone(), self.position);
        frame.exits.push(Exits::default());
        let mut effects = vec![selector];
        let mut has_default = false;
        // The values at the end of a case that falls through.
        let mut through: Option<VariableValues> = None;
        for (at, case) in (0..).zip(self.module.cases(switch)) {
            let labels = self.module.labels(case);
            has_default |= labels.contains(&CaseLabel::Default);
            let ways = [Some(before.clone()), through.take()];
            let ways = ways.into_iter().flatten().collect();
            self.values = self.joined(Meeting::Case(at), number, ways)?;
            let labels = labels.iter().map(|label| match label {
                CaseLabel::Value(value) => Some(*value),
                CaseLabel::Default => None,
            });
            let tag = NodeTag::Case(labels.collect());
            self.position = self.node(tag.clone(), vec![position, selector]);
            let (made, is_alive) = self.inner(case.body, frame)?;
            effects.push(self.node(tag, vec![made]));
            through = is_alive.then(|| std::mem::take(&mut self.values));
        }
        let mut ways: Vec<VariableValues> = frame.exits.pop()?.breaks;
        ways.extend(through);
        if !has_default {
            ways.push(before);
        }
        self.position = position;
        self.act(NodeTag::Switch(number), effects);
        match self.joined(Meeting::SwitchExit, number, ways) {
            Some(values) => self.values = values,
            None => return Some(false),
        }
        Some(true)
    }
}
