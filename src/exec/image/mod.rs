//! Textures: images with mipmaps, and sampler state.

mod cube;
mod level;
pub(crate) mod lookup;
mod mipmap;
#[cfg(test)]
mod tests;
mod texels;

pub use texels::Texels;

use super::row::LANES;
use shaderlint_semantic::{Sampler, Scalar};
use std::sync::Arc;

/// Maximum side length of an image.
const MAX_SIDE: u32 = 8192;

/// The dimensionality of an image.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ImageShape {
    /// `sampler2D`
    Flat,
    /// `sampler3D`
    Volume,
    /// `samplerCube`; layers are the faces +x, -x, +y, -y, +z, -z.
    Cube,
    /// `sampler2DArray`
    Layers,
}

/// The operands of a lookup, after projection.
pub(crate) struct TextureLookup<'a> {
    /// One row per coordinate of the sampler; the layer of an array comes last.
    pub coordinates: &'a [[f32; LANES]],
    /// The depth reference of a shadow sampler: the result is 1 where it is not greater than the
    /// texel.
    pub reference: Option<&'a [f32; LANES]>,
    /// The level to read.
    pub level: LevelOf<'a>,
    /// The offset in texels.
    pub offset: [i32; 3],
}

/// How the level of a lookup is determined.
pub(crate) enum LevelOf<'a> {
    /// From the derivatives of the coordinates in the quad.
    Implicit {
        /// A bias added to the level.
        bias: Option<&'a [f32; LANES]>,
    },
    Explicit(&'a [f32; LANES]),
    /// From explicit gradients of the coordinates.
    Gradient {
        /// The gradient to the right, by coordinate.
        x: &'a [[f32; LANES]],
        /// The gradient upwards, by coordinate.
        y: &'a [[f32; LANES]],
    },
}

/// An image with its mipmap levels.
#[derive(Clone, PartialEq, Debug)]
pub struct Image {
    shape: ImageShape,
    size: [u32; 3],
    /// At least one level, all of the same format; level 0 is the largest, each further one half
    /// its size.
    levels: Vec<Texels>,
}

/// Why texels do not form an image.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ImageProblem {
    /// A side is zero or exceeds the maximum, or the size does not fit the shape.
    Size([u32; 3]),
    /// The number of texels does not match the size.
    Count {
        /// The number of texels required by the size.
        expected: usize,
        /// The number of texels supplied.
        given: usize,
    },
}

impl Image {
    /// An image with one level. `size` is the width, the height, and the depth or number of layers:
    /// 1 for a flat image, 6 for a cube map.
    ///
    /// # Errors
    /// The size does not fit the shape or the number of texels.
    pub fn new(shape: ImageShape, size: [u32; 3], texels: Texels) -> Result<Image, ImageProblem> {
        let [width, height, depth] = size;
        let fits = match shape {
            ImageShape::Flat => depth == 1,
            ImageShape::Cube => depth == 6 && width == height,
            ImageShape::Volume | ImageShape::Layers => true,
        };
        if !fits || size.iter().any(|side| !(1..=MAX_SIDE).contains(side)) {
            return Err(ImageProblem::Size(size));
        }
        let expected = size.iter().fold(1usize, |product, side| {
            product.saturating_mul(*side as usize)
        });
        let given = texels.count();
        if expected != given {
            return Err(ImageProblem::Count { expected, given });
        }
        Ok(Image {
            shape,
            size,
            levels: vec![texels],
        })
    }

    /// The image of an unbound sampler: opaque black.
    pub fn unbound(sampler: Sampler) -> Image {
        let (shape, scalar) = kind_of(sampler);
        let layers = if shape == ImageShape::Cube { 6 } else { 1 };
        let texels = match scalar {
            Scalar::Int => Texels::Int(vec![[0, 0, 0, 1]; layers]),
            Scalar::Uint => Texels::Uint(vec![[0, 0, 0, 1]; layers]),
            Scalar::Float | Scalar::Bool => Texels::Unorm8(vec![[0, 0, 0, 255]; layers]),
        };
        Image {
            shape,
            size: [1, 1, layers as u32],
            levels: vec![texels],
        }
    }

    /// Generates all mipmap levels, like `generateMipmap`. Integer formats have none.
    #[must_use]
    pub fn with_levels(mut self) -> Image {
        self.levels.truncate(1);
        if self.levels.first().is_some_and(Texels::are_integers) {
            return self;
        }
        for level in 1..self.full_count() {
            let (from, to) = (self.size_at(level - 1), self.size_at(level));
            let Some(last) = self.levels.last() else {
                break;
            };
            let next = mipmap::half(last, from, to);
            self.levels.push(next);
        }
        self
    }

    /// The dimensionality.
    pub const fn shape(&self) -> ImageShape {
        self.shape
    }

