//! Operands whose values may not be needed.

use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_ir::{Binary, Module, OpId, OpKind};
use shaderlint_semantic::{Direction, Program, VariableId};

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
        if let Some(slot) = chosen.get_mut(op.0 as usize) {
            *slot = true;
        }
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
    chosen
}
