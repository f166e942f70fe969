//! The current definition of each component during the walk, and merges where paths join.

use super::def::{Def, DefId, ReachingDefinitions, Slot};
use super::walk::{Changes, Walker};
use shaderlint_ir::{OpId, Root};
use shaderlint_syntax::ast::List;
use shaderlint_text::SetAt;

impl Walker<'_> {
    pub(super) fn is_full(&self) -> bool {
        self.defs.defs.len() + self.defs.lists.len() > self.limit
    }

    pub(super) fn define(&mut self, def: Def) -> DefId {
        if self.is_full() {
            return ReachingDefinitions::UNKNOWN;
        }
        let id = DefId(self.defs.defs.len() as u32);
        let unrefined = match def {
            Def::Refined { of, .. } => self.defs.unrefined(of),
            _ => id,
        };
        self.defs.defs.push(def);
        self.defs.unrefined.push(unrefined);
        id
    }

    pub(super) fn list(&mut self, all: &[DefId]) -> List {
        let start = self.defs.lists.len() as u32;
        if self.is_full() {
            return List { start, len: 0 };
        }
        self.defs.lists.extend_from_slice(all);
        List {
            start,
            len: all.len() as u32,
        }
    }

    pub(super) fn root(&self, slot: Slot) -> Option<Root> {
        let (id, _) = self.defs.variable_at(slot);
        self.module.variable(id).map(|v| v.root)
    }

    /// The current definition of a slot.
    pub(super) fn get(&mut self, slot: Slot) -> DefId {
        if let Some(def) = self.current.get(slot.0 as usize).copied().flatten() {
            return def;
        }
        if let Some(entry) = self.entries.get(slot.0 as usize).copied().flatten() {
            return entry;
        }
        let entry = self.define(Def::Entry(slot));
        self.entries.set_at(slot.0 as usize, Some(entry));
        entry
    }

    pub(super) fn set(&mut self, slot: Slot, def: DefId) {
        if let Some(place) = self.current.get_mut(slot.0 as usize) {
            self.trail.push((slot, *place));
            *place = Some(def);
        }
    }

    pub(super) fn roll_back(&mut self, mark: usize) {
        while self.trail.len() > mark {
            if let Some((slot, before)) = self.trail.pop()
                && let Some(place) = self.current.get_mut(slot.0 as usize)
            {
                *place = before;
            }
        }
    }

    /// The slots that changed since a point in the trail, with their current definitions.
    pub(super) fn changes(&mut self, mark: usize) -> Changes {
        self.stamp += 1;
        let trail = self.trail.get(mark..).unwrap_or(&[]);
        let mut changes = Vec::with_capacity(trail.len().min(16));
        for (slot, _) in trail {
            let Some(stamp) = self.stamps.get_mut(slot.0 as usize) else {
                continue;
            };
            if *stamp != self.stamp {
                *stamp = self.stamp;
                let now = self.current.get(slot.0 as usize).copied().flatten();
                changes.extend(now.map(|def| (*slot, def)));
            }
        }
        changes
    }

    /// Adopts the changes of the only path that continues.
    pub(super) fn apply(&mut self, changes: &Changes) {
        for &(slot, def) in changes {
            self.set(slot, def);
        }
    }

    /// Merges several paths, each given by its changes since the current point. `since` is the
    /// first definition made on any of them.
    pub(super) fn merge(&mut self, ways: &[Changes], since: DefId, condition: Option<OpId>) {
        let count = ways.iter().map(Vec::len).sum();
        let mut all: Vec<(Slot, u32, DefId)> = Vec::with_capacity(count);
        for (way, changes) in (0..).zip(ways) {
            all.extend(changes.iter().map(|(slot, def)| (*slot, way, *def)));
        }
        all.sort_unstable();
        let mut sides = Vec::with_capacity(ways.len());
        for group in all.chunk_by(|a, b| a.0 == b.0) {
            let Some(&(slot, ..)) = group.first() else {
                continue;
            };
            let is_known = self.current.get(slot.0 as usize).copied().flatten();
            // A local without a definition was declared on one of the paths.
            if is_known.is_none() && self.root(slot) == Some(Root::Local) {
                continue;
            }
            let before = match group.len() < ways.len() || is_known.is_some() {
                true => Some(self.get(slot)),
                false => None,
            };
            sides.clear();
            let mut changed = group.iter().peekable();
            for way in 0..ways.len() as u32 {
                let here = changed.next_if(|(_, w, _)| *w == way);
                sides.extend(here.map(|(.., def)| *def).or(before));
            }
            self.join(slot, &sides, before, since, condition);
        }
    }

    /// Defines a slot as the merge of the definitions on several paths.
    pub(super) fn join(
        &mut self,
        slot: Slot,
        sides: &[DefId],
        before: Option<DefId>,
        since: DefId,
        condition: Option<OpId>,
    ) {
        let strip = |defs: &ReachingDefinitions, mut def: DefId| {
            while def >= since
                && let Def::Refined { of, .. } = defs.get(def)
            {
                def = of;
            }
            def
        };
        let first = sides.first().map(|side| strip(&self.defs, *side));
        let Some(first) = first else { return };
        if sides.iter().all(|side| strip(&self.defs, *side) == first) {
            if before != Some(first) {
                self.set(slot, first);
            }
            return;
        }
        let is_choice = self.root(slot) == Some(Root::Temporary);
        let sides = self.list(sides);
        let merge = self.define(Def::Merge {
            sides,
            condition,
            is_choice,
        });
        self.set(slot, merge);
    }
}
