//! Calls with implicit derivatives in non-uniform control flow.

use super::calls::Calls;
use super::uniformity::{ControlId, Uniformity, Varying};
use shaderlint_ir::{LoopId, Module, OpId, OpKind};
use shaderlint_semantic::{BuiltinId, FunctionRef};

/// A call with implicit derivatives in non-uniform control flow, where they are undefined.
#[derive(Clone, Copy, Debug)]
pub struct Gradient {
    /// The `Builtin` operation.
    pub call: OpId,
    /// The called built-in function.
    pub function: BuiltinId,
    /// The cause of the divergence.
    pub cause: DivergenceCause,
}

/// The cause of divergence around a call.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DivergenceCause {
    /// A loop that pixels exit at different iterations, around the call or around a call of its
    /// function.
    Loop(LoopId),
    /// A divergent branch, or an earlier `return`, `break` or `continue` that only some pixels
    /// execute.
    Branch(ControlId),
}

/// All calls with implicit derivatives in non-uniform control flow, in evaluation order.
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
    // Uniformity is computed only if a call needs derivatives.
    if taken.peek().is_none() {
        return Vec::new();
    }
    let uniformity = uniformity();
    let mut found = Vec::new();
    let mut looped: Option<Vec<Option<LoopId>>> = None;
    for (call, function, operands) in taken {
        // Derivatives of uniform values are zero wherever they are taken. Samplers are always
        // uniform.
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
            cause: around.map_or(DivergenceCause::Branch(control), DivergenceCause::Loop),
        });
    }
    found
}

/// The innermost loop around a control that pixels exit at different iterations.
fn loop_around(uniformity: &Uniformity, control: ControlId) -> Option<LoopId> {
    let mut at = uniformity.control(control)?.looped;
    while let Some(looped) = at {
        let loop_controls = uniformity.loop_controls(looped)?;
        // Entering a loop divergently is not enough: pixels must exit it at different iterations.
        let divergence = uniformity.control(loop_controls.inside)?.divergence;
        if divergence.is_some_and(|p| uniformity.varies(Varying::Divergence(p))) {
            return Some(looped);
        }
        at = uniformity.control(loop_controls.outside)?.looped;
    }
    None
}

/// By function: a loop with divergent exit from which it is called, directly or indirectly.
fn called_from(module: &Module, calls: &Calls, uniformity: &Uniformity) -> Vec<Option<LoopId>> {
    let mut from: Vec<Option<LoopId>> = vec![None; module.functions.len()];
    let around = |op| loop_around(uniformity, uniformity.control_of(op)?);
    let looped = calls.all.iter();
    let mut todo: Vec<(FunctionRef, LoopId)> = looped
        .filter_map(|call| Some((call.callee, around(call.op)?)))
        .collect();
    // Breadth-first from the calls in loops, so that a nearer loop is found before that of a
    // caller.
    let mut done = 0;
    while let Some(&(function, looped)) = todo.get(done) {
        done += 1;
        if let Some(slot @ None) = from.get_mut(function.0 as usize) {
            *slot = Some(looped);
            todo.extend(calls.graph.callees(function).map(|f| (f, looped)));
        }
    }
    from
}
