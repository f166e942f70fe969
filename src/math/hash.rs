//! A deterministic hash for pseudo-random numbers.

/// A pseudo-random number determined by the seed. The function is a bijection.
pub const fn hash(seed: u32) -> u32 {
    let mut x = seed.wrapping_mul(0x9e37_79b1) ^ 0x85eb_ca6b;
    x = (x ^ (x >> 15)).wrapping_mul(0x2c1b_3c6d);
    x = (x ^ (x >> 12)).wrapping_mul(0x297a_2d39);
    x ^ (x >> 15)
}
