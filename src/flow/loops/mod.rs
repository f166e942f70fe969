//! The loops of a shader, and what ends them.

mod bound;
mod halving;
mod pace;
#[cfg(test)]
mod tests;

use super::ranges::Query;
use rustc_hash::FxHashMap;
use shaderlint_ir::{Loop, LoopId, Module, OpId, Step, Switch, Visit};
use shaderlint_semantic::{FunctionRef, VariableId};
use shaderlint_syntax::ast::{ExprId, StmtId};

/// A loop.
#[derive(Clone, Copy, Debug)]
pub struct LoopFacts {
    /// The statement.
    pub stmt: StmtId,
    /// The function around it.
    pub function: FunctionRef,
    /// How often it turns.
    pub bound: Bound,
    /// The variable that counts the turns.
    pub counter: Option<VariableId>,
    /// What the counter is compared with.
    pub limit: Option<ExprId>,
    /// Where the limit's number stands: the limit itself, or the argument of a call where it is a
    /// parameter.
    pub given: Option<ExprId>,
    /// Whether something besides the counter may end it: `break`, `return`, a second condition.
    pub ends_early: bool,
}

/// How often a loop turns each time that it is reached.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Bound {
    /// Just as often.
    Exact(u64),
    /// As often, or less.
    AtMost(u64),
    /// Nobody knows how often, but a counter goes steadily towards a limit.
    Ends,
    /// Nothing ends it for certain.
    Open,
}

impl Bound {
    /// The most turns, if they are known.
    pub const fn turns(self) -> Option<u64> {
        match self {
            Bound::Exact(turns) | Bound::AtMost(turns) => Some(turns),
            Bound::Ends | Bound::Open => None,
        }
    }
}

/// All loops of a shader, in the order of the tree.
#[derive(Default, Debug)]
pub struct Loops {
    /// The loops.
    pub all: Vec<LoopFacts>,
}

impl Loops {
    /// Finds the loops of a shader.
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

    /// By statement: the most turns, where they are known.
    pub fn turns(&self) -> FxHashMap<StmtId, Option<u64>> {
        let all = self.all.iter();
        all.map(|l| (l.stmt, l.bound.turns())).collect()
    }

    /// The loop that a statement is.
    pub fn get(&self, stmt: StmtId) -> Option<&LoopFacts> {
        let at = self.all.binary_search_by_key(&stmt, |l| l.stmt).ok()?;
        self.all.get(at)
    }
}

/// A condition that is true, or false, as long as a loop goes on.
#[derive(Clone, Copy, Debug)]
struct Goes {
    condition: OpId,
    truth: bool,
}

/// A loop, and what may end it.
#[derive(Debug)]
struct Found {
    id: LoopId,
    function: FunctionRef,
    /// Conditions that each turn looks at.
    goes: Vec<Goes>,
    ends_early: bool,
}

/// Looks for loops.
struct Finder<'m> {
    module: &'m Module,
    function: FunctionRef,
    /// The loops and `switch` statements around; of loops, their number in `found`.
    open: Vec<Option<usize>>,
    found: Vec<Found>,
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
        // What runs at each turn: the steps of the body itself, as if it had no `continue`.
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
        self.found.push(Found {
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
