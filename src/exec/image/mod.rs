//! Textures: what they hold, and how they are looked up.

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

/// The longest side of an image.
const MAX_SIDE: u32 = 8192;

/// What the coordinates of an image mean.
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

/// What a lookup is given, the coordinates divided already where it projects.
pub(crate) struct Lookup<'a> {
    /// As many as the sampler takes; of arrays the layer comes last.
    pub coordinates: &'a [[f32; LANES]],
    /// What a shadow sampler compares the texels with: 1 where it is not more.
    pub reference: Option<&'a [f32; LANES]>,
    /// Which level is read.
    pub level: LevelOf<'a>,
    /// In texels.
    pub offset: [i32; 3],
}

/// Where the level of a lookup comes from.
pub(crate) enum LevelOf<'a> {
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

/// An image with its levels.
#[derive(Clone, PartialEq, Debug)]
pub struct Image {
    shape: ImageShape,
    size: [u32; 3],
    /// Never none, all of one kind; level 0 is the sharpest, each next one half as large.
    levels: Vec<Texels>,
}

/// Why texels make no image.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ImageProblem {
    /// A side is zero or longer than any side may be, or does not fit the shape.
    Size([u32; 3]),
    /// There are more or fewer texels than the size says.
    Count {
        /// As many as the size says.
        expected: usize,
        /// As many as were given.
        given: usize,
    },
}

impl Image {
    /// An image of one level. The size is the width, the height, and the depth or the number of
    /// layers: 1 if the image is flat, 6 if it is a cube.
    ///
    /// # Errors
    /// If the size does not fit the shape or the texels.
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

    /// What a sampler without a texture reads: black that covers all.
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

    /// The image with all its levels, each made of the one before it, as `generateMipmap` does.
    /// Integers have none.
    #[must_use]
    pub fn with_levels(mut self) -> Image {
        self.levels.truncate(1);
        if self.levels.first().is_some_and(Texels::whole) {
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

    /// What the coordinates mean.
    pub const fn shape(&self) -> ImageShape {
        self.shape
    }

    /// Width, height, and depth or layers, of level 0.
    pub const fn size(&self) -> [u32; 3] {
        self.size
    }

    /// The texels of a level.
    pub fn level(&self, level: usize) -> Option<&Texels> {
        self.levels.get(level)
    }

    /// The size of a level, whether there is one or not.
    fn size_at(&self, level: usize) -> [u32; 3] {
        let half = |side: u32| side.checked_shr(level as u32).unwrap_or(0).max(1);
        let [width, height, depth] = self.size;
        let depth = match self.shape {
            ImageShape::Volume => half(depth),
            ImageShape::Flat | ImageShape::Cube | ImageShape::Layers => depth,
        };
        [half(width), half(height), depth]
    }

    /// How many levels there are down to a single texel.
    fn full_count(&self) -> usize {
        let [width, height, depth] = self.size;
        let longest = match self.shape {
            ImageShape::Volume => width.max(height).max(depth),
            ImageShape::Flat | ImageShape::Cube | ImageShape::Layers => width.max(height),
        };
        longest.checked_ilog2().unwrap_or(0) as usize + 1
    }
}

/// What lies between texels.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Filter {
    /// The nearest texel.
    Nearest,
    /// The texels around, weighted.
    #[default]
    Linear,
    /// As linear; and between the two nearest levels.
    Mipmap,
}

/// What lies outside an image.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Wrap {
    /// The texels of its edge.
    #[default]
    Clamp,
    /// The image again.
    Repeat,
    /// The image again, every other one mirrored.
    Mirror,
}

/// How an image is looked up.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Sampling {
    /// Between texels.
    pub filter: Filter,
    /// Outside, along each coordinate. Faces of cubes meet whatever it says.
    pub wrap: [Wrap; 3],
}

/// An image as a sampler sees it.
#[derive(Clone, Debug)]
pub struct Texture {
    /// The texels.
    pub image: Arc<Image>,
    /// How it is looked up.
    pub sampling: Sampling,
}

impl Texture {
    /// What a sampler without a texture reads.
    pub fn unbound(sampler: Sampler) -> Texture {
        Texture {
            image: Arc::new(Image::unbound(sampler)),
            sampling: Sampling {
                filter: Filter::Nearest,
                wrap: [Wrap::Clamp; 3],
            },
        }
    }

    /// Whether a sampler of this type can look it up.
    pub fn fits(&self, sampler: Sampler) -> bool {
        let scalar = match self.image.levels.first() {
            Some(Texels::Int(_)) => Scalar::Int,
            Some(Texels::Uint(_)) => Scalar::Uint,
            Some(Texels::Unorm8(_) | Texels::Float(_)) | None => Scalar::Float,
        };
        (self.image.shape, scalar) == kind_of(sampler)
    }

    /// Whether there is all that its filter reads; else lookups give black.
    fn is_complete(&self) -> bool {
        let whole = self.image.levels.first().is_some_and(Texels::whole);
        match self.sampling.filter {
            Filter::Nearest => true,
            Filter::Linear => !whole,
            Filter::Mipmap => !whole && self.image.levels.len() == self.image.full_count(),
        }
    }
}

/// What a sampler looks up: the shape of the image, and what its texels are made of.
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
