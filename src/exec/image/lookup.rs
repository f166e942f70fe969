//! Texture lookups for 32 pixels at a time.

use super::level::{levels, vector};
use super::{Filter, Image, ImageShape, Sampling, Texels, Texture, TextureLookup, Wrap, cube};
use crate::row::LANES;
use fearless_simd::{SimdBase, SimdInto, f32x4};
use shaderlint_math::{Baseline, baseline};
use shaderlint_text::SetAt;

/// The four components of a texel.
type Components = f32x4<Baseline>;

/// The same number in every component.
#[inline(always)]
fn splat(number: f32) -> Components {
    Components::splat(baseline(), number)
}

/// The result of a lookup, as bits. Only the lanes in the mask are looked up.
pub(crate) fn lookup(
    texture: &Texture,
    lookup: &TextureLookup<'_>,
    lanes: u32,
) -> [[u32; LANES]; 4] {
    let Some(first) = texture.image.level(0).filter(|_| texture.is_complete()) else {
        return incomplete(&texture.image);
    };
    match first {
        Texels::Unorm8(_) => floats::<[u8; 4]>(texture, lookup, lanes),
        Texels::Float(_) => floats::<[f32; 4]>(texture, lookup, lanes),
        Texels::Int(texels) => {
            let nearest = nearest(texture, lookup, lanes, |number| texels.get(number).copied());
            nearest.map(|row| row.map(|part| part as u32))
        }
        Texels::Uint(texels) => {
            nearest(texture, lookup, lanes, |number| texels.get(number).copied())
        }
    }
}

/// The result for an incomplete texture.
fn incomplete(image: &Image) -> [[u32; LANES]; 4] {
    let are_integers = image.level(0).is_some_and(Texels::are_integers);
    let one = if are_integers { 1 } else { 1.0_f32.to_bits() };
    [[0; LANES], [0; LANES], [0; LANES], [one; LANES]]
}

/// Texels that are filtered as floats.
trait Filtered: Sized + 'static {
    /// The texels of this type.
    fn of(texels: &Texels) -> &[Self];
    /// The components to filter.
    fn parts(&self) -> Components;
    /// The value of 1.0 after filtering.
    const ONE: f32;
}

impl Filtered for [u8; 4] {
    fn of(texels: &Texels) -> &[Self] {
        match texels {
            Texels::Unorm8(texels) => texels,
            Texels::Float(_) | Texels::Int(_) | Texels::Uint(_) => &[],
        }
    }

    #[inline(always)]
    fn parts(&self) -> Components {
        self.map(f32::from).simd_into(baseline())
    }

    const ONE: f32 = 255.0;
}

impl Filtered for [f32; 4] {
    fn of(texels: &Texels) -> &[Self] {
        match texels {
            Texels::Float(texels) => texels,
            Texels::Unorm8(_) | Texels::Int(_) | Texels::Uint(_) => &[],
        }
    }

    #[inline(always)]
    fn parts(&self) -> Components {
        (*self).simd_into(baseline())
    }

    const ONE: f32 = 1.0;
}

/// The location of a lookup: coordinates within a layer or face, and the index of it.
#[derive(Clone, Copy)]
struct TexelSpot {
    at: [f32; 3],
    layer: u32,
}

/// The parameters for reading one level.
struct LevelReading<'a> {
    shape: ImageShape,
    sampling: &'a Sampling,
    offset: [i32; 3],
}

