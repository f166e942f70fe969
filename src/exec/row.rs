//! A VM register: one scalar for each of 32 pixels.
//!
//! Lanes `4q` to `4q + 3` are a quad: left and right of the lower row, then of the upper row, as in
//! `gl_FragCoord`. A register holds bits; operations interpret them as floats or integers. `true`
//! has all bits set, `false` none.

use fearless_simd::{f32x8, i32x8, mask32x8, prelude::*, u32x8};

/// A closure that is inlined wherever it is called: elsewhere it would not be compiled for the
/// instructions of its caller.
macro_rules! inlined {
    (|$($operand:ident),+| $result:expr) => {
        #[inline(always)]
        |$($operand),+| $result
    };
}
pub(crate) use inlined;

/// Number of lanes: pixels executed at a time.
pub const LANES: usize = 32;

/// Number of SIMD vectors of eight lanes per register.
pub(super) const PARTS: usize = LANES / 8;

/// One scalar per lane, as bits.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct Row(pub [u32; LANES]);

/// Reinterprets eight lanes as floats.
#[inline(always)]
pub(super) fn floats<S: Simd>(bits: u32x8<S>) -> f32x8<S> {
    bits.bitcast()
}

/// Reinterprets eight lanes as signed integers.
#[inline(always)]
pub(super) fn signed<S: Simd>(bits: u32x8<S>) -> i32x8<S> {
    bits.bitcast()
}

/// Reinterprets eight floats as bits.
#[inline(always)]
pub(super) fn of_floats<S: Simd>(values: f32x8<S>) -> u32x8<S> {
    values.bitcast()
}

/// Reinterprets eight signed integers as bits.
#[inline(always)]
pub(super) fn of_signed<S: Simd>(values: i32x8<S>) -> u32x8<S> {
    values.bitcast()
}

/// Eight truth values as bits.
#[inline(always)]
pub(super) fn truth<S: Simd>(holds: mask32x8<S>) -> u32x8<S> {
    let simd = holds.token();
    holds.select(u32x8::splat(simd, u32::MAX), u32x8::splat(simd, 0))
}

/// By bit: that of `a` where it is set in `chosen`, else that of `b`.
#[inline(always)]
pub(super) fn bit_select<S: Simd>(chosen: u32x8<S>, a: u32x8<S>, b: u32x8<S>) -> u32x8<S> {
    (a & chosen) | (b & !chosen)
}

impl Row {
    /// All bits clear: zero of every type, and `false`.
    pub const ZERO: Row = Row([0; LANES]);

    /// The same bits in every lane.
    pub const fn splat(bits: u32) -> Row {
        Row([bits; LANES])
    }

    /// Eight of the lanes.
    #[expect(clippy::indexing_slicing, reason = "`part` is less than `PARTS`")]
    #[inline(always)]
    pub fn part<S: Simd>(&self, simd: S, part: usize) -> u32x8<S> {
        self.0.as_chunks::<8>().0[part].simd_into(simd)
    }

    /// Sets eight of the lanes.
    #[expect(clippy::indexing_slicing, reason = "`part` is less than `PARTS`")]
    #[inline(always)]
    pub fn set_part<S: Simd>(&mut self, part: usize, bits: u32x8<S>) {
        self.0.as_chunks_mut::<8>().0[part] = bits.into();
    }

    /// Each lane as a float.
    pub fn floats(self) -> [f32; LANES] {
        self.0.map(f32::from_bits)
    }

    /// A register from the float of each lane.
    pub fn of_floats(values: [f32; LANES]) -> Row {
        Row(values.map(f32::to_bits))
    }

    /// A bit mask of the lanes whose highest bit is set, i.e. where a boolean is true.
    #[inline(always)]
    pub fn mask<S: Simd>(&self, simd: S) -> u32 {
        self.mask_where(simd, inlined!(|part| signed(part).simd_lt(0)))
    }

    /// A bit mask of the lanes for which a test holds.
    #[inline(always)]
    pub fn mask_where<S: Simd>(&self, simd: S, test: impl Fn(u32x8<S>) -> mask32x8<S>) -> u32 {
        mask_by_parts(inlined!(|part| test(self.part(simd, part))))
    }
}

/// A bit mask of the lanes that are set in the mask of their part.
#[inline(always)]
pub(super) fn mask_by_parts<S: Simd>(mask_of: impl Fn(usize) -> mask32x8<S>) -> u32 {
    let mut mask = 0;
    for part in 0..PARTS {
        mask |= (mask_of(part).to_bitmask() as u32) << (8 * part);
    }
    mask
}

/// The number of pixels of a quad.
pub const QUAD: usize = 4;

/// The lanes of a quad, of which a row holds copies.
pub fn quad_of(row: &Row) -> [u32; QUAD] {
    let (first, _) = row.0.as_chunks::<QUAD>();
    first.first().copied().unwrap_or_default()
}

/// A row with copies of a quad.
pub fn row_of(quad: [u32; QUAD]) -> Row {
    let mut row = [0; LANES];
    for chunk in row.chunks_mut(QUAD) {
        for (slot, bits) in chunk.iter_mut().zip(quad) {
            *slot = bits;
        }
    }
    Row(row)
}
