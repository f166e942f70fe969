//! Level of detail: which mipmap level a lookup reads.

use super::{ImageShape, LevelOf, Texture, TextureLookup};
use crate::row::LANES;

/// By lane: the fractional level, clamped to the existing levels.
pub(super) fn levels(texture: &Texture, lookup: &TextureLookup<'_>) -> [f32; LANES] {
    let mut levels = match lookup.level {
        LevelOf::Explicit(level) => *level,
        LevelOf::Gradient { x, y } => of_gradients(texture, lookup, x, y),
        LevelOf::Implicit { bias } => {
            let mut levels = of_quads(texture, lookup);
            if let Some(bias) = bias {
                for (level, bias) in levels.iter_mut().zip(bias) {
                    *level += bias;
                }
            }
            levels
        }
    };
    let last = (texture.image.full_count() - 1) as f32;
    for level in &mut levels {
        // If one operand is NaN, `max` and `min` return the other.
        *level = level.max(0.0).min(last);
    }
    levels
}

/// The level of each quad, from the differences between its first pixel and those to the right and
/// above.
fn of_quads(texture: &Texture, lookup: &TextureLookup<'_>) -> [f32; LANES] {
    let mut levels = [0.0; LANES];
    for (quad, levels) in levels.as_chunks_mut::<4>().0.iter_mut().enumerate() {
        let corner = |number: usize| vector(lookup.coordinates, 4 * quad + number);
        let [first, right, above] = [corner(0), corner(1), corner(2)];
        let level = if texture.image.shape() == ImageShape::Cube {
            let scaled = [first, right, above].map(|at| at.map(|c| c / (2.0 * major(at))));
            let [first, right, above] = scaled;
            of_directions(texture, difference(right, first), difference(above, first))
        } else {
            of_lengths(texture, difference(right, first), difference(above, first))
        };
        *levels = [level; 4];
    }
    levels
}

/// The level of each pixel, from explicit gradients.
fn of_gradients(
    texture: &Texture,
    lookup: &TextureLookup<'_>,
    x: &[[f32; LANES]],
    y: &[[f32; LANES]],
) -> [f32; LANES] {
    let mut levels = [0.0; LANES];
    for (lane, level) in levels.iter_mut().enumerate() {
        let (x, y) = (vector(x, lane), vector(y, lane));
        *level = if texture.image.shape() == ImageShape::Cube {
            let scale = 2.0 * major(vector(lookup.coordinates, lane));
            of_directions(texture, x.map(|d| d / scale), y.map(|d| d / scale))
        } else {
            of_lengths(texture, x, y)
        };
    }
    levels
}

/// The level of a pixel with this footprint to the right and up: the logarithm of its longer side
/// in texels.
fn of_lengths(texture: &Texture, x: [f32; 3], y: [f32; 3]) -> f32 {
    let [width, height, depth] = texture.image.size();
    let depth = if texture.image.shape() == ImageShape::Volume {
        depth
    } else {
        0
    };
    let scale = [width, height, depth].map(|side| side as f32);
    let square = |[a, b, c]: [f32; 3]| {
        let [u, v, w] = scale;
        (a * u) * (a * u) + (b * v) * (b * v) + (c * w) * (c * w)
    };
    0.5 * logarithm(square(x).max(square(y)))
}

/// The level of a pixel with this footprint on a cube map. It may be on several faces, so the
/// maximum over all axes counts.
fn of_directions(texture: &Texture, x: [f32; 3], y: [f32; 3]) -> f32 {
    let distance = |[a, b, c]: [f32; 3]| {
        let [a, b, c] = [a.abs(), b.abs(), c.abs()];
        (a + b).max(a + c).max(b + c)
    };
    let [width, ..] = texture.image.size();
    logarithm(distance(x).max(distance(y)) * width as f32)
}

/// An approximation of the binary logarithm, as in graphics hardware: the exponent of the square,
/// with the mantissa as the fraction. Exact at powers of two and of their square roots; the error
/// is at most 0.05.
fn logarithm(number: f32) -> f32 {
    const MANTISSA: u32 = 1 << (f32::MANTISSA_DIGITS - 1);
    let square = number * number;
    let bits = square.to_bits() as f32 - 1.0_f32.to_bits() as f32;
    0.5 * bits / MANTISSA as f32
}

/// The largest absolute coordinate.
pub(super) fn major([x, y, z]: [f32; 3]) -> f32 {
    x.abs().max(y.abs()).max(z.abs())
}

fn difference([a, b, c]: [f32; 3], [x, y, z]: [f32; 3]) -> [f32; 3] {
    [a - x, b - y, c - z]
}

/// Up to three coordinates of a lane; missing ones are 0.
pub(super) fn vector<T: Copy + Default>(rows: &[[T; LANES]], lane: usize) -> [T; 3] {
    let mut vector = [T::default(); 3];
    for (slot, row) in vector.iter_mut().zip(rows) {
        *slot = row.get(lane).copied().unwrap_or_default();
    }
    vector
}
