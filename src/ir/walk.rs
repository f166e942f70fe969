//! Traversal of regions: [`Visit`] for visitors with a method per kind of step,
//! [`Module::steps_in`] to iterate over all steps.

use crate::form::{
    Case, Loop, LoopId, Module, OpId, Provenance, Region, Run, Step, Switch, SwitchId,
};
use shaderlint_syntax::ast::StmtId;

/// The result of a visit.
pub trait Visited {
    /// The result that continues the traversal.
    const GO: Self;

    /// Whether the traversal stops here.
    fn stops(&self) -> bool;
}

impl Visited for () {
    const GO: () = ();

    fn stops(&self) -> bool {
        false
    }
}

impl<E> Visited for Result<(), E> {
    const GO: Self = Ok(());

    fn stops(&self) -> bool {
        self.is_err()
    }
}

/// A visitor of regions, with one method per kind of step. The default methods visit what is
/// inside, in evaluation order.
pub trait Visit<'m>: Sized {
    /// The result of a visit; one that [stops](Visited::stops) ends the traversal.
    type Out: Visited;

    /// The module being visited.
    fn module(&self) -> &'m Module;

    /// Visits the steps of a region.
    fn region(&mut self, region: Region) -> Self::Out {
        each(self.module().steps(region), |step| self.step(step))
    }

    /// Dispatches a step to the method for its kind.
    fn step(&mut self, step: &Step) -> Self::Out {
        let module = self.module();
        match *step {
            Step::Run(run) => self.run(run),
            Step::If {
                condition,
                then,
                otherwise,
                origin,
            } => self.branch(condition, [then, otherwise], origin),
            Step::Loop(id) => match module.looped(id) {
                Some(looped) => self.looped(id, looped),
                None => Visited::GO,
            },
            Step::Switch(id) => match module.switch(id) {
                Some(switch) => self.switch(switch),
                None => Visited::GO,
            },
            Step::Break(stmt) => self.breaks(stmt),
            Step::Continue(stmt) => self.continues(stmt),
            Step::Return(value, stmt) => self.returns(value, stmt),
            Step::Discard(stmt) => self.discards(stmt),
        }
    }

    /// Visits the operations of a run, in order.
    fn run(&mut self, run: Run) -> Self::Out {
        each(run.ops(), |op| self.op(op))
    }

    /// Visits an operation.
    fn op(&mut self, _: OpId) -> Self::Out {
        Visited::GO
    }

    /// Visits both sides of a branch.
    fn branch(&mut self, _: OpId, sides: [Region; 2], _: Provenance) -> Self::Out {
        each(sides, |side| self.region(side))
    }

    /// Visits the regions of a loop.
    fn looped(&mut self, _: LoopId, looped: &'m Loop) -> Self::Out {
        each(looped.parts(), |part| self.region(part))
    }

    /// Visits the cases of a `switch`.
    fn switch(&mut self, switch: &'m Switch) -> Self::Out {
        each(self.module().cases(switch), |case| self.region(case.body))
    }

    /// `break`
    fn breaks(&mut self, _: StmtId) -> Self::Out {
        Visited::GO
    }

    /// `continue`
    fn continues(&mut self, _: StmtId) -> Self::Out {
        Visited::GO
    }

    /// `return`
    fn returns(&mut self, _: Option<OpId>, _: StmtId) -> Self::Out {
        Visited::GO
    }

    /// `discard`
    fn discards(&mut self, _: StmtId) -> Self::Out {
        Visited::GO
    }
}

/// Visits items in sequence until one stops.
fn each<T, O: Visited>(all: impl IntoIterator<Item = T>, mut visit: impl FnMut(T) -> O) -> O {
    for one in all {
        let out = visit(one);
        if out.stops() {
            return out;
        }
    }
    O::GO
}

impl Loop {
    /// The regions of the loop, in the order in which an iteration runs them.
    pub const fn parts(&self) -> [Region; 3] {
        match self.tests_first {
            true => [self.test, self.body, self.step],
            false => [self.body, self.step, self.test],
        }
    }
}

impl Step {
    /// Whether it is `break`, `continue`, `return` or `discard`.
    pub const fn is_jump(&self) -> bool {
        use Step::*;
        matches!(self, Break(_) | Continue(_) | Return(..) | Discard(_))
    }
}

/// See [`Module::steps_in`].
struct Steps<'m> {
    module: &'m Module,
    /// The remaining steps, in reverse order.
    todo: Vec<&'m Step>,
}

impl<'m> Iterator for Steps<'m> {
    type Item = &'m Step;

    fn next(&mut self) -> Option<&'m Step> {
        let step = self.todo.pop()?;
        for region in self.module.inside(step).into_iter().rev() {
            self.todo.extend(self.module.steps(region).iter().rev());
        }
        Some(step)
    }
}

impl Module {
    /// The cases of a `switch`; empty if the id belongs to another module.
    pub fn cases_of(&self, id: SwitchId) -> &[Case] {
        self.switch(id).map_or(&[], |switch| self.cases(switch))
    }

    /// The regions of a step, in the order in which they run.
    pub fn inside(&self, step: &Step) -> Vec<Region> {
        match *step {
            Step::If {
                then, otherwise, ..
            } => vec![then, otherwise],
            Step::Loop(id) => self.looped(id).map_or(Vec::new(), |l| l.parts().to_vec()),
            Step::Switch(id) => self.cases_of(id).iter().map(|case| case.body).collect(),
            _ => Vec::new(),
        }
    }

    /// Iterates over steps and all steps inside them, in pre-order.
    pub fn steps_in<'m>(&'m self, steps: &'m [Step]) -> impl Iterator<Item = &'m Step> {
        Steps {
            module: self,
            todo: steps.iter().rev().collect(),
        }
    }
}
