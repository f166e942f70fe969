//! Where a program stops: statements, and the functions that run there.

use shaderlint_exec::{Bytecode, StopKind, StopSite};
use shaderlint_ir::{Module, OpId};
use shaderlint_semantic::{FunctionRef, Program};
use shaderlint_syntax::ast::Extent;
use shaderlint_text::Span;

/// A site of the code, with what stepping needs.
#[derive(Clone, Copy, Debug)]
pub struct StopPlace {
    /// The statement.
    pub extent: Extent,
    /// Its source range.
    pub span: Span,
    /// Whether the user wrote it.
    pub is_user: bool,
    /// The number of functions that run.
    pub depth: u32,
    /// The call that returned, for a stop after a call.
    pub returned: Option<OpId>,
}

/// A function that runs.
#[derive(Clone, Copy, Debug)]
pub struct StackFrame {
    /// The function; `None` for global initialisers.
    pub function: Option<FunctionRef>,
    /// The statement that it executes.
    pub extent: Extent,
    /// The source range of the statement, or of the call.
    pub span: Span,
}

/// All places of a program, by site.
pub struct StopPlaces(Vec<StopPlace>);

impl StopPlaces {
    pub fn of(program: &Program, code: &Bytecode) -> StopPlaces {
        let places = code.stops().iter().map(|site| {
            let span = program.span(site.extent);
            StopPlace {
                extent: site.extent,
                span,
                is_user: program.sources.is_user(span.start),
                depth: code.frames(site).count() as u32,
                returned: match site.kind {
                    StopKind::Statement => None,
                    StopKind::Return(call, _) => Some(call),
                },
            }
        });
        StopPlaces(places.collect())
    }

    /// The place of a site.
    pub fn at(&self, site: u32) -> Option<&StopPlace> {
        self.0.get(site as usize)
    }

    /// All places.
    pub fn iter(&self) -> impl Iterator<Item = &StopPlace> {
        self.0.iter()
    }
}

/// The functions of the user that run at a site, innermost first.
pub fn frames(
    program: &Program,
    module: &Module,
    code: &Bytecode,
    site: &StopSite,
) -> Vec<StackFrame> {
    let mut extent = site.extent;
    let mut span = program.span(extent);
    let mut frames = Vec::new();
    for (function, call) in code.frames(site) {
        if program.sources.is_user(span.start) {
            frames.push(StackFrame {
                function,
                extent,
                span,
            });
        }
        let called = call.and_then(|call| module.provenance(call).extent(&program.tree));
        if let Some(called) = called {
            extent = called;
            span = program.span(called);
        }
    }
    frames
}