fn floats<T: Filtered>(
    texture: &Texture,
    lookup: &TextureLookup<'_>,
    lanes: u32,
) -> [[u32; LANES]; 4] {
    let image = &*texture.image;
    let reading = LevelReading {
        shape: image.shape(),
        sampling: &texture.sampling,
        offset: lookup.offset,
    };
    let mipmaps = texture.sampling.filter == Filter::Mipmap && image.full_count() > 1;
    let levels = mipmaps.then(|| levels(texture, lookup));
    let one = splat(T::ONE);
    let mut found = [[0; LANES]; 4];
    for lane in lanes_of(lanes) {
        let spot = spot(image, vector(lookup.coordinates, lane));
        let reference = lookup.reference.and_then(|row| row.get(lane)).copied();
        let of_level = |level: usize| {
            let texels = image.level(level).map_or(&[][..], T::of);
            let size = image.size_at(level);
            match reference {
                None => reading.filtered(size, spot, |number| {
                    texels.get(number).map_or(splat(0.0), T::parts) / one
                }),
                Some(reference) => reading.filtered(size, spot, |number| {
                    let texel = texels.get(number).map_or(splat(0.0), T::parts) / one;
                    let [depth, ..] = <[f32; 4]>::from(texel);
                    splat(if reference <= depth { 1.0 } else { 0.0 })
                }),
            }
        };
        let level = levels.as_ref().and_then(|row| row.get(lane)).copied();
        let (sharp, part) = level.map_or((0, 0.0), |level| {
            (level as usize, level - level as usize as f32)
        });
        let mut parts = of_level(sharp);
        if part > 0.0 {
            parts += (of_level(sharp + 1) - parts) * splat(part);
        }
        put(&mut found, lane, <[f32; 4]>::from(parts).map(f32::to_bits));
    }
    found
}

fn nearest<T: Copy + Default>(
    texture: &Texture,
    lookup: &TextureLookup<'_>,
    lanes: u32,
    texel: impl Fn(usize) -> Option<[T; 4]>,
) -> [[T; LANES]; 4] {
    let image = &*texture.image;
    let reading = LevelReading {
        shape: image.shape(),
        sampling: &texture.sampling,
        offset: lookup.offset,
    };
    let mut found = [[T::default(); LANES]; 4];
    for lane in lanes_of(lanes) {
        let spot = spot(image, vector(lookup.coordinates, lane));
        let texel = texel(reading.nearest(image.size(), spot)).unwrap_or_default();
        put(&mut found, lane, texel);
    }
    found
}

/// Splits coordinates into a location.
#[inline(always)]
fn spot(image: &Image, at: [f32; 3]) -> TexelSpot {
    let [x, y, z] = at;
    match image.shape() {
        ImageShape::Flat | ImageShape::Volume => TexelSpot { at, layer: 0 },
        ImageShape::Layers => {
            let [.., layers] = image.size();
            let layer = floor(z + 0.5).clamp(0, layers as i32 - 1) as u32;
            TexelSpot {
                at: [x, y, 0.0],
                layer,
            }
        }
        ImageShape::Cube => {
            let (layer, [s, t]) = cube::face(at);
            TexelSpot {
                at: [s, t, 0.0],
                layer,
            }
        }
    }
}

