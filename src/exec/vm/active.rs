//! The execution mask.

use crate::row::PARTS;
use wide::i32x8;

/// An execution mask, and what follows from it.
pub(crate) struct ActiveLanes {
    pub mask: u32,
    /// The register with all bits set in its lanes.
    pub lanes: [i32x8; PARTS],
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
pub(super) fn spread(mask: u32) -> [i32x8; PARTS] {
    const BITS: [i32; 8] = [1, 2, 4, 8, 16, 32, 64, 128];
    let bits = i32x8::new(BITS);
    std::array::from_fn(|part| {
        let own = i32x8::splat((mask >> (8 * part)) as i32 & 0xff);
        (own & bits).simd_eq(bits)
    })
}
