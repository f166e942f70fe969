//! Calls that take derivatives between neighbouring pixels, and the code that parts the pixels.

use super::calls::Calls;
use super::uniformity::{ControlId, Uniformity, Varying};
use shaderlint_ir::{LoopId, Module, OpId, OpKind};
use shaderlint_semantic::{BuiltinId, FunctionRef};

/// A call that compares neighbouring pixels, in code that not all of them run.
#[derive(Clone, Copy, Debug)]
pub struct Gradient {
    /// The call.
    pub call: OpId,
    /// The built-in function.
    pub function: BuiltinId,
    /// What parts the pixels.
    pub parted: Parted,
}

/// What parts neighbouring pixels.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Parted {
    /// A loop that some leave before others; the call stands in it, or in a function that is called
    /// from it.
    Loop(LoopId),
    /// A branch, or a return before.
    Branch(ControlId),
}

/// The calls that take derivatives where the pixels may have parted, in the order of evaluation.
pub fn gradients<'a>(
    module: &Module,
    calls: &Calls,
    uniformity: impl Fn() -> &'a Uniformity,
) -> Vec<Gradient> {
    let ops = (0..).map(OpId).zip(&module.ops);
    let mut taken = ops
        .filter_map(|(call, made)| match made.kind {
            OpKind::Builtin(function, operands) if function.kind().takes_derivatives() => {
                Some((call, function, operands))
            }
            _ => None,
        })
        .peekable();
    // What differs is found only for those that ask.
    if taken.peek().is_none() {
        return Vec::new();
    }
    let uniformity = uniformity();
    let mut found = Vec::new();
    let mut looped: Option<Vec<Option<LoopId>>> = None;
    for (call, function, operands) in taken {
        // What is the same everywhere has no slope; a sampler always is.
        let mut operands = module.operands(operands).iter();
        if !uniformity.is_divergent(call)
            || !operands.any(|o| uniformity.varies(Varying::Value(*o)))
        {
            continue;
        }
        let Some(control) = uniformity.control_of(call) else {
            continue;
        };
        let around = loop_around(uniformity, control).or_else(|| {
            let from = looped.get_or_insert_with(|| called_from(module, calls, uniformity));
            let function = uniformity.control(control)?.function?;
            from.get(function.0 as usize).copied().flatten()
        });
        found.push(Gradient {
            call,
            function,
            parted: around.map_or(Parted::Branch(control), Parted::Loop),
        });
    }
    found
}

/// The innermost loop around code that some pixels leave before others.
fn loop_around(uniformity: &Uniformity, control: ControlId) -> Option<LoopId> {
    let mut at = uniformity.control(control)?.looped;
    while let Some(looped) = at {
        let turns = uniformity.turns(looped)?;
        // A loop that only some pixels reach is not yet one that they leave apart.
        let parting = uniformity.control(turns.inside)?.parting;
        if parting.is_some_and(|p| uniformity.varies(Varying::Parting(p))) {
            return Some(looped);
        }
        at = uniformity.control(turns.outside)?.looped;
    }
    None
}

/// By function: a loop that pixels leave apart from which it is called, directly or not.
fn called_from(module: &Module, calls: &Calls, uniformity: &Uniformity) -> Vec<Option<LoopId>> {
    let mut from: Vec<Option<LoopId>> = vec![None; module.functions.len()];
    let around = |op| loop_around(uniformity, uniformity.control_of(op)?);
    let looped = calls.all().iter();
    let mut todo: Vec<(FunctionRef, LoopId)> = looped
        .filter_map(|call| Some((call.callee, around(call.op)?)))
        .collect();
    // A loop of its own is nearer than that of a caller, so the calls in loops come first.
    let mut done = 0;
    while let Some(&(function, looped)) = todo.get(done) {
        done += 1;
        if let Some(slot @ None) = from.get_mut(function.0 as usize) {
            *slot = Some(looped);
            todo.extend(calls.graph().callees(function).map(|f| (f, looped)));
        }
    }
    from
}
