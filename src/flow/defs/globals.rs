//! Which globals a call may write to.

use super::Slot;
use super::walk::Walker;
use crate::flow::Calls;
use crate::ir::{OpKind, Root};
use rustc_hash::FxHashSet;

impl Walker<'_> {
    /// By function: the slots of globals that a call of it may write to.
    pub(super) fn written_globals(&self, calls: &Calls) -> Vec<Vec<Slot>> {
        let module = self.module;
        let mut own: Vec<FxHashSet<Slot>> = vec![FxHashSet::default(); module.functions.len()];
        for (function, own) in module.functions.iter().zip(&mut own) {
            for op in function.ops.ops() {
                let OpKind::Store(place, _) = module.op(op).kind else {
                    continue;
                };
                let id = module.place(place).variable;
                let variable = module.variable(id);
                let global = variable.filter(|v| matches!(v.root, Root::Global | Root::Output));
                if let Some(variable) = global {
                    let lanes = 0..self.defs.layout.lanes(variable.ty);
                    own.extend(lanes.map(|lane| self.defs.slot(id, lane)));
                }
            }
        }
        for caller in calls.graph().bottom_up() {
            let Some(mut all) = own.get_mut(caller.0 as usize).map(std::mem::take) else {
                continue;
            };
            let called = calls.graph().callees(caller);
            all.extend(called.filter_map(|f| own.get(f.0 as usize)).flatten());
            if let Some(own) = own.get_mut(caller.0 as usize) {
                *own = all;
            }
        }
        let sorted = own.into_iter().map(|set| {
            let mut slots: Vec<Slot> = set.into_iter().collect();
            slots.sort_unstable();
            slots
        });
        sorted.collect()
    }
}
