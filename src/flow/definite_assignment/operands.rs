//! Operands whose values may not be needed.

use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_ir::{Binary, Module, OpId, OpKind, Place};
use shaderlint_semantic::{Direction, Program, VariableId};
use shaderlint_text::SetAt;

/// By load passed as an argument: the `inout` parameter that receives it; `None` for a parameter whose
/// value is unused or unknown.
pub(super) fn handed(
    program: &Program,
    module: &Module,
    ignored: &FxHashSet<VariableId>,
) -> FxHashMap<OpId, Option<VariableId>> {
    let mut handed = FxHashMap::default();
    for op in &module.ops {
        if let OpKind::Call(id, list) = op.kind
            && let Some(function) = program.function(id)
        {
            let parameters = module.function(id).map(|f| module.parameters(f));
            let arguments = module.operands(list).iter().zip(&function.params);
            for (i, (argument, given)) in arguments.enumerate() {
                let parameter = parameters.and_then(|p| p.get(i)).copied();
                if given.direction == Direction::Inout {
                    handed.insert(*argument, parameter);
                } else if parameter.is_some_and(|p| ignored.contains(&p)) {
                    handed.insert(*argument, None);
                }
            }
        }
    }
    handed
}

/// By operation: whether it is an operand of `?:`, `&&` or `||` whose value may not be used.
pub(super) fn chosen(module: &Module) -> Vec<bool> {
    let mut chosen = vec![false; module.ops.len()];
    let mark = |chosen: &mut Vec<bool>, op: OpId| {
        chosen.set_at(op.0 as usize, true);
    };
    for op in (0..module.ops.len() as u32).rev().map(OpId) {
        match module.op(op).kind {
            OpKind::Select {
                then, otherwise, ..
            } => {
                mark(&mut chosen, then);
                mark(&mut chosen, otherwise);
            }
            OpKind::Binary(Binary::And | Binary::Or, _, right) => mark(&mut chosen, right),
            _ => {}
        }
        if chosen.get(op.0 as usize) == Some(&true) {
            module.each_operand(op, |o| mark(&mut chosen, o));
        }
    }
    for op in (0..module.ops.len() as u32).map(OpId) {
        let is_certain = chosen.get(op.0 as usize) == Some(&false);
        if let OpKind::Select {
            then, otherwise, ..
        } = module.op(op).kind
            && is_certain
        {
            clear_common(module, [then, otherwise], &mut chosen);
        }
    }
    chosen
}

/// What both arms of `?:` load is loaded whatever the condition is.
fn clear_common(module: &Module, arms: [OpId; 2], chosen: &mut [bool]) {
    let arms = arms.map(|arm| loads(module, arm));
    for (load, place) in arms.iter().flatten() {
        let is_same = |other: &Place| {
            other.variable == place.variable && module.path(other) == module.path(place)
        };
        let reads = |arm: &Vec<(OpId, &Place)>| arm.iter().any(|(_, other)| is_same(other));
        if let Some(slot) = chosen.get_mut(load.0 as usize)
            && arms.iter().all(reads)
        {
            *slot = false;
        }
    }
}

/// Most operations of an arm of `?:` that are searched for loads.
const MAX_ARM: usize = 64;

/// The loads that an arm of `?:` always executes, without those of nested `?:`, `&&` and `||`.
fn loads(module: &Module, arm: OpId) -> Vec<(OpId, &Place)> {
    let mut found = Vec::new();
    let mut todo = vec![arm];
    for _ in 0..MAX_ARM {
        let Some(op) = todo.pop() else { break };
        match module.op(op).kind {
            OpKind::Load(place) => found.push((op, module.place(place))),
            OpKind::Select { condition, .. } => todo.push(condition),
            OpKind::Binary(Binary::And | Binary::Or, left, _) => todo.push(left),
            _ => module.each_operand(op, |o| todo.push(o)),
        }
    }
    found
}
