//! A register: one scalar of 32 pixels.
//!
//! Lanes `4q` to `4q + 3` are a quad of neighbours: left and right of the lower row, then of the
//! upper one, as `gl_FragCoord` counts. A register holds bits; an operation reads them as floats or
//! as integers. A truth value has all bits set or none.

use wide::{f32x8, i32x8, u32x8};

/// How many pixels run at a time.
pub const LANES: usize = 32;

/// How many vectors of eight lanes make a register.
pub(super) const PARTS: usize = LANES / 8;

/// One scalar of each pixel, as bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row(pub [i32x8; PARTS]);

/// Eight lanes, read as floats.
#[inline(always)]
pub(super) fn floats(bits: i32x8) -> f32x8 {
    bytemuck::cast(bits)
}

/// Eight lanes, read as unsigned integers.
#[inline(always)]
pub(super) fn unsigned(bits: i32x8) -> u32x8 {
    bytemuck::cast(bits)
}

/// The bits of eight floats.
#[inline(always)]
pub(super) fn of_floats(values: f32x8) -> i32x8 {
    bytemuck::cast(values)
}

/// The bits of eight unsigned integers.
#[inline(always)]
pub(super) fn of_unsigned(values: u32x8) -> i32x8 {
    bytemuck::cast(values)
}

impl Row {
    /// No bit set: zero of every type, and `false`.
    pub const ZERO: Row = Row([i32x8::ZERO; PARTS]);

    /// The same bits in every lane.
    pub fn splat(bits: u32) -> Row {
        Row([i32x8::splat(bits as i32); PARTS])
    }

    /// Lane by lane.
    pub fn of_bits(bits: [u32; LANES]) -> Row {
        Row(bytemuck::cast(bits))
    }

    /// Lane by lane.
    pub fn bits(self) -> [u32; LANES] {
        bytemuck::cast(self.0)
    }

    /// Lane by lane, read as floats.
    pub fn floats(self) -> [f32; LANES] {
        bytemuck::cast(self.0)
    }

    /// Lane by lane.
    pub fn of_floats(values: [f32; LANES]) -> Row {
        Row(bytemuck::cast(values))
    }

    /// One bit for each lane whose highest bit is set: the lanes where a truth value is true.
    #[inline(always)]
    pub fn mask(self) -> u32 {
        let mut mask = 0;
        for (part, at) in self.0.iter().zip(0..) {
            mask |= part.to_bitmask() << (8 * at);
        }
        mask
    }
}
