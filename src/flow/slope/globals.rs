//! Global variables that a function reads and others write: their values when it is called.
//!
//! A variable with one assignment, that runs once and whatever the pixel is, has the same value at all
//! calls: a rotation that `main` computes.

use super::execute::{ScalarValues, SymbolicExecution};
use super::node::Scalars;
use crate::ranges::Query;
use shaderlint_ir::{Module, OpId, OpKind, Region, Root, Step};
use shaderlint_semantic::{FunctionRef, VariableId};

/// Most nested calls that are followed to an assignment.
const MAX_DEPTH: u32 = 8;

/// By variable: whether a function writes to it, and it is global.
pub(super) fn written(module: &Module) -> Vec<bool> {
    let mut written = vec![false; module.variables.len()];
    for (_, variable) in stores(module) {
        if let Some(slot) = written.get_mut(variable.0 as usize) {
            *slot = true;
        }
    }
    written
}

/// The assignments of global variables in functions.
fn stores(module: &Module) -> impl Iterator<Item = (OpId, VariableId)> {
    let ops = module.functions.iter().flat_map(|f| f.ops.ops());
    ops.filter_map(|op| match module.op(op).kind {
        OpKind::Store(place, _) => {
            let variable = module.place(place).variable;
            let is_global = module.variable(variable)?.root == Root::Global;
            is_global.then_some((op, variable))
        }
        _ => None,
    })
}

/// The values of such variables when a function is called first.
pub(super) fn known_globals(
    query: Query,
    written: &[bool],
    scalars: &mut Scalars,
    function: FunctionRef,
) -> Vec<(VariableId, ScalarValues)> {
    let module = query.module;
    let main = query.program.names.get("main");
    let mut functions = (0..).map(FunctionRef).zip(&query.program.functions);
    let main = functions.find(|(_, f)| Some(f.name) == main && f.definition.is_some());
    let Some(entry) = main.map(|(id, _)| id).or(module.entry) else {
        return Vec::new();
    };
    let all: Vec<(OpId, VariableId)> = stores(module).collect();
    let once = all.iter().filter(|(op, variable)| {
        let is_only = all.iter().filter(|(_, other)| other == variable).count() == 1;
        is_only && runs_once(module, entry, *op, MAX_DEPTH)
    });
    let once: Vec<VariableId> = once.map(|(_, variable)| *variable).collect();
    if once.is_empty() {
        return Vec::new();
    }
    let mut execution = SymbolicExecution::new((query.program, module), written, scalars);
    execution.run_until(entry, function, &once)
}

/// Whether an operation runs exactly once: in straight-line code of functions that are called once.
fn runs_once(module: &Module, entry: FunctionRef, op: OpId, depth: u32) -> bool {
    let functions = (0..).map(FunctionRef).zip(&module.functions);
    let mut around = functions.filter(|(_, f)| f.ops.contains(op));
    let Some(((id, function), rest)) = around.next().zip(depth.checked_sub(1)) else {
        return false;
    };
    let has = |body: Region| {
        let mut steps = module.steps(body).iter();
        // What follows a jump may not run.
        let before = steps.position(|step| matches!(step, Step::Run(run) if run.contains(op)));
        let before = before.and_then(|at| module.steps(body).get(..at));
        before.is_some_and(|steps| {
            let leaves = |step: &Step| matches!(step, Step::Return(..) | Step::Discard(_));
            !module.steps_in(steps).any(leaves)
        })
    };
    if !function.body.is_some_and(has) {
        return false;
    }
    if id == entry {
        return true;
    }
    let ops = (0..).map(OpId).zip(&module.ops);
    let mut calls = ops.filter(|(_, op)| matches!(op.kind, OpKind::Call(f, _) if f == id));
    match (calls.next(), calls.next()) {
        (Some((call, _)), None) => runs_once(module, entry, call, rest),
        _ => false,
    }
}
