//! Liveness: the definitions that reach a read.

use super::reaching_definitions::{Def, DefId, ReachingDefinitions, Slot};
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_ir::{Module, OpId, OpKind, Root};
use shaderlint_semantic::VariableId;

/// Operations after a call that are searched for the stores of its `out` parameters.
const MAX_AFTER: usize = 64;

/// The live definitions of a shader: those that reach a read.
#[derive(Default, Debug)]
pub struct Liveness {
    /// By definition: whether it reaches a read, directly or through merges.
    read: Vec<bool>,
    /// The slots whose value on function entry reaches a read.
    entries: FxHashSet<Slot>,
    /// By stored value: whether one of its stores reaches a read.
    stored: FxHashMap<OpId, bool>,
    /// The components of stored values that reach a read.
    lanes: FxHashSet<(OpId, u32)>,
    is_complete: bool,
}

impl Liveness {
    /// Computes liveness backwards from all loads.
    pub fn of(module: &Module, defs: &ReachingDefinitions) -> Liveness {
        let mut live = Liveness {
            read: vec![false; defs.len() as usize],
            entries: FxHashSet::default(),
            stored: FxHashMap::default(),
            lanes: FxHashSet::default(),
            is_complete: defs.is_complete,
        };
        let mut todo: Vec<DefId> = Vec::new();
        for (op, made) in (0..).map(OpId).zip(&module.ops) {
            if let OpKind::Load(_) = made.kind {
                todo.extend((0..defs.lanes_of(op)).map(|lane| defs.seen(op, lane)));
            }
        }
        while let Some(def) = todo.pop() {
            match live.read.get_mut(def.0 as usize) {
                Some(read) if !*read => *read = true,
                _ => continue,
            }
            match defs.get(def) {
                Def::Measured(sides) | Def::Merge { sides, .. } => todo.extend(defs.list(sides)),
                Def::Head { init, back, .. } => todo.extend([init, back]),
                Def::Refined { of, .. } => todo.push(of),
                Def::Entry(slot) => {
                    live.entries.insert(slot);
                }
                Def::Stored { .. } | Def::Unknown => {}
            }
        }
        for number in 0..defs.len() {
            if let Def::Stored { value, lane } = defs.get(DefId(number)) {
                let is_read = live.read.get(number as usize) == Some(&true);
                *live.stored.entry(value).or_default() |= is_read;
                if is_read {
                    live.lanes.insert((value, lane));
                }
            }
        }
        live
    }

    /// Whether every store of a value is dead.
    pub fn is_lost(&self, value: OpId) -> bool {
        self.is_complete && self.stored.get(&value) == Some(&false)
    }

    /// Whether the caller may read a component of what a call writes back to the parameter at an
    /// index.
    pub fn is_taken(&self, module: &Module, call: OpId, position: usize, lane: u32) -> bool {
        let after = (call.0 + 1..module.ops.len() as u32).map(OpId);
        let mut after = after.take(MAX_AFTER);
        let returned = after.find(|op| match module.op(*op).kind {
            OpKind::Returned(of, number) => of == call && number as usize == position,
            _ => false,
        });
        let Some(value) = returned.filter(|_| self.is_complete) else {
            return true;
        };
        let target = after.find_map(|op| match module.op(op).kind {
            OpKind::Store(place, stored) if stored == value => Some(module.place(place)),
            _ => None,
        });
        // Variables that outlive the function may be read elsewhere, and elements of arrays are not
        // told apart.
        let is_own = target.is_some_and(|place| {
            let variable = module.variable(place.variable);
            variable.is_some_and(|v| {
                matches!(v.root, Root::Local | Root::Temporary | Root::Parameter) && v.ty.array == 0
            })
        });
        !is_own || self.lanes.contains(&(value, lane))
    }

    /// Whether the value of a variable on function entry is never read. The variable has `lanes`
    /// slots.
    pub fn is_unseen(&self, defs: &ReachingDefinitions, variable: VariableId, lanes: u32) -> bool {
        let mut slots = (0..lanes).map(|lane| defs.slot(variable, lane));
        self.is_complete && !slots.any(|slot| self.entries.contains(&slot))
    }
}
