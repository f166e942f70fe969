//! Dynamic indexing.

use super::Vm;
use crate::bytecode::{ArraySite, Reg};
use crate::row::{LANES, Row};

impl Vm<'_> {
    fn site(&self, site: u32) -> ArraySite {
        let found = self.code.arrays.get(site as usize).copied();
        found.unwrap_or(ArraySite { base: 0, len: 1 })
    }

    /// By lane: the register or word at the index, clamped to the site.
    fn chosen(&self, index: Reg, site: ArraySite) -> [u32; LANES] {
        let last = site.len.saturating_sub(1);
        self.row(index).0.map(|n| site.base + n.min(last))
    }

    /// The index shared by all lanes, if it is uniform.
    fn shared(chosen: &[u32; LANES]) -> Option<u32> {
        let (first, rest) = chosen.split_first()?;
        rest.iter().all(|n| n == first).then_some(*first)
    }

    pub(super) fn gather(&mut self, to: Reg, index: Reg, site: u32) {
        let chosen = self.chosen(index, self.site(site));
        if let Some(from) = Self::shared(&chosen) {
            self.set(to, *self.row(from as Reg));
            return;
        }
        let mut made = [0; LANES];
        for ((lane, slot), from) in made.iter_mut().enumerate().zip(chosen) {
            *slot = self.lane(from as Reg, lane);
        }
        self.set(to, Row(made));
    }

    pub(super) fn scatter(&mut self, from: Reg, index: Reg, site: u32) {
        let chosen = self.chosen(index, self.site(site));
        let values = self.row(from).0;
        for ((lane, to), value) in chosen.into_iter().enumerate().zip(values) {
            if self.active >> lane & 1 == 1 {
                self.set_lane(to as Reg, lane, value);
            }
        }
    }

    pub(super) fn table(&mut self, to: Reg, index: Reg, site: u32) {
        let chosen = self.chosen(index, self.site(site));
        let word = |at: u32| self.draw.memory.get(at as usize).copied().unwrap_or(0);
        let row = match Self::shared(&chosen) {
            Some(at) => Row::splat(word(at)),
            None => Row(chosen.map(word)),
        };
        self.set(to, row);
    }

    #[expect(clippy::indexing_slicing, reason = "every register index is in bounds")]
    fn lane(&self, reg: Reg, lane: usize) -> u32 {
        self.bank[reg as usize].0[lane % LANES]
    }

    #[expect(clippy::indexing_slicing, reason = "every register index is in bounds")]
    fn set_lane(&mut self, reg: Reg, lane: usize, bits: u32) {
        self.bank[reg as usize].0[lane % LANES] = bits;
    }
}
