//! A VM register: one scalar for each of 32 pixels.
//!
//! Lanes `4q` to `4q + 3` are a quad: left and right of the lower row, then of the upper row, as in
//! `gl_FragCoord`. A register holds bits; operations interpret them as floats or integers. `true`
//! has all bits set, `false` none.

use wide::{f32x8, i32x8, u32x8};

/// Number of lanes: pixels executed at a time.
pub const LANES: usize = 32;

/// Number of SIMD vectors of eight lanes per register.
pub(super) const PARTS: usize = LANES / 8;

/// One scalar per lane, as bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row(pub [i32x8; PARTS]);

/// Reinterprets eight lanes as floats.
#[inline(always)]
pub(super) fn floats(bits: i32x8) -> f32x8 {
    bytemuck::cast(bits)
}

/// Reinterprets eight lanes as unsigned integers.
#[inline(always)]
pub(super) fn unsigned(bits: i32x8) -> u32x8 {
    bytemuck::cast(bits)
}

/// Reinterprets eight floats as bits.
#[inline(always)]
pub(super) fn of_floats(values: f32x8) -> i32x8 {
    bytemuck::cast(values)
}

/// Reinterprets eight unsigned integers as bits.
#[inline(always)]
pub(super) fn of_unsigned(values: u32x8) -> i32x8 {
    bytemuck::cast(values)
}

impl Row {
    /// All bits clear: zero of every type, and `false`.
    pub const ZERO: Row = Row([i32x8::ZERO; PARTS]);

    /// The same bits in every lane.
    pub fn splat(bits: u32) -> Row {
        Row([i32x8::splat(bits as i32); PARTS])
    }

    /// A register from the bits of each lane.
    pub fn of_bits(bits: [u32; LANES]) -> Row {
        Row(bytemuck::cast(bits))
    }

    /// The bits of each lane.
    pub fn bits(self) -> [u32; LANES] {
        bytemuck::cast(self.0)
    }

    /// Each lane as a float.
    pub fn floats(self) -> [f32; LANES] {
        bytemuck::cast(self.0)
    }

    /// A register from the float of each lane.
    pub fn of_floats(values: [f32; LANES]) -> Row {
        Row(bytemuck::cast(values))
    }

    /// A bit mask of the lanes whose highest bit is set, i.e. where a boolean is true.
    #[inline(always)]
    pub fn mask(self) -> u32 {
        let mut mask = 0;
        for (part, at) in self.0.iter().zip(0..) {
            mask |= part.to_bitmask() << (8 * at);
        }
        mask
    }
}
