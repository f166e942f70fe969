//! Marks the statements at which a debugger can stop, and records where variables are.
//!
//! So that every variable in scope has its value wherever the code stops, variables live until
//! their function ends, and loads and stores neither share registers nor write inactive lanes.

use super::emit::{CallFrame, Compiler, Value};
use crate::bytecode::{Instr, InstrIndex, Location, StopKind, StopSite};
use shaderlint_ir::{Module, OpId, OpKind, Provenance, Step};
use shaderlint_semantic::{FunctionRef, Type, VariableId};
use shaderlint_syntax::ast::{Extent, StmtKind, TokenId, Tree};

/// What a debugger stops at: simple statements, conditions, and steps of loops.
#[derive(Default)]
pub(super) struct Statements {
    /// Disjoint, in source order.
    extents: Vec<Extent>,
}

impl Statements {
    pub fn of(tree: &Tree) -> Statements {
        let statements = tree.stmts.iter().filter_map(|stmt| match stmt.kind {
            StmtKind::Expr(_) | StmtKind::Decl(_) | StmtKind::Return(_) => Some(stmt.extent),
            StmtKind::Break | StmtKind::Continue | StmtKind::Discard => Some(stmt.extent),
            StmtKind::If { condition, .. } | StmtKind::Do { condition, .. } => {
                Some(tree.expr(condition).extent)
            }
            StmtKind::Switch { selector, .. } => Some(tree.expr(selector).extent),
            StmtKind::For { step, .. } => step.map(|step| tree.expr(step).extent),
            _ => None,
        });
        // Local declarations are inside statements.
        let declarations = tree.decls.iter().map(|decl| decl.extent);
        let mut extents: Vec<Extent> = statements.chain(declarations).collect();
        extents.sort_by_key(|e| (e.first, std::cmp::Reverse(e.last)));
        let mut end = None;
        extents.retain(|extent| {
            let is_outer = end.is_none_or(|end| extent.first > end);
            if is_outer {
                end = Some(extent.last);
            }
            is_outer
        });
        Statements { extents }
    }

    fn at(&self, token: TokenId) -> Option<Extent> {
        let after = self.extents.partition_point(|e| e.first <= token);
        let extent = self.extents.get(after.checked_sub(1)?)?;
        (token <= extent.last).then_some(*extent)
    }
}

/// The statements of a function at which code with [`CompileOptions::steps`] can stop, in source
/// order.
///
/// [`CompileOptions::steps`]: super::options::CompileOptions::steps
pub fn statements(tree: &Tree, module: &Module, function: FunctionRef) -> Vec<Extent> {
    let all = Statements::of(tree);
    let Some(found) = module.function(function) else {
        return Vec::new();
    };
    let body = found.body.map_or(&[][..], |body| module.steps(body));
    let jumps = module.steps_in(body).filter_map(|step| match step {
        Step::Break(stmt) | Step::Continue(stmt) | Step::Discard(stmt) => Some(*stmt),
        Step::Return(_, stmt) => Some(*stmt),
        _ => None,
    });
    let ops = found.ops.ops().filter(|op| !computes_nothing(module, *op));
    let origins = ops.map(|op| module.provenance(op));
    let origins = origins.chain(jumps.map(Provenance::Stmt));
    let mut extents: Vec<Extent> = origins
        .filter_map(|origin| all.at(origin.extent(tree)?.first))
        .collect();
    extents.sort_by_key(|extent| extent.first);
    extents.dedup();
    extents
}

/// Whether an operation belongs to a declaration without initial value.
fn computes_nothing(module: &Module, op: OpId) -> bool {
    let is_undefined = |op: OpId| module.op(op).kind == OpKind::Undef;
    match module.op(op).kind {
        OpKind::Store(_, value) => is_undefined(value),
        _ => is_undefined(op),
    }
}

impl Compiler<'_> {
    /// Marks the start of the statement of an operation. Declarations that compute nothing are none.
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
