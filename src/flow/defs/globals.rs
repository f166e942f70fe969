//! Which globals a call may write to.

use super::Slot;
use super::walk::Walker;
use crate::ir::{OpKind, Root};
use rustc_hash::FxHashSet;

impl Walker<'_> {
    /// By function: the slots of globals that a call of it may write to.
    pub(super) fn written_globals(&self) -> Vec<Vec<Slot>> {
        let module = self.module;
        let count = module.functions.len();
        let mut own: Vec<FxHashSet<Slot>> = vec![FxHashSet::default(); count];
        let mut callees: Vec<Vec<u32>> = vec![Vec::new(); count];
        for (number, function) in module.functions.iter().enumerate() {
            let (Some(own), Some(callees)) = (own.get_mut(number), callees.get_mut(number)) else {
                continue;
            };
            for op in function.ops.ops() {
                match module.op(op).kind {
                    OpKind::Store(place, _) => {
                        let id = module.place(place).variable;
                        let variable = module.variable(id);
                        let is_global =
                            variable.is_some_and(|v| matches!(v.root, Root::Global | Root::Output));
                        if is_global && let Some(variable) = variable {
                            let lanes = 0..self.defs.layout.lanes(variable.ty);
                            own.extend(lanes.map(|lane| self.defs.slot(id, lane)));
                        }
                    }
                    OpKind::Call(callee, _) => callees.push(callee.0),
                    _ => {}
                }
            }
        }
        reach(own, &callees)
    }
}

/// Adds to what each function writes what those that it calls write.
fn reach(mut own: Vec<FxHashSet<Slot>>, callees: &[Vec<u32>]) -> Vec<Vec<Slot>> {
    // A function is mostly defined behind those that it calls, so one or two rounds do.
    for _ in 0..callees.len().min(64) {
        let mut is_changed = false;
        for (number, callees) in callees.iter().enumerate() {
            for &callee in callees {
                if callee as usize == number {
                    continue;
                }
                let called = own.get(callee as usize).cloned().unwrap_or_default();
                if let Some(own) = own.get_mut(number) {
                    let before = own.len();
                    own.extend(called);
                    is_changed |= own.len() > before;
                }
            }
        }
        if !is_changed {
            break;
        }
    }
    let sorted = own.into_iter().map(|set| {
        let mut slots: Vec<Slot> = set.into_iter().collect();
        slots.sort_unstable();
        slots
    });
    sorted.collect()
}
