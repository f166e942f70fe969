//! The one walk through the regions of a module: [`Visit`] for whoever has a meaning for each kind
//! of step, [`Module::steps_in`] for whoever only looks for some.

use crate::form::{
    Case, Loop, LoopId, Module, OpId, Provenance, Region, Run, Step, Switch, SwitchId,
};
use shaderlint_syntax::ast::StmtId;

/// What a visit of something gives.
pub trait Visited {
    /// That of what there is nothing to say of.
    const GO: Self;

    /// Whether the visit ends here.
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

/// A visitor of regions. Each kind of step has a method, which does nothing but visit what is
/// inside, in the order of evaluation.
pub trait Visit<'m>: Sized {
    /// What a visit gives; one that [stops](Visited::stops) ends all.
    type Out: Visited;

    /// The module that is visited.
    fn module(&self) -> &'m Module;

    /// Visits the steps of a region.
    fn region(&mut self, region: Region) -> Self::Out {
        each(self.module().steps(region), |step| self.step(step))
    }

    /// Visits a step by the method of its kind.
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

    /// Operations, in order.
    fn run(&mut self, run: Run) -> Self::Out {
        each(run.ops(), |op| self.op(op))
    }

    /// An operation.
    fn op(&mut self, _: OpId) -> Self::Out {
        Visited::GO
    }

    /// What runs where a condition is true, and where it is false.
    fn branch(&mut self, _: OpId, sides: [Region; 2], _: Provenance) -> Self::Out {
        each(sides, |side| self.region(side))
    }

    /// A loop.
    fn looped(&mut self, _: LoopId, looped: &'m Loop) -> Self::Out {
        each(looped.parts(), |part| self.region(part))
    }

    /// A `switch`.
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

/// Visits one after another until one stops.
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
    /// Its regions, in the order in which a turn runs them.
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
    /// What comes next, last first.
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
    /// The cases of the `switch` with this number; none where it is not this module's.
    pub fn cases_of(&self, id: SwitchId) -> &[Case] {
        self.switch(id).map_or(&[], |switch| self.cases(switch))
    }

    /// The regions that a step consists of, in the order in which they are run.
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

    /// All of some steps and of what is inside of them, each before what it consists of.
    pub fn steps_in<'m>(&'m self, steps: &'m [Step]) -> impl Iterator<Item = &'m Step> {
        Steps {
            module: self,
            todo: steps.iter().rev().collect(),
        }
    }
}
