//! Conditions that are not known: all branches are evaluated.

use crate::evaluator::{Evaluator, Slot};
use crate::statement::Flow;
use crate::value::{Place, Primitive, ScriptText, Value};
use crate::world::{Certainty, ObjectKind, Source};
use std::rc::Rc;

/// What is evaluated in a branch.
pub(crate) type Way<'w, 'a, 'r> = &'w mut dyn FnMut(&mut Evaluator<'a, 'r>) -> (Flow, Value);

impl<'a, 'r> Evaluator<'a, 'r> {
    /// Evaluates all branches, each from the same state, and joins the states after them. A single way may also
    /// not be taken.
    pub fn ways(&mut self, ways: &mut [Way<'_, 'a, 'r>]) -> (Flow, Value) {
        let before = self.certainty;
        let is_single = ways.len() == 1;
        let mut changes: Vec<Vec<(Slot<'a>, Option<Value>)>> = Vec::new();
        let mut olds: Vec<(Slot<'a>, Option<Value>)> = Vec::new();
        let mut flows = Vec::new();
        let mut result: Option<Value> = None;
        for way in ways.iter_mut() {
            self.certainty = before.max(match is_single {
                true => Certainty::Guarded,
                false => Certainty::Alternative,
            });
            self.logs.push(Vec::new());
            let first = self.world.events.len();
            let (flow, value) = way(self);
            // A way that ends the function is an alternative to everything after it.
            if flow != Flow::Next && is_single {
                let events = self.world.events.get_mut(first..).into_iter().flatten();
                events.for_each(|e| e.certainty = Certainty::Alternative);
            }
            let log = self.logs.pop().unwrap_or_default();
            let mut changed = Vec::new();
            for (slot, old) in log {
                changed.push((slot.clone(), self.slot(&slot)));
                self.put(&slot, old.clone(), Place::default());
                if !olds.iter().any(|(known, _)| *known == slot) {
                    olds.push((slot, old));
                }
            }
            // What a way that ends changes is not seen after it.
            if flow == Flow::Next {
                changes.push(changed);
                result = Some(match result {
                    Some(other) => self.join(other, value),
                    None => value,
                });
            }
            flows.push(flow);
        }
        self.certainty = before;
        for (slot, old) in olds {
            let news = changes.iter().map(|changed| {
                let new = changed.iter().find(|(known, _)| *known == slot);
                new.map_or(old.clone(), |(_, value)| value.clone())
            });
            let mut all: Vec<Option<Value>> = news.collect();
            if is_single {
                all.push(old.clone());
            }
            let mut joined: Option<Value> = None;
            for value in all.into_iter().flatten() {
                joined = Some(match joined {
                    Some(other) => self.join(other, value),
                    None => value,
                });
            }
            self.set(slot, joined.or(old), Place::default());
        }
        let first = flows.first().copied().unwrap_or(Flow::Next);
        let is_end = !is_single && flows.iter().all(|f| *f != Flow::Next);
        let flow = if is_end { first } else { Flow::Next };
        (flow, result.unwrap_or(Value::Undefined))
    }

    /// A value that is one of two.
    pub fn join(&mut self, one: Value, other: Value) -> Value {
        if one.is_same(&other) {
            return one;
        }
        match (&one, &other) {
            (Value::Undefined | Value::Null, _) => return other,
            (_, Value::Undefined | Value::Null) => return one,
            _ => {}
        }
        match (one.primitive(), other.primitive()) {
            (Some(Primitive::Text), Some(Primitive::Text)) => {
                Value::Text(Rc::new(ScriptText::unknown()))
            }
            (Some(a), Some(b)) if a == b => Value::Any(a),
            _ => self.unknown(Place::default()),
        }
    }

    /// Whether a value counts as true, if that is known.
    pub fn truth(&self, value: &Value) -> Option<bool> {
        match value {
            Value::Undefined | Value::Null => Some(false),
            Value::Bool(flag) => Some(*flag),
            Value::Number(number) => Some(*number != 0.0 && !number.is_nan()),
            Value::Text(text) if text.content.is_empty() && text.is_open => None,
            Value::Text(text) => Some(!text.content.is_empty()),
            Value::Any(_) => None,
            Value::Object(id) => match &self.world.object(*id)?.kind {
                ObjectKind::Foreign(Source::Event(_)) => self
                    .world
                    .call_of(*id)
                    .filter(|call| call.is_new)
                    .map(|_| true),
                ObjectKind::Foreign(Source::Package(..)) => Some(true),
                ObjectKind::Foreign(_) => None,
                _ => Some(true),
            },
        }
    }

    /// Evaluates the iterations of a loop: known ones one by one, then, if others may follow, one that stands for
    /// all of them. `step` prepares an iteration and says whether there is one, if that is known.
    pub fn iterate(
        &mut self,
        step: &mut dyn FnMut(&mut Self) -> Option<bool>,
        body: &mut dyn FnMut(&mut Self) -> Flow,
    ) -> Flow {
        /// Maximum number of iterations that are evaluated one by one.
        const MAX_ITERATIONS: usize = 40;
        self.logs.push(Vec::new());
        let mut flow = Flow::Next;
        let mut is_known = false;
        let mut has_run = false;
        for _ in 0..MAX_ITERATIONS {
            match step(self) {
                Some(false) => is_known = true,
                Some(true) => {
                    has_run = true;
                    flow = body(self);
                    is_known = flow == Flow::Break || flow.ends_function();
                }
                None => {
                    is_known = false;
                    break;
                }
            }
            if is_known {
                break;
            }
        }
        let log = self.logs.pop().unwrap_or_default();
        for (slot, old) in &log {
            if let Some(outer) = self.logs.last_mut()
                && !outer.iter().any(|(known, _)| known == slot)
            {
                outer.push((slot.clone(), old.clone()));
            }
        }
        if is_known {
            return if flow.ends_function() {
                flow
            } else {
                Flow::Next
            };
        }
        // What an iteration changes is unknown before the next one.
        let mut once = |e: &mut Self| {
            step(e);
            (body(e), Value::Undefined)
        };
        if !has_run {
            let (before, missing) = (self.world.events.len(), self.missing);
            self.ways(&mut [&mut once]);
            self.world.events.truncate(before);
            self.missing = missing;
        } else {
            for (slot, old) in log {
                if let (Some(new), Some(old)) = (self.slot(&slot), old) {
                    let joined = self.join(old, new);
                    self.set(slot, Some(joined), Place::default());
                }
            }
        }
        self.ways(&mut [&mut once]);
        Flow::Next
    }
}
