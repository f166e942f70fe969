//! Loop analysis: induction variables, exit conditions and trip counts.

mod bound;
mod halving;
mod pace;
#[cfg(test)]
mod tests;

use super::ranges::Query;
pub(crate) use pace::is_invariant;
use rustc_hash::FxHashMap;
use shaderlint_ir::{Loop, LoopId, Module, OpId, Step, Switch, Visit};
use shaderlint_semantic::{FunctionRef, VariableId};
use shaderlint_syntax::ast::{ExprId, StmtId};

/// The facts about one loop.
#[derive(Clone, Copy, Debug)]
pub struct LoopFacts {
    /// The loop statement.
    pub stmt: StmtId,
    /// The function that contains the loop.
    pub function: FunctionRef,
    /// The bound of its trip count.
    pub bound: Bound,
    /// The induction variable that bounds the loop.
    pub counter: Option<VariableId>,
    /// The limit that the counter is compared with.
    pub limit: Option<ExprId>,
    /// The expression that determines the limit: the limit itself, or the argument if it is a
    /// parameter.
    pub given: Option<ExprId>,
    /// Whether something else may exit the loop: `break`, `return`, `discard`, or a second
    /// condition.
    pub ends_early: bool,
}

/// The trip count of a loop, per execution.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Bound {
    /// Exactly this many iterations.
    Exact(u64),
    /// At most this many iterations.
    AtMost(u64),
    /// The trip count is unknown, but a counter moves steadily towards a limit.
    Ends,
    /// Nothing provably terminates the loop.
    Open,
}

impl Bound {
    /// The maximum trip count, if it is known.
    pub const fn iterations(self) -> Option<u64> {
        match self {
            Bound::Exact(iterations) | Bound::AtMost(iterations) => Some(iterations),
            Bound::Ends | Bound::Open => None,
        }
    }
}

/// All loops of a shader, in source order.
#[derive(Default, Debug)]
pub struct Loops {
    /// Sorted by statement.
    pub all: Vec<LoopFacts>,
}

impl Loops {
    /// Analyses all loops of a shader.
    pub fn of(query: Query) -> Loops {
        let module = query.module;
        let mut finder = Finder {
            module,
            function: FunctionRef(0),
            open: Vec::new(),
            found: Vec::new(),
        };
        for (number, function) in (0..).zip(&module.functions) {
            if let Some(body) = function.body {
                finder.function = FunctionRef(number);
                finder.region(body);
            }
        }
        let found = finder.found.into_iter();
        let mut all: Vec<LoopFacts> = found.filter_map(|found| found.looped(query)).collect();
        all.sort_unstable_by_key(|l| l.stmt);
        Loops { all }
    }

    /// The maximum trip count of each loop, by statement; `None` where it is unknown.
    pub fn iterations(&self) -> FxHashMap<StmtId, Option<u64>> {
        let all = self.all.iter();
        all.map(|l| (l.stmt, l.bound.iterations())).collect()
    }

    /// The facts about the loop at a statement.
    pub fn get(&self, stmt: StmtId) -> Option<&LoopFacts> {
        let at = self.all.binary_search_by_key(&stmt, |l| l.stmt).ok()?;
        self.all.get(at)
    }
}

/// A condition that must hold, or must not, for a loop to continue.
#[derive(Clone, Copy, Debug)]
struct Goes {
    condition: OpId,
    truth: bool,
}

/// A loop and its exit conditions.
#[derive(Debug)]
struct FoundLoop {
    id: LoopId,
    function: FunctionRef,
    /// Conditions that are evaluated in every iteration.
    goes: Vec<Goes>,
    ends_early: bool,
}

/// Collects the loops of a function.
struct Finder<'m> {
    module: &'m Module,
    function: FunctionRef,
    /// The enclosing loops and `switch` statements; for a loop, its index in `found`.
    open: Vec<Option<usize>>,
    found: Vec<FoundLoop>,
}

impl<'m> Visit<'m> for Finder<'m> {
    type Out = ();

    fn module(&self) -> &'m Module {
        self.module
    }

    fn looped(&mut self, id: LoopId, looped: &'m Loop) {
        let module = self.module;
        let head = looped.condition.map(|condition| Goes {
            condition,
            truth: true,
        });
        let mut goes: Vec<Goes> = head.into_iter().collect();
        // Exits at the top level of the body are evaluated in every iteration, if `continue` is
        // ignored.
        for step in module.steps(looped.body) {
            if let Step::If {
                condition,
                then,
                otherwise,
                ..
            } = *step
                && module.steps(otherwise).is_empty()
                && let Some(Step::Break(_) | Step::Return(..)) = module.steps(then).last()
            {
                goes.push(Goes {
                    condition,
                    truth: false,
                });
            }
        }
        self.open.push(Some(self.found.len()));
        self.found.push(FoundLoop {
            id,
            function: self.function,
            goes,
            ends_early: false,
        });
        looped.parts().into_iter().for_each(|p| self.region(p));
        self.open.pop();
    }

    fn switch(&mut self, switch: &'m Switch) {
        self.open.push(None);
        for case in self.module.cases(switch) {
            self.region(case.body);
        }
        self.open.pop();
    }

    fn breaks(&mut self, _: StmtId) {
        let innermost = self.open.last().copied().flatten();
        self.leave(innermost);
    }

    fn returns(&mut self, _: Option<OpId>, _: StmtId) {
        self.leave_all();
    }

    fn discards(&mut self, _: StmtId) {
        self.leave_all();
    }
}

impl Finder<'_> {
    fn leave_all(&mut self) {
        let around: Vec<usize> = self.open.iter().copied().flatten().collect();
        around.into_iter().for_each(|n| self.leave(Some(n)));
    }

    fn leave(&mut self, number: Option<usize>) {
        if let Some(found) = number.and_then(|n| self.found.get_mut(n)) {
            found.ends_early = true;
        }
    }
}
