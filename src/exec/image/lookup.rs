//! Lookups of 32 pixels at a time.

use super::Texture;
use crate::exec::row::LANES;

/// What a lookup is given, the coordinates divided already where it projects.
pub(in crate::exec) struct Lookup<'a> {
    /// As many as the sampler takes; of arrays the layer comes last.
    pub coordinates: &'a [[f32; LANES]],
    /// What a shadow sampler compares the texels with.
    pub reference: Option<&'a [f32; LANES]>,
    /// Which level is read.
    pub level: LevelOf<'a>,
    /// In texels.
    pub offset: [i32; 3],
}

/// Where the level of a lookup comes from.
pub(in crate::exec) enum LevelOf<'a> {
    /// From how the coordinates grow in the quad.
    Implicit {
        /// Added to it.
        bias: Option<&'a [f32; LANES]>,
    },
    /// Given.
    Explicit(&'a [f32; LANES]),
    /// From how the coordinates are said to grow.
    Gradient {
        /// To the right, by coordinate.
        x: &'a [[f32; LANES]],
        /// Up, by coordinate.
        y: &'a [[f32; LANES]],
    },
}

/// What the sampler gives, as bits; the lanes whose bit is not set are not looked up.
pub(in crate::exec) fn lookup(
    _texture: &Texture,
    _lookup: &Lookup<'_>,
    _lanes: u32,
) -> [[u32; LANES]; 4] {
    [[0; LANES]; 4]
}

/// One texel of a level, as bits; outside of the image all are 0.
pub(in crate::exec) fn fetch(
    _texture: &Texture,
    _texel: &[[i32; LANES]],
    _level: &[i32; LANES],
    _offset: [i32; 3],
    _lanes: u32,
) -> [[u32; LANES]; 4] {
    [[0; LANES]; 4]
}

/// The size of a level in texels; the layers of an array stay as many.
pub(in crate::exec) fn size_of(texture: &Texture, level: &[i32; LANES]) -> [[i32; LANES]; 3] {
    let _ = (texture, level);
    [[0; LANES]; 3]
}
