//! What rules ask for about a shader as a whole. Each answer is made at the first question.

use super::words::{Counts, Unseen};
use crate::semantic::flow::{CallGraph, Effects, Loops, Reach, Structure, Usage};
use crate::semantic::{Dialect, FunctionRef, Program};
use crate::text::Span;
use std::cell::OnceCell;

/// Answers about one shader.
pub struct Facts<'a, 'p> {
    program: &'a Program<'p>,
    structure: OnceCell<Structure>,
    calls: OnceCell<CallGraph>,
    loops: OnceCell<Loops>,
    entry: OnceCell<Option<FunctionRef>>,
    effects: OnceCell<Effects>,
    usage: OnceCell<Usage>,
    reach: OnceCell<Reach>,
    unseen: OnceCell<Unseen<'p>>,
    counts: OnceCell<Counts<'p>>,
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
            effects: OnceCell::new(),
            usage: OnceCell::new(),
            reach: OnceCell::new(),
            unseen: OnceCell::new(),
            counts: OnceCell::new(),
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

    /// Which expressions and functions do more than give a value.
    pub fn effects(&self) -> &Effects {
        self.effects
            .get_or_init(|| Effects::of(self.program, self.structure(), self.calls()))
    }

    /// How each variable is used.
    pub fn usage(&self) -> &Usage {
        self.usage
            .get_or_init(|| Usage::of(self.program, self.structure()))
    }

    /// Behind which statements nothing runs.
    pub fn reach(&self) -> &Reach {
        self.reach.get_or_init(|| Reach::of(self.program))
    }

    /// The words that the compiler does not see.
    pub fn unseen(&self) -> &Unseen<'p> {
        self.unseen.get_or_init(|| Unseen::of(self.program))
    }

    /// How often each word stands in the user's files.
    pub fn counts(&self) -> &Counts<'p> {
        self.counts.get_or_init(|| Counts::of(self.program))
    }

    /// Addresses of the last file, which is nobody's else: what it declares is used in it or not at
    /// all. A file before it, such as ShaderToy's Common, belongs to other passes too. `None` where
    /// nothing runs, because the text is a part that others make use of.
    pub fn own_file(&self) -> Option<Span> {
        self.entry()?;
        let end = self.program.tokens.tokens.last()?.span.start;
        Some(self.program.sources.file_at(end)?.span())
    }
}
