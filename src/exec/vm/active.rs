//! The execution mask.

use crate::row::{LANES, Row};

/// An execution mask, and what follows from it.
pub(crate) struct ActiveLanes {
    pub mask: u32,
    /// The register with all bits set in its lanes.
    pub lanes: Row,
    requested: u32,
    /// The number of its lanes that are requested.
    pub pixels: u32,
}

impl ActiveLanes {
    pub fn of(mask: u32, requested: u32) -> ActiveLanes {
        let requested = mask & requested;
        ActiveLanes {
            mask,
            lanes: spread(mask),
            requested,
            pixels: requested.count_ones(),
        }
    }

    /// The number of requested lanes that are in another mask, too.
    #[inline(always)]
    pub const fn requested_where(&self, holds: u32) -> u32 {
        // Without hardware that counts bits, counting takes longer than comparing.
        match self.requested & holds {
            0 => 0,
            held if held == self.requested => self.pixels,
            held => held.count_ones(),
        }
    }
}

/// Expands a mask to all bits set in its lanes.
#[inline(always)]
pub(super) fn spread(mask: u32) -> Row {
    let mut lanes = [0; LANES];
    for (lane, bits) in lanes.iter_mut().enumerate() {
        *bits = if mask & 1 << lane == 0 { 0 } else { u32::MAX };
    }
    Row(lanes)
}
