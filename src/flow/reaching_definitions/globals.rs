//! Globals that a call may write to, and purity of functions.

use super::Slot;
use super::walk::Walker;
use crate::calls::Calls;
use rustc_hash::FxHashSet;
use shaderlint_ir::{OpKind, Root};
use shaderlint_semantic::VariableId;
use shaderlint_text::SetAt;

impl Walker<'_> {
    /// By function: whether it is pure: it writes nothing shared and reads no mutable global.
    pub(super) fn pure_functions(&self, calls: &Calls) -> Vec<bool> {
        let module = self.module;
        let written: FxHashSet<Slot> = self.writes.iter().flatten().copied().collect();
        let changes = |op| {
            let OpKind::Load(place) = module.op(op).kind else {
                return false;
            };
            let id = module.place(place).variable;
            let variable = module.variable(id);
            let lanes = variable.map_or(0, |v| self.defs.layout.lanes(v.ty));
            let is_global = variable.is_some_and(|v| matches!(v.root, Root::Global | Root::Output));
            is_global && (0..lanes).any(|lane| written.contains(&self.defs.slot(id, lane)))
        };
        let goes_back = |id: &VariableId| {
            let root = module.variable(*id).map(|v| v.root);
            matches!(root, Some(Root::ParameterOut | Root::ParameterInout))
        };
        let numbered = module.functions.iter().zip(&self.writes);
        let mut pure: Vec<bool> = numbered
            .map(|(function, writes)| {
                writes.is_empty()
                    && !module.parameters(function).iter().any(goes_back)
                    && (written.is_empty() || !function.ops.ops().any(changes))
            })
            .collect();
        for caller in calls.graph.bottom_up() {
            let is_pure = calls
                .graph
                .callees(caller)
                .all(|f| pure.get(f.0 as usize) == Some(&true));
            if let Some(own) = pure.get_mut(caller.0 as usize) {
                *own &= is_pure;
            }
        }
        pure
    }

    /// By function: the slots of globals that a call of it may write to, directly or indirectly.
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
        for caller in calls.graph.bottom_up() {
            let Some(mut all) = own.get_mut(caller.0 as usize).map(std::mem::take) else {
                continue;
            };
            let called = calls.graph.callees(caller);
            all.extend(called.filter_map(|f| own.get(f.0 as usize)).flatten());
            own.set_at(caller.0 as usize, all);
        }
        let sorted = own.into_iter().map(|set| {
            let mut slots: Vec<Slot> = set.into_iter().collect();
            slots.sort_unstable();
            slots
        });
        sorted.collect()
    }
}
