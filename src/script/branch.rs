//! Conditions that are not known: all branches are evaluated.

use crate::evaluator::{ChangeLog, ChangedSlot, Evaluator};
use crate::value::{KnownText, Primitive, ScriptPlace, ScriptValue};
use crate::world::{EventCertainty, ObjectKind, Source};
use rustc_hash::FxHashMap;
use std::rc::Rc;

/// How a statement ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum StatementEnd {
    /// The next statement follows.
    Next,
    /// A loop or `switch` ends.
    Break,
    /// The next iteration follows.
    Continue,
    /// The function returns.
    Return,
    /// An exception is thrown.
    Throw,
}

impl StatementEnd {
    pub fn ends_function(self) -> bool {
        matches!(self, StatementEnd::Return | StatementEnd::Throw)
    }
}

/// What is evaluated in a branch.
pub(crate) type BranchCode<'w, 'a, 'r> =
    &'w mut dyn FnMut(&mut Evaluator<'a, 'r>) -> (StatementEnd, ScriptValue);

impl<'a, 'r> Evaluator<'a, 'r> {
    /// Evaluates all branches, each from the same state, and joins the states after them. A single way may also
    /// not be taken.
    pub fn ways(&mut self, ways: &mut [BranchCode<'_, 'a, 'r>]) -> (StatementEnd, ScriptValue) {
        let before = self.certainty;
        let is_single = ways.len() == 1;
        let mut changes: Vec<FxHashMap<ChangedSlot<'a>, Option<ScriptValue>>> = Vec::new();
        let mut olds = ChangeLog::default();
        let mut flows = Vec::new();
        let mut result: Option<ScriptValue> = None;
        for way in ways.iter_mut() {
            self.certainty = before.max(match is_single {
                true => EventCertainty::Guarded,
                false => EventCertainty::Alternative,
            });
            self.logs.push(ChangeLog::default());
            let first = self.world.events.len();
            let (flow, value) = way(self);
            // A way that ends the function is an alternative to everything after it.
            if flow != StatementEnd::Next && is_single {
                let events = self.world.events.get_mut(first..).into_iter().flatten();
                events.for_each(|e| e.certainty = EventCertainty::Alternative);
            }
            let log = self.logs.pop().unwrap_or_default();
            let mut changed = FxHashMap::default();
            for (slot, old) in log.changes {
                changed.insert(slot.clone(), self.slot(&slot));
                self.put(&slot, old.clone(), ScriptPlace::default());
                olds.add(slot, old);
            }
            // What a way that ends changes is not seen after it.
            if flow == StatementEnd::Next {
                changes.push(changed);
                result = Some(match result {
                    Some(other) => self.join(other, value),
                    None => value,
                });
            }
            flows.push(flow);
        }
        self.certainty = before;
        for (slot, old) in olds.changes {
            let news = changes
                .iter()
                .map(|changed| changed.get(&slot).cloned().unwrap_or_else(|| old.clone()));
            let mut all: Vec<Option<ScriptValue>> = news.collect();
            if is_single {
                all.push(old.clone());
            }
            let mut joined: Option<ScriptValue> = None;
            for value in all.into_iter().flatten() {
                joined = Some(match joined {
                    Some(other) => self.join(other, value),
                    None => value,
                });
            }
            self.set(slot, joined.or(old), ScriptPlace::default());
        }
        let first = flows.first().copied().unwrap_or(StatementEnd::Next);
        let is_end = !is_single && flows.iter().all(|f| *f != StatementEnd::Next);
        let flow = if is_end { first } else { StatementEnd::Next };
        (flow, result.unwrap_or(ScriptValue::Undefined))
    }

    /// A value that is one of two.
    pub fn join(&mut self, one: ScriptValue, other: ScriptValue) -> ScriptValue {
        if one.is_same(&other) {
            return one;
        }
        match (&one, &other) {
            (ScriptValue::Undefined | ScriptValue::Null, _) => return other,
            (_, ScriptValue::Undefined | ScriptValue::Null) => return one,
            _ => {}
        }
        match (one.primitive(), other.primitive()) {
            (Some(Primitive::Text), Some(Primitive::Text)) => {
                ScriptValue::Text(Rc::new(KnownText::unknown()))
            }
            (Some(a), Some(b)) if a == b => ScriptValue::Any(a),
            _ => self.unknown(ScriptPlace::default()),
        }
    }

    /// Whether a value counts as true, if that is known.
    pub fn truth(&self, value: &ScriptValue) -> Option<bool> {
        match value {
            ScriptValue::Undefined | ScriptValue::Null => Some(false),
            ScriptValue::Bool(flag) => Some(*flag),
            ScriptValue::Number(number) => Some(*number != 0.0 && !number.is_nan()),
            ScriptValue::Text(text) if text.content.is_empty() && text.is_open => None,
            ScriptValue::Text(text) => Some(!text.content.is_empty()),
            ScriptValue::Any(_) => None,
            ScriptValue::Object(id) => match &self.world.object(*id)?.kind {
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
        body: &mut dyn FnMut(&mut Self) -> StatementEnd,
    ) -> StatementEnd {
        /// Maximum number of iterations that are evaluated one by one.
        const MAX_ITERATIONS: usize = 40;
        /// The same for a loop in another.
        const MAX_INNER: usize = 8;
        let limit = if self.loops == 0 {
            MAX_ITERATIONS
        } else {
            MAX_INNER
        };
        self.loops += 1;
        let flow = self.iterate_up_to(limit, step, body);
        self.loops -= 1;
        flow
    }

    fn iterate_up_to(
        &mut self,
        limit: usize,
        step: &mut dyn FnMut(&mut Self) -> Option<bool>,
        body: &mut dyn FnMut(&mut Self) -> StatementEnd,
    ) -> StatementEnd {
        self.logs.push(ChangeLog::default());
        let mut flow = StatementEnd::Next;
        let mut is_known = false;
        let mut has_run = false;
        for _ in 0..limit {
            match step(self) {
                Some(false) => is_known = true,
                Some(true) => {
                    has_run = true;
                    flow = body(self);
                    is_known = flow == StatementEnd::Break || flow.ends_function();
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
        for (slot, old) in &log.changes {
            if let Some(outer) = self.logs.last_mut() {
                outer.add(slot.clone(), old.clone());
            }
        }
        if is_known {
            return if flow.ends_function() {
                flow
            } else {
                StatementEnd::Next
            };
        }
        // What an iteration changes is unknown before the next one.
        let mut once = |e: &mut Self| {
            step(e);
            (body(e), ScriptValue::Undefined)
        };
        if !has_run {
            let (before, missing) = (self.world.events.len(), self.missing);
            self.ways(&mut [&mut once]);
            self.world.events.truncate(before);
            self.missing = missing;
        } else {
            for (slot, old) in log.changes {
                if let (Some(new), Some(old)) = (self.slot(&slot), old) {
                    let joined = self.join(old, new);
                    self.set(slot, Some(joined), ScriptPlace::default());
                }
            }
        }
        self.ways(&mut [&mut once]);
        StatementEnd::Next
    }
}