impl LevelReading<'_> {
    /// The index of the nearest texel.
    #[inline(always)]
    fn nearest(&self, size: [u32; 3], spot: TexelSpot) -> usize {
        let [width, height, depth] = size;
        let [x, y, z] = spot.at;
        let [wrap_x, wrap_y, wrap_z] = self.wraps();
        let [by_x, by_y, by_z] = self.offset;
        let slice = if self.shape == ImageShape::Volume {
            nearest_texel(z, depth, wrap_z, by_z)
        } else {
            spot.layer
        };
        let (x, y) = (
            nearest_texel(x, width, wrap_x, by_x),
            nearest_texel(y, height, wrap_y, by_y),
        );
        number(width, height, [x, y, slice])
    }

    fn wraps(&self) -> [Wrap; 3] {
        if self.shape == ImageShape::Cube {
            return [Wrap::Clamp; 3];
        }
        self.sampling.wrap
    }

    /// The filtered value of one level.
    #[inline(always)]
    fn filtered(
        &self,
        size: [u32; 3],
        spot: TexelSpot,
        texel: impl Fn(usize) -> Components,
    ) -> Components {
        let [width, height, depth] = size;
        match (self.sampling.filter, self.shape) {
            (Filter::Nearest, _) => texel(self.nearest(size, spot)),
            (Filter::Linear | Filter::Mipmap, ImageShape::Cube) => of_face(width, spot, texel),
            (Filter::Linear | Filter::Mipmap, _) => {
                let [at_x, at_y, at_z] = spot.at;
                let [wrap_x, wrap_y, wrap_z] = self.sampling.wrap;
                let [by_x, by_y, by_z] = self.offset;
                let x = between(at_x, width, wrap_x, by_x);
                let y = between(at_y, height, wrap_y, by_y);
                let slice = |slice: u32| {
                    let row = |row: u32| {
                        mix(
                            texel(number(width, height, [x.low, row, slice])),
                            texel(number(width, height, [x.high, row, slice])),
                            x.share,
                        )
                    };
                    mix(row(y.low), row(y.high), y.share)
                };
                if self.shape == ImageShape::Volume {
                    let z = between(at_z, depth, wrap_z, by_z);
                    mix(slice(z.low), slice(z.high), z.share)
                } else {
                    slice(spot.layer)
                }
            }
        }
    }
}

/// Bilinear filtering across the edges of cube faces. At a corner, the missing fourth texel is the
/// average of the other three.
fn of_face(side: u32, spot: TexelSpot, texel: impl Fn(usize) -> Components) -> Components {
    let [s, t, _] = spot.at;
    let [s, t] = [s, t].map(|part| part * side as f32 - 0.5);
    let (column, row) = (floor(s), floor(t));
    let at =
        |right: i32, up: i32| cube::texel(spot.layer, [column + right, row + up], side).map(&texel);
    let corners = [at(0, 0), at(1, 0), at(0, 1), at(1, 1)];
    let known = corners
        .iter()
        .flatten()
        .fold(splat(0.0), |sum, part| sum + *part);
    let mean = known / splat(3.0);
    let [a, b, c, d] = corners.map(|corner| corner.unwrap_or(mean));
    let (share_s, share_t) = (s - column as f32, t - row as f32);
    mix(mix(a, b, share_s), mix(c, d, share_s), share_t)
}

#[inline(always)]
fn nearest_texel(at: f32, side: u32, wrap: Wrap, offset: i32) -> u32 {
    let texel = floor(scaled(at, side, wrap));
    wrapped(texel.saturating_add(offset), side, wrap)
}

/// Two neighbouring texels along one axis, and the weight of the second.
#[derive(Clone, Copy)]
struct Between {
    low: u32,
    high: u32,
    share: f32,
}

#[inline(always)]
fn between(at: f32, side: u32, wrap: Wrap, offset: i32) -> Between {
    let along = scaled(at, side, wrap) - 0.5;
    let low = floor(along);
    let share = along - low as f32;
    let low = low.saturating_add(offset);
    Between {
        low: wrapped(low, side, wrap),
        high: wrapped(low.saturating_add(1), side, wrap),
        share,
    }
}

/// A coordinate in texels, relative to the image or its repetition; never far outside, never NaN.
#[inline(always)]
fn scaled(at: f32, side: u32, wrap: Wrap) -> f32 {
    let side = side as f32;
    let fraction = |at: f32| {
        // Floats of this magnitude have no fraction. The comparison is also false for NaN.
        if at.abs() < 8_388_608.0 {
            at - floor(at) as f32
        } else {
            0.0
        }
    };
    match wrap {
        // More than half a texel outside, nothing changes.
        Wrap::Clamp => (at * side).max(-1.0).min(side + 1.0),
        Wrap::Repeat => fraction(at) * side,
        Wrap::Mirror => fraction(at * 0.5) * (2.0 * side),
    }
}