    /// Width, height, and depth or number of layers, of level 0.
    pub const fn size(&self) -> [u32; 3] {
        self.size
    }

    /// The texels of a level; `None` if there is no such level.
    pub fn level(&self, level: usize) -> Option<&Texels> {
        self.levels.get(level)
    }

    /// The size of a level, whether it exists or not.
    fn size_at(&self, level: usize) -> [u32; 3] {
        let half = |side: u32| side.checked_shr(level as u32).unwrap_or(0).max(1);
        let [width, height, depth] = self.size;
        let depth = match self.shape {
            ImageShape::Volume => half(depth),
            ImageShape::Flat | ImageShape::Cube | ImageShape::Layers => depth,
        };
        [half(width), half(height), depth]
    }

    /// The number of levels down to a single texel.
    fn full_count(&self) -> usize {
        let [width, height, depth] = self.size;
        let longest = match self.shape {
            ImageShape::Volume => width.max(height).max(depth),
            ImageShape::Flat | ImageShape::Cube | ImageShape::Layers => width.max(height),
        };
        longest.checked_ilog2().unwrap_or(0) as usize + 1
    }
}

/// Texture filtering.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Filter {
    /// The nearest texel.
    Nearest,
    /// Linear interpolation of the surrounding texels.
    #[default]
    Linear,
    /// Linear, and between the two nearest mipmap levels.
    Mipmap,
}

/// Wrap mode: what coordinates outside the image read.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Wrap {
    /// Clamps to the edge.
    #[default]
    Clamp,
    /// Repeats the image.
    Repeat,
    /// Repeats the image, mirroring every second copy.
    Mirror,
}

/// Sampler state.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Sampling {
    /// The filter between texels and levels.
    pub filter: Filter,
    /// The wrap mode of each coordinate; ignored for cube maps, which are seamless.
    pub wrap: [Wrap; 3],
}

/// An image with sampler state.
#[derive(Clone, Debug)]
pub struct Texture {
    /// The image, which may be shared.
    pub image: Arc<Image>,
    /// The sampler state.
    pub sampling: Sampling,
}

impl Texture {
    /// The texture of an unbound sampler.
    pub fn unbound(sampler: Sampler) -> Texture {
        Texture {
            image: Arc::new(Image::unbound(sampler)),
            sampling: Sampling {
                filter: Filter::Nearest,
                wrap: [Wrap::Clamp; 3],
            },
        }
    }

    /// Whether the texture fits a sampler type.
    pub fn fits(&self, sampler: Sampler) -> bool {
        let scalar = match self.image.levels.first() {
            Some(Texels::Int(_)) => Scalar::Int,
            Some(Texels::Uint(_)) => Scalar::Uint,
            Some(Texels::Unorm8(_) | Texels::Float(_)) | None => Scalar::Float,
        };
        (self.image.shape, scalar) == kind_of(sampler)
    }

    /// Whether the texture is complete, i.e. has all levels that its filter needs; incomplete
    /// textures read black.
    fn is_complete(&self) -> bool {
        let are_integers = self.image.levels.first().is_some_and(Texels::are_integers);
        match self.sampling.filter {
            Filter::Nearest => true,
            Filter::Linear => !are_integers,
            Filter::Mipmap => !are_integers && self.image.levels.len() == self.image.full_count(),
        }
    }
}

/// The image shape and component type of a sampler type.
fn kind_of(sampler: Sampler) -> (ImageShape, Scalar) {
    let shape = match sampler {
        Sampler::Sampler2D
        | Sampler::Isampler2D
        | Sampler::Usampler2D
        | Sampler::Sampler2DShadow => ImageShape::Flat,
        Sampler::Sampler3D | Sampler::Isampler3D | Sampler::Usampler3D => ImageShape::Volume,
        Sampler::SamplerCube
        | Sampler::IsamplerCube
        | Sampler::UsamplerCube
        | Sampler::SamplerCubeShadow => ImageShape::Cube,
        Sampler::Sampler2DArray
        | Sampler::Isampler2DArray
        | Sampler::Usampler2DArray
        | Sampler::Sampler2DArrayShadow => ImageShape::Layers,
    };
    let scalar = match sampler {
        Sampler::Isampler2D
        | Sampler::Isampler3D
        | Sampler::IsamplerCube
        | Sampler::Isampler2DArray => Scalar::Int,
        Sampler::Usampler2D
        | Sampler::Usampler3D
        | Sampler::UsamplerCube
        | Sampler::Usampler2DArray => Scalar::Uint,
        Sampler::Sampler2D
        | Sampler::Sampler3D
        | Sampler::SamplerCube
        | Sampler::Sampler2DArray
        | Sampler::Sampler2DShadow
        | Sampler::SamplerCubeShadow
        | Sampler::Sampler2DArrayShadow => Scalar::Float,
    };
    (shape, scalar)
}
