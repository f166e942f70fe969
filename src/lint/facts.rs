//! What rules ask for about a shader as a whole. Each answer is made at the first question.

use crate::semantic::flow::range::{Evaluator, Range, Ranges};
use crate::semantic::flow::{CallGraph, Loops, Paths, Structure};
use crate::semantic::{Dialect, FunctionRef, Program};
use crate::syntax::ast::ExprId;
use std::cell::OnceCell;

/// Answers about one shader.
pub struct Facts<'a, 'p> {
    program: &'a Program<'p>,
    structure: OnceCell<Structure>,
    calls: OnceCell<CallGraph>,
    loops: OnceCell<Loops>,
    ranges: OnceCell<Ranges>,
    paths: OnceCell<Paths>,
    entry: OnceCell<Option<FunctionRef>>,
}

impl<'a, 'p> Facts<'a, 'p> {
    /// Nothing has been asked yet.
    pub fn new(program: &'a Program<'p>) -> Facts<'a, 'p> {
        Facts {
            program,
            structure: OnceCell::new(),
            calls: OnceCell::new(),
            loops: OnceCell::new(),
            ranges: OnceCell::new(),
            paths: OnceCell::new(),
            entry: OnceCell::new(),
        }
    }

    /// Which node stands in which.
    pub fn structure(&self) -> &Structure {
        self.structure.get_or_init(|| Structure::of(self.program))
    }

    /// Who calls whom.
    pub fn calls(&self) -> &CallGraph {
        self.calls.get_or_init(|| CallGraph::of(self.program))
    }

    /// The loops.
    pub fn loops(&self) -> &Loops {
        self.loops
            .get_or_init(|| Loops::of(self.program, self.structure(), self.calls()))
    }

    /// What has a value when, on the paths through the functions.
    pub fn paths(&self) -> &Paths {
        self.paths
            .get_or_init(|| Paths::of(self.program, self.structure()))
    }

    /// What numbers expressions may take.
    pub fn ranges(&self) -> Evaluator<'_, 'p> {
        let structure = self.structure();
        Evaluator {
            program: self.program,
            structure,
            ranges: self
                .ranges
                .get_or_init(|| Ranges::of(self.program, structure)),
        }
    }

    /// What numbers the components of a number or vector may be.
    pub fn range(&self, expr: ExprId) -> Vec<Range> {
        self.ranges().components(expr).collect()
    }

    /// The function that draws: `mainImage` and its kin, or `main`.
    pub fn entry(&self) -> Option<FunctionRef> {
        *self.entry.get_or_init(|| {
            let program = self.program;
            let name = match program.dialect {
                Dialect::ShaderToy(pass) => pass.entry()?,
                Dialect::WebGl { .. } => "main",
            };
            let is_entry = |name| {
                let functions = program.functions.iter();
                let mut defined = functions
                    .enumerate()
                    .filter(|(_, f)| f.definition.is_some());
                defined.position(|(_, f)| program.names.text(f.name) == name)
            };
            is_entry(name).map(|i| FunctionRef(i as u32))
        })
    }
}
