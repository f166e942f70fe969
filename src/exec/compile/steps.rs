//! Marks the statements at which a debugger can stop, and records where variables are.
//!
//! So that every variable in scope has its value wherever the code stops, variables live until
//! their function ends, and loads and stores neither share registers nor write inactive lanes.

use super::emit::{CallFrame, Compiler, Value};
use super::statements::computes_nothing;
use crate::bytecode::{Instr, InstrIndex, Location, StopKind, StopSite};
use shaderlint_ir::{OpId, Provenance};
use shaderlint_semantic::{Type, VariableId};
use shaderlint_syntax::ast::Extent;

impl Compiler<'_> {
    /// Marks the start of the statement of an operation. Declarations that compute nothing are not
    /// statements.
    pub fn stop_at(&mut self, op: OpId) {
        if self.options.steps && !computes_nothing(self.module, op) {
            self.stop_before(self.module.provenance(op));
        }
    }

    /// Marks the start of a statement, unless its code has begun.
    pub fn stop_before(&mut self, origin: Provenance) {
        if !self.options.steps {
            return;
        }
        let Some(extent) = self.statement_of(origin) else {
            return;
        };
        let Some(frame) = self.frames.last_mut() else {
            return;
        };
        if frame.stop != Some(extent) {
            frame.stop = Some(extent);
            let path = frame.path;
            self.stop(extent, path, StopKind::Statement);
        }
    }

    /// Marks the place after a call, where the caller goes on.
    pub fn stop_after(&mut self, call: OpId, returned: Value) {
        if !self.options.steps {
            return;
        }
        let Some((extent, path)) = self.frames.last().and_then(|f| Some((f.stop?, f.path))) else {
            return;
        };
        self.stop(extent, path, StopKind::Return(call, location(returned)));
    }

    /// Marks the end of a function that is not left by a value, and of the entry point.
    pub fn stop_at_end(&mut self, frame: &CallFrame) {
        if !self.options.steps {
            return;
        }
        let known = self.program.function(frame.function);
        let body = known.and_then(|f| self.program.tree.function(f.definition?));
        let returns = self.module.function(frame.function).map(|f| f.returns);
        let is_end = self.frames.is_empty() || returns.is_some_and(Type::is_void);
        if let Some(body) = body.filter(|_| is_end) {
            self.stop(
                Extent::token(body.extent.last),
                frame.path,
                StopKind::Statement,
            );
        }
    }

    /// Lets the next statement be marked even if it was: another iteration starts.
    pub fn forget_stop(&mut self) {
        if let Some(frame) = self.frames.last_mut() {
            frame.stop = None;
        }
    }

    fn stop(&mut self, extent: Extent, path: u32, kind: StopKind) {
        let debug = &mut self.code.debug;
        let site = debug.stops.len() as u32;
        let known = debug.statements.len() as u32;
        let statement = *self.statement_sites.entry(extent.first).or_insert(known);
        if statement == known {
            debug.statements.push(extent);
        }
        debug.stops.push(StopSite {
            extent,
            kind,
            statement,
            path,
        });
        self.push(Instr::Stop(site));
    }

    fn statement_of(&self, origin: Provenance) -> Option<Extent> {
        self.statements.at(origin.extent(&self.program.tree)?.first)
    }

    /// Records where a variable is from here on.
    pub fn locate(&mut self, variable: VariableId, value: Value) {
        if !self.options.steps {
            return;
        }
        let here = self.here();
        let locations = &mut self.code.debug.locations;
        let at = variable.0 as usize;
        if locations.len() <= at {
            locations.resize(at + 1, Vec::new());
        }
        if let Some(own) = locations.get_mut(at) {
            let found = location(value);
            let known: Option<&mut (InstrIndex, Location)> = own.last_mut();
            match known {
                Some((from, last)) if *from == here => *last = found,
                _ => own.push((here, found)),
            }
        }
    }
}

const fn location(value: Value) -> Location {
    match value {
        Value::Nothing => Location::None,
        Value::Regs(regs) => Location::Registers {
            start: regs.start,
            len: regs.len,
        },
        Value::Memory { at, len } => Location::Memory { at, len },
        Value::Samplers(first) => Location::Sampler(first),
    }
}
