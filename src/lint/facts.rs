//! What rules ask for about a shader as a whole. Each answer is made at the first question.

use crate::semantic::flow::{CallGraph, Loops, Structure};
use crate::semantic::{Dialect, FunctionRef, Program};
use crate::text::embed::Host;
use std::cell::OnceCell;

/// Answers about one shader.
pub struct Facts<'a, 'p> {
    program: &'a Program<'p>,
    structure: OnceCell<Structure>,
    calls: OnceCell<CallGraph>,
    loops: OnceCell<Loops>,
    entry: OnceCell<Option<FunctionRef>>,
    /// The page or script that the shader stands in.
    pub host: Host,
}

impl<'a, 'p> Facts<'a, 'p> {
    /// Nothing has been asked yet.
    pub fn new(program: &'a Program<'p>) -> Facts<'a, 'p> {
        Facts {
            program,
            structure: OnceCell::new(),
            calls: OnceCell::new(),
            loops: OnceCell::new(),
            entry: OnceCell::new(),
            host: Host::default(),
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
