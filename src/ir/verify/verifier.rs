//! The state of the verifier, and its findings.

use crate::form::{Module, OpId};
use crate::layout::Layout;
use shaderlint_semantic::builtins::Builtins;
use shaderlint_semantic::{FunctionRef, Program, Type};
use std::fmt;

/// A violation of the rules of the IR.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Violation {
    /// The operation; `None` if it concerns several or none.
    pub op: Option<OpId>,
    /// The description of the violation.
    pub text: String,
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.op {
            Some(op) => write!(f, "%{}: {}", op.0, self.text),
            None => f.write_str(&self.text),
        }
    }
}

/// The context of the current step.
#[derive(Clone, Copy, Default)]
pub(super) struct StepContext {
    pub function: Option<FunctionRef>,
    /// The number of enclosing loops.
    pub loops: u32,
    /// The number of enclosing loops and `switch` statements.
    pub breakable: u32,
}

/// The walk over a module.
pub(super) struct Verifier<'a> {
    pub program: &'a Program,
    pub layout: Layout,
    pub module: &'a Module,
    pub builtins: Builtins,
    pub at: StepContext,
    /// The operation with which the next run must start: runs cover all operations in order.
    pub next: u32,
    /// By operation: whether it dominates the current point, i.e. its value is defined.
    pub defined: Vec<bool>,
    /// The defined operations, in order.
    pub trail: Vec<OpId>,
    /// By step: whether a region contains it.
    pub seen: Vec<bool>,
    pub problems: Vec<Violation>,
}

impl Verifier<'_> {
    /// Records a violation that concerns no single operation.
    pub fn report(&mut self, text: impl Into<String>) {
        let text = match self.at.function.and_then(|f| self.program.function(f)) {
            Some(f) => format!("`{}`: {}", self.program.names.text(f.name), text.into()),
            None => text.into(),
        };
        self.problems.push(Violation { op: None, text });
    }

    pub fn report_op(&mut self, op: OpId, text: impl Into<String>) {
        let text = text.into();
        self.problems.push(Violation { op: Some(op), text });
    }

    pub fn name(&self, ty: Type) -> String {
        self.program.type_name(ty)
    }
}
