//! Which writes are ever read.

use super::defs::{Def, DefId, Defs, Slot};
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_ir::{Module, OpId, OpKind, Root};
use shaderlint_semantic::VariableId;

/// How far behind a call stands what it gives back.
const MAX_BEHIND: usize = 64;

/// The definitions of a shader that some read sees.
#[derive(Default, Debug)]
pub struct Live {
    /// By definition: whether a read sees it, through whatever ways come together.
    seen: Vec<bool>,
    /// The slots whose value from before the function a read sees.
    entries: FxHashSet<Slot>,
    /// By value that is stored: whether a read sees it where it is stored.
    stored: FxHashMap<OpId, bool>,
    /// The lanes of stored values that a read sees.
    lanes: FxHashSet<(OpId, u32)>,
    is_complete: bool,
}

impl Live {
    /// Follows all reads of a shader back.
    pub fn of(module: &Module, defs: &Defs) -> Live {
        let mut live = Live {
            seen: vec![false; defs.len() as usize],
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
            match live.seen.get_mut(def.0 as usize) {
                Some(seen) if !*seen => *seen = true,
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
                let is_seen = live.seen.get(number as usize) == Some(&true);
                *live.stored.entry(value).or_default() |= is_seen;
                if is_seen {
                    live.lanes.insert((value, lane));
                }
            }
        }
        live
    }

    /// Whether no read sees a value in any place where it is stored.
    pub fn is_lost(&self, value: OpId) -> bool {
        self.is_complete && self.stored.get(&value) == Some(&false)
    }

    /// Whether the caller makes use of a lane of what a call leaves in the parameter with a number.
    pub fn is_taken(&self, module: &Module, call: OpId, position: usize, lane: u32) -> bool {
        let behind = (call.0 + 1..module.ops.len() as u32).map(OpId);
        let mut behind = behind.take(MAX_BEHIND);
        let returned = behind.find(|op| match module.op(*op).kind {
            OpKind::Returned(of, number) => of == call && number as usize == position,
            _ => false,
        });
        let Some(value) = returned.filter(|_| self.is_complete) else {
            return true;
        };
        let target = behind.find_map(|op| match module.op(op).kind {
            OpKind::Store(place, stored) if stored == value => Some(module.place(place)),
            _ => None,
        });
        // What outlives the function, and elements, of which it is not known which are read.
        let is_own = target.is_some_and(|place| {
            let variable = module.variable(place.variable);
            variable.is_some_and(|v| {
                matches!(v.root, Root::Local | Root::Temporary | Root::Parameter) && v.ty.array == 0
            })
        });
        !is_own || self.lanes.contains(&(value, lane))
    }

    /// Whether no read sees what a variable of so many lanes held when its function began.
    pub fn is_unseen(&self, defs: &Defs, variable: VariableId, lanes: u32) -> bool {
        let mut slots = (0..lanes).map(|lane| defs.slot(variable, lane));
        self.is_complete && !slots.any(|slot| self.entries.contains(&slot))
    }
}
