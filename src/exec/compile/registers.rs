//! Which registers are taken, and by how many values.

use crate::code::{MAX_REGISTERS, Reg};
use rustc_hash::FxHashMap;
use shaderlint_semantic::VariableId;

/// How often a register is held that is never given back.
const FOREVER: u32 = u32::MAX;

/// The registers.
#[derive(Default)]
pub(super) struct Registers {
    /// By register: how many values hold it.
    holders: Vec<u32>,
    /// By register: whether it is the same for all pixels of a draw.
    uniform: Vec<bool>,
    /// By register: the variable that it belongs to.
    owners: Vec<Option<VariableId>>,
    free: Vec<Reg>,
    /// Rows of neighbours, by how many they are.
    free_rows: FxHashMap<u32, Vec<Reg>>,
    /// Whether there were too few.
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

    /// One that holds a value, held once.
    pub fn fresh(&mut self) -> Reg {
        match self.free.pop() {
            Some(reg) => {
                self.set_holders(reg, 1);
                reg
            }
            None => self.add(1, 1, false),
        }
    }

    /// One that is never given back and is the same for all pixels.
    pub fn uniform(&mut self) -> Reg {
        self.add(1, FOREVER, true)
    }

    /// Neighbours for a variable, held once, or forever.
    pub fn row(&mut self, count: u32, variable: VariableId, is_forever: bool) -> Reg {
        let found = match count {
            1 => self.free.pop(),
            _ => self.free_rows.get_mut(&count).and_then(Vec::pop),
        };
        let first = found.unwrap_or_else(|| self.add(count, 1, false));
        for at in 0..count {
            let reg = first.saturating_add(at as Reg);
            self.set_holders(reg, if is_forever { FOREVER } else { 1 });
            if let Some(owner) = self.owners.get_mut(reg as usize) {
                *owner = Some(variable);
            }
        }
        first
    }

    /// The variable that a register belongs to.
    pub fn owner(&self, reg: Reg) -> Option<VariableId> {
        self.owners.get(reg as usize).copied().flatten()
    }

    /// Whether it is the same for all pixels of a draw.
    pub fn is_uniform(&self, reg: Reg) -> bool {
        self.uniform.get(reg as usize) == Some(&true)
    }

    /// Whether one value alone holds it.
    pub fn is_held_once(&self, reg: Reg) -> bool {
        self.holders.get(reg as usize) == Some(&1)
    }

    /// How many there are.
    pub const fn count(&self) -> usize {
        self.holders.len()
    }

    fn set_holders(&mut self, reg: Reg, holders: u32) {
        if let Some(slot) = self.holders.get_mut(reg as usize) {
            *slot = holders;
        }
    }

    /// One value more holds it.
    pub fn retain(&mut self, reg: Reg) {
        if let Some(holders) = self.holders.get_mut(reg as usize)
            && *holders != FOREVER
        {
            *holders += 1;
        }
    }

    /// One value less holds it.
    pub fn release(&mut self, reg: Reg) {
        let Some(holders) = self.holders.get_mut(reg as usize) else {
            return;
        };
        match *holders {
            0 | FOREVER => {}
            1 => {
                *holders = 0;
                if let Some(owner) = self.owners.get_mut(reg as usize) {
                    *owner = None;
                }
                self.free.push(reg);
            }
            _ => *holders -= 1,
        }
    }

    /// A variable needs its neighbours no more; they stay together if nothing else holds one.
    pub fn release_row(&mut self, first: Reg, count: u32) {
        let regs = || (0..count).map(|at| first.saturating_add(at as Reg));
        if count == 1 || !regs().all(|reg| self.is_held_once(reg)) {
            regs().for_each(|reg| self.release(reg));
            return;
        }
        for reg in regs() {
            self.set_holders(reg, 0);
            if let Some(owner) = self.owners.get_mut(reg as usize) {
                *owner = None;
            }
        }
        self.free_rows.entry(count).or_default().push(first);
    }
}
