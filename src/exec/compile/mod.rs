//! Compiles the IR to bytecode.
//!
//! All calls are inlined. A value is a list of registers, one per scalar. Operations that only
//! rename components (swizzles, constructors, loads of variables that are not written to meanwhile)
//! emit no code. Uniform code, which depends only on constants and uniforms, is hoisted into a
//! prologue that runs once per draw.

mod builtin;
mod call;
mod control;
mod emit;
mod interface;
mod lookup;
mod op;
mod place;
mod plan;
mod probe;
mod ray;
mod registers;
pub(super) mod statements;
mod steps;
mod traced;

use super::bytecode::Bytecode;
use crate::options::{CompileOptions, Refusal};
use emit::Compiler;
use shaderlint_ir::{Module, OpKind, Provenance};
use shaderlint_semantic::{FunctionRef, Program};

/// Compiles a shader, starting from its entry point.
///
/// # Errors
/// A [`Refusal`] that says what cannot be run.
pub fn compile(
    program: &Program,
    module: &Module,
    options: &CompileOptions,
) -> Result<Bytecode, Refusal> {
    let refused = |what: &str| Refusal {
        what: what.to_string(),
        at: Provenance::Language,
    };
    let entry = options.entry.or_else(|| start(program, module));
    let entry = entry.ok_or_else(|| refused("a shader without `main`"))?;
    let functions = callees_first(module, entry).ok_or_else(|| refused("recursion"))?;
    let plan = plan::plan(module, &functions);
    let mut compiler = Compiler::new(program, module, &plan, *options);
    compiler.interface();
    compiler.run(entry);
    compiler.finish()
}

/// The entry point: `main` of the shader or its host, else the function that the host calls.
pub fn start(program: &Program, module: &Module) -> Option<FunctionRef> {
    let main = program.names.get("main")?;
    let is_main = |f: &shaderlint_semantic::Function| f.name == main && f.definition.is_some();
    let at = program.functions.iter().position(is_main);
    at.map(|n| FunctionRef(n as u32)).or(module.entry)
}

/// The functions that run, in post-order (callees first); `None` if there is recursion.
fn callees_first(module: &Module, entry: FunctionRef) -> Option<Vec<FunctionRef>> {
    #[derive(Clone, Copy, PartialEq)]
    enum VisitState {
        New,
        Open,
        Done,
    }
    let mut states = vec![VisitState::New; module.functions.len()];
    let mut order = Vec::new();
    let mut stack = vec![(entry, false)];
    while let Some((function, is_done)) = stack.pop() {
        let state = states.get_mut(function.0 as usize)?;
        if is_done {
            *state = VisitState::Done;
            order.push(function);
            continue;
        }
        match *state {
            VisitState::Done => continue,
            VisitState::Open => return None,
            VisitState::New => *state = VisitState::Open,
        }
        stack.push((function, true));
        let known = module.function(function)?;
        for op in known.ops.ops() {
            if let OpKind::Call(callee, _) = module.op(op).kind
                && states.get(callee.0 as usize) != Some(&VisitState::Done)
            {
                stack.push((callee, false));
            }
        }
    }
    Some(order)
}
