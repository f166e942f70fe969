//! From the middle form to register code.
//!
//! Calls are inlined. A value is a list of registers, one for each scalar; what only gives parts
//! another name (swizzles, constructors, reads of variables that nothing changes meanwhile) makes no
//! code. What depends on constants and uniforms alone goes to the prologue, which runs once for all
//! pixels.

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
mod registers;

use super::code::Code;
use emit::Compiler;
use shaderlint_ir::{Module, OpId, OpKind, Provenance};
use shaderlint_semantic::{FunctionRef, Program, VariableId};
use shaderlint_text::Span;

/// How a shader is compiled.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct CompileOptions {
    /// What is watched while it runs.
    pub watch: Watch,
    /// The function that runs; that of the shader, unless one is named.
    pub entry: Option<FunctionRef>,
    /// What is given out beside what the shader gives.
    pub probe: Option<Probe>,
    /// The bits of what was never written: zero in the browser.
    pub undefined: u32,
    /// The GPU that is played.
    pub persona: Persona,
    /// How many instructions it may become, where that is fewer than 400,000.
    pub most: Option<usize>,
}

/// A GPU as exact as the conformance suite asks, and no more (VK-GL-CTS, glsBuiltinPrecisionTests).
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Persona {
    /// As exact as it gets.
    #[default]
    Exact,
    /// Off by all that is allowed.
    Inexact(Lean),
    /// Exact, but that `mediump` and `lowp` are numbers of 16 bits.
    Mobile,
}

/// To which side results are off.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Lean {
    /// Away from zero; sines up.
    Out,
    /// Towards zero; sines down.
    In,
    /// Now this, now that, by the bits of the result.
    Either,
}

/// What is looked at while a shader runs: the last moment of a pixel counts. The first four scalars of
/// it become the last but one of [`Code::outputs`]; the last is whether there was such a moment.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Probe {
    /// A variable where it is read or written.
    Variable {
        /// The variable.
        variable: VariableId,
        /// The text in which it is looked at, such as a line.
        within: Span,
    },
    /// What an operation gives.
    Value(OpId),
}

/// What is watched while a shader runs; each holds what stands before it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Debug)]
pub enum Watch {
    /// The picture alone.
    #[default]
    Nothing,
    /// Turns of loops, which branches are taken, and what pixels cost.
    Flow,
    /// Divisors that are zero, operands that leave a result undefined, and indices outside.
    Faults,
    /// The ends of comparisons.
    Comparisons,
    /// Numbers that go wrong.
    Numbers,
}

/// Why a shader is not run.
#[derive(Clone, PartialEq, Debug)]
pub struct Refusal {
    /// What cannot be run, in words.
    pub what: String,
    /// Where that stands.
    pub at: Provenance,
}

/// Compiles a shader from its entry on.
///
/// # Errors
/// What cannot be run, by name.
pub fn compile(
    program: &Program,
    module: &Module,
    options: &CompileOptions,
) -> Result<Code, Refusal> {
    let refused = |what: &str| Refusal {
        what: what.to_string(),
        at: Provenance::Language,
    };
    let entry = options.entry.or_else(|| entry(program, module));
    let entry = entry.ok_or_else(|| refused("a shader without `main`"))?;
    let functions = callees_first(module, entry).ok_or_else(|| refused("recursion"))?;
    let plan = plan::plan(module, &functions);
    let mut compiler = Compiler::new(program, module, &plan, *options);
    compiler.interface();
    compiler.run(entry);
    compiler.finish()
}

/// The `main` of the shader or of the host around it, else what the host calls.
fn entry(program: &Program, module: &Module) -> Option<FunctionRef> {
    let main = program.names.get("main")?;
    let is_main = |f: &shaderlint_semantic::Function| f.name == main && f.definition.is_some();
    let at = program.functions.iter().position(is_main);
    at.map(|n| FunctionRef(n as u32)).or(module.entry)
}

/// The functions that run, each behind all that it calls; `None` where one calls itself.
fn callees_first(module: &Module, entry: FunctionRef) -> Option<Vec<FunctionRef>> {
    #[derive(Clone, Copy, PartialEq)]
    enum State {
        New,
        Open,
        Done,
    }
    let mut states = vec![State::New; module.functions.len()];
    let mut order = Vec::new();
    let mut stack = vec![(entry, false)];
    while let Some((function, is_done)) = stack.pop() {
        let state = states.get_mut(function.0 as usize)?;
        if is_done {
            *state = State::Done;
            order.push(function);
            continue;
        }
        match *state {
            State::Done => continue,
            State::Open => return None,
            State::New => *state = State::Open,
        }
        stack.push((function, true));
        let known = module.function(function)?;
        for op in known.ops.ops() {
            if let OpKind::Call(callee, _) = module.op(op).kind
                && states.get(callee.0 as usize) != Some(&State::Done)
            {
                stack.push((callee, false));
            }
        }
    }
    Some(order)
}
