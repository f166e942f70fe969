//! The state of a VM that runs a single quad.

use super::{ActiveLanes, Vm};
use crate::row::{QUAD, quad_of, row_of};

/// The state between two instructions. All lanes hold copies of one quad.
pub(crate) struct VmState {
    bank: Vec<[u32; QUAD]>,
    masks: Vec<u32>,
    active: u32,
    live: u32,
    fuel: u64,
    once: u64,
    at: usize,
}

impl Vm<'_> {
    /// The lanes that are active.
    pub const fn active(&self) -> u32 {
        self.active
    }

    /// The lanes that are not discarded.
    pub const fn live(&self) -> u32 {
        self.live
    }

    /// The index of the next instruction.
    pub const fn next_instruction(&self) -> usize {
        self.at
    }

    /// A copy of the state.
    pub fn state(&self) -> VmState {
        VmState {
            bank: self.bank.iter().map(quad_of).collect(),
            masks: self.masks.clone(),
            active: self.active,
            live: self.live,
            fuel: self.fuel,
            once: self.once,
            at: self.at,
        }
    }

    /// Goes to a state of the same code and quad.
    pub fn restore(&mut self, state: &VmState) {
        for (row, quad) in self.bank.iter_mut().zip(&state.bank) {
            *row = row_of(*quad);
        }
        self.masks.clone_from(&state.masks);
        (self.active, self.live) = (state.active, state.live);
        (self.fuel, self.once, self.at) = (state.fuel, state.once, state.at);
        self.expanded = ActiveLanes::of(self.active, self.requested);
        self.watched.faults.clear();
        self.written.clear();
    }
}
