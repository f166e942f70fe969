//! Numbers that look as if thrown, the same on every machine.

/// A number that looks as if thrown; each seed has its own.
pub const fn hash(seed: u32) -> u32 {
    let mut x = seed.wrapping_mul(0x9e37_79b1) ^ 0x85eb_ca6b;
    x = (x ^ (x >> 15)).wrapping_mul(0x2c1b_3c6d);
    x = (x ^ (x >> 12)).wrapping_mul(0x297a_2d39);
    x ^ (x >> 15)
}