/// The texel at an index that may be outside the image.
#[inline(always)]
fn wrapped(number: i32, side: u32, wrap: Wrap) -> u32 {
    let side = side as i32;
    if (0..side).contains(&number) {
        return number as u32;
    }
    let number = match wrap {
        Wrap::Clamp => number.clamp(0, side - 1),
        Wrap::Repeat => number.rem_euclid(side),
        Wrap::Mirror => {
            let number = number.rem_euclid(2 * side);
            number.min(2 * side - 1 - number)
        }
    };
    number as u32
}

#[inline(always)]
fn floor(number: f32) -> i32 {
    let truncated = number as i32;
    truncated.saturating_sub(i32::from(truncated as f32 > number))
}

#[inline(always)]
fn mix(first: Components, second: Components, share: f32) -> Components {
    first + (second - first) * splat(share)
}

#[inline(always)]
fn number(width: u32, height: u32, [x, y, slice]: [u32; 3]) -> usize {
    (slice as usize * height as usize + y as usize) * width as usize + x as usize
}

/// One texel of a level, as bits. Zero outside the image; a missing level is replaced by the
/// nearest one, as measured in a browser.
pub(crate) fn fetch(
    texture: &Texture,
    texel: &[[i32; LANES]],
    level: &[i32; LANES],
    offset: [i32; 3],
    lanes: u32,
) -> [[u32; LANES]; 4] {
    let image = &*texture.image;
    let mut found = [[0; LANES]; 4];
    if !texture.is_complete() {
        return incomplete(image);
    }
    let last = image.levels.len() as i32 - 1;
    for lane in lanes_of(lanes) {
        let level = level.get(lane).copied().unwrap_or_default();
        let level = level.clamp(0, last) as usize;
        let Some(texels) = image.level(level) else {
            continue;
        };
        let [width, height, depth] = image.size_at(level);
        let mut at = vector(texel, lane);
        for (part, by) in at.iter_mut().zip(offset) {
            *part = part.wrapping_add(by);
        }
        let inside = |part: i32, side: u32| u32::try_from(part).ok().filter(|part| *part < side);
        let [x, y, z] = at;
        let (Some(x), Some(y), Some(z)) = (inside(x, width), inside(y, height), inside(z, depth))
        else {
            continue;
        };
        let number = number(width, height, [x, y, z]);
        put(&mut found, lane, bits(texels, number));
    }
    found
}

/// The bits of a texel, unfiltered.
fn bits(texels: &Texels, number: usize) -> [u32; 4] {
    let parts = match texels {
        Texels::Unorm8(texels) => texels
            .get(number)
            .map(|texel| texel.map(|part| (f32::from(part) / 255.0).to_bits())),
        Texels::Float(texels) => texels.get(number).map(|texel| texel.map(f32::to_bits)),
        Texels::Int(texels) => texels
            .get(number)
            .map(|texel| texel.map(|part| part as u32)),
        Texels::Uint(texels) => texels.get(number).copied(),
    };
    parts.unwrap_or_default()
}

/// The size of a level in texels; the number of layers is the same for all levels.
pub(crate) fn size_of(texture: &Texture, level: &[i32; LANES]) -> [[i32; LANES]; 3] {
    let mut sizes = [[0; LANES]; 3];
    for (lane, level) in level.iter().enumerate() {
        let Ok(level) = usize::try_from(*level) else {
            continue;
        };
        put(
            &mut sizes,
            lane,
            texture.image.size_at(level).map(|side| side as i32),
        );
    }
    sizes
}

/// The indices of the lanes in a mask.
fn lanes_of(lanes: u32) -> impl Iterator<Item = usize> {
    (0..LANES).filter(move |lane| lanes >> lane & 1 == 1)
}

#[inline(always)]
fn put<T, const N: usize>(rows: &mut [[T; LANES]; N], lane: usize, parts: [T; N]) {
    for (row, part) in rows.iter_mut().zip(parts) {
        row.set_at(lane, part);
    }
}
