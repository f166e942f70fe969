//! What is known of a module while it is looked at, and what is wrong with it.

use crate::form::{Module, OpId};
use crate::layout::Layout;
use shaderlint_semantic::builtins::Builtins;
use shaderlint_semantic::{FunctionRef, Program, Type};
use std::fmt;

/// Something that a module must not have.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Problem {
    /// The operation; `None` where it is of no single one.
    pub op: Option<OpId>,
    /// What is wrong.
    pub text: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.op {
            Some(op) => write!(f, "%{}: {}", op.0, self.text),
            None => f.write_str(&self.text),
        }
    }
}

/// What is around the step that is looked at.
#[derive(Clone, Copy, Default)]
pub(super) struct StepContext {
    pub function: Option<FunctionRef>,
    /// Inside how many loops.
    pub loops: u32,
    /// Inside how many loops and `switch` statements.
    pub breakable: u32,
}

/// The walk over a module.
pub(super) struct Verifier<'a> {
    pub program: &'a Program,
    pub layout: Layout,
    pub module: &'a Module,
    pub builtins: &'static Builtins,
    pub at: StepContext,
    /// The operation that the next run must start with: all of them stand in runs, in order.
    pub next: u32,
    /// By operation: whether its value is there on every path to here.
    pub defined: Vec<bool>,
    /// The operations that are defined, in order.
    pub trail: Vec<OpId>,
    /// By step: whether a region that was looked at has it.
    pub seen: Vec<bool>,
    pub problems: Vec<Problem>,
}

impl Verifier<'_> {
    /// A problem of no single operation.
    pub fn tell(&mut self, text: impl Into<String>) {
        let text = match self.at.function.and_then(|f| self.program.function(f)) {
            Some(f) => format!("`{}`: {}", self.program.names.text(f.name), text.into()),
            None => text.into(),
        };
        self.problems.push(Problem { op: None, text });
    }

    pub fn tell_op(&mut self, op: OpId, text: impl Into<String>) {
        let text = text.into();
        self.problems.push(Problem { op: Some(op), text });
    }

    pub fn name(&self, ty: Type) -> String {
        self.program.type_name(ty)
    }
}
