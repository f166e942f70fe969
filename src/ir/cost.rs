//! The cost of code, in operations: the unit of estimates and of runs.

use super::form::{Module, OpId, OpKind, Provenance, Step};

impl Module {
    /// The cost of an operation: 1 for arithmetic, more for built-in functions, nothing for moving
    /// values. A call costs what it calls.
    pub fn cost(&self, op: OpId) -> u32 {
        match self.op(op).kind {
            OpKind::Unary(..)
            | OpKind::Binary(..)
            | OpKind::MatrixProduct(..)
            | OpKind::Same { .. }
            | OpKind::Select { .. } => 1,
            OpKind::Builtin(function, _) => function.cost() as u32,
            _ => 0,
        }
    }

    /// The cost of a step itself, without the regions inside it: `?:`, `&&` and `||` are one
    /// operation.
    pub fn step_cost(&self, step: &Step) -> u32 {
        self.step_costs(step).map(|(_, cost)| cost).sum()
    }

    /// The operations of a step itself that cost something, with their costs.
    pub fn step_costs(&self, step: &Step) -> impl Iterator<Item = (Provenance, u32)> {
        let (run, own) = match *step {
            Step::Run(run) => (Some(run), None),
            Step::If {
                origin: origin @ Provenance::Expr(_),
                ..
            } => (None, Some((origin, 1))),
            _ => (None, None),
        };
        let ops = run.into_iter().flat_map(|run| run.ops());
        let ops = ops.map(|op| (self.provenance(op), self.cost(op)));
        ops.chain(own).filter(|(_, cost)| *cost > 0)
    }
}
