//! Register allocation with reference counts.

use crate::bytecode::{MAX_REGISTERS, Reg};
use rustc_hash::FxHashMap;
use shaderlint_semantic::VariableId;
use shaderlint_text::SetAt;

/// The reference count of a permanent register.
const FOREVER: u32 = u32::MAX;

#[derive(Default)]
pub(super) struct Registers {
    /// By register: the reference count.
    holders: Vec<u32>,
    /// By register: whether it is uniform (the same for all pixels of a draw).
    uniform: Vec<bool>,
    /// By register: the variable that owns it.
    owners: Vec<Option<VariableId>>,
    free: Vec<Reg>,
    /// Free blocks of consecutive registers, by length.
    free_rows: FxHashMap<u32, Vec<Reg>>,
    /// Whether allocation has failed.
    pub is_full: bool,
}

impl Registers {
    fn add(&mut self, count: u32, holders: u32, is_uniform: bool) -> Reg {
        let first = self.holders.len();
        if first + count as usize > MAX_REGISTERS {
            self.is_full = true;
            return 0;
        }
        let all = first + count as usize;
        self.holders.resize(all, holders);
        self.uniform.resize(all, is_uniform);
        self.owners.resize(all, None);
        first as Reg
    }

    /// Allocates a register with reference count one.
    pub fn fresh(&mut self) -> Reg {
        match self.free.pop() {
            Some(reg) => {
                self.set_holders(reg, 1);
                reg
            }
            None => self.add(1, 1, false),
        }
    }

    /// Allocates a permanent uniform register.
    pub fn uniform(&mut self) -> Reg {
        self.add(1, FOREVER, true)
    }

    /// Allocates consecutive registers for a variable, with reference count one or permanent.
    pub fn row(&mut self, count: u32, variable: VariableId, is_forever: bool) -> Reg {
        let found = match count {
            1 => self.free.pop(),
            _ => self.free_rows.get_mut(&count).and_then(Vec::pop),
        };
        let first = found.unwrap_or_else(|| self.add(count, 1, false));
        for at in 0..count {
            let reg = first.saturating_add(at as Reg);
            self.set_holders(reg, if is_forever { FOREVER } else { 1 });
            self.owners.set_at(reg as usize, Some(variable));
        }
        first
    }

    /// The variable that owns a register.
    pub fn owner(&self, reg: Reg) -> Option<VariableId> {
        self.owners.get(reg as usize).copied().flatten()
    }

    /// Whether a register is uniform.
    pub fn is_uniform(&self, reg: Reg) -> bool {
        self.uniform.get(reg as usize) == Some(&true)
    }

    /// Whether the reference count is one.
    pub fn is_held_once(&self, reg: Reg) -> bool {
        self.holders.get(reg as usize) == Some(&1)
    }

    /// The number of registers allocated so far.
    pub const fn count(&self) -> usize {
        self.holders.len()
    }

    fn set_holders(&mut self, reg: Reg, holders: u32) {
        self.holders.set_at(reg as usize, holders);
    }

    /// Increments the reference count.
    pub fn retain(&mut self, reg: Reg) {
        if let Some(holders) = self.holders.get_mut(reg as usize)
            && *holders != FOREVER
        {
            *holders += 1;
        }
    }

    /// Decrements the reference count, and frees the register at zero.
    pub fn release(&mut self, reg: Reg) {
        let Some(holders) = self.holders.get_mut(reg as usize) else {
            return;
        };
        match *holders {
            0 | FOREVER => {}
            1 => {
                *holders = 0;
                self.owners.set_at(reg as usize, None);
                self.free.push(reg);
            }
            _ => *holders -= 1,
        }
    }

    /// Releases the registers of a variable. They stay consecutive if nothing else holds one of
    /// them.
    pub fn release_row(&mut self, first: Reg, count: u32) {
        let regs = || (0..count).map(|at| first.saturating_add(at as Reg));
        if count == 1 || !regs().all(|reg| self.is_held_once(reg)) {
            regs().for_each(|reg| self.release(reg));
            return;
        }
        for reg in regs() {
            self.set_holders(reg, 0);
            self.owners.set_at(reg as usize, None);
        }
        self.free_rows.entry(count).or_default().push(first);
    }
}
