//! Textures: what they hold, and how they are looked up.

mod lookup;

use std::sync::Arc;

#[allow(unused_imports)]
pub(in crate::exec) use lookup::{LevelOf, Lookup, fetch, lookup, size_of};

/// What the coordinates of an image mean.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shape {
    /// `sampler2D`
    Flat,
    /// `sampler3D`
    Volume,
    /// `samplerCube`; layers are the faces +x, -x, +y, -y, +z, -z.
    Cube,
    /// `sampler2DArray`
    Layers,
}

/// The texels of one level, layer by layer, each layer row by row, the row of coordinate 0 first.
#[derive(Clone, PartialEq, Debug)]
pub enum Texels {
    /// Of formats that give `vec4`.
    Float(Vec<[f32; 4]>),
    /// Of formats that give `ivec4`.
    Int(Vec<[i32; 4]>),
    /// Of formats that give `uvec4`.
    Uint(Vec<[u32; 4]>),
}

/// An image with its levels; level 0 is the sharpest.
#[derive(Clone, PartialEq, Debug)]
pub struct Image {
    /// What its coordinates mean.
    pub shape: Shape,
    /// Width, height, and depth or layers, of level 0.
    pub size: [u32; 3],
    /// The levels, each half as large as the one before it.
    pub levels: Vec<Texels>,
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
    /// Outside, along each coordinate.
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
