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
        match *step {
            Step::Run(run) => run.ops().map(|op| self.cost(op)).sum(),
            Step::If {
                origin: Provenance::Expr(_),
                ..
            } => 1,
            _ => 0,
        }
    }
}
