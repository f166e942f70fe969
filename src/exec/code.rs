//! Register code: what the machine runs.

use crate::semantic::{Sampler, Type};

/// A shader as register code, with what it takes and gives.
#[derive(Default, Debug)]
pub struct Code {
    /// The uniforms, each scalar, vector, matrix or array of these by itself.
    pub uniforms: Vec<UniformSlot>,
    /// The samplers.
    pub samplers: Vec<SamplerSlot>,
    /// What differs from pixel to pixel.
    pub inputs: Vec<InputSlot>,
    /// What the shader gives for each pixel.
    pub outputs: Vec<OutputSlot>,
}

/// A uniform without members.
#[derive(Clone, PartialEq, Debug)]
pub struct UniformSlot {
    /// As `getUniformLocation` takes it: `lights[1].position`, `Block.member`; an array without its
    /// brackets.
    pub name: String,
    /// Its type.
    pub ty: Type,
    /// Where its scalars begin in the memory.
    pub(super) at: u32,
}

/// A sampler.
#[derive(Clone, PartialEq, Debug)]
pub struct SamplerSlot {
    /// As `getUniformLocation` takes it, elements of arrays one by one.
    pub name: String,
    /// What it looks up.
    pub sampler: Sampler,
}

/// An input of the stage, or an `in` parameter of an entry that a host calls.
#[derive(Clone, PartialEq, Debug)]
pub struct InputSlot {
    /// Its name.
    pub name: String,
    /// Its type.
    pub ty: Type,
}

/// An output of the stage, or an `out` parameter of an entry that a host calls, or what it returns.
#[derive(Clone, PartialEq, Debug)]
pub struct OutputSlot {
    /// Its name; empty for what the entry returns.
    pub name: String,
    /// Its type.
    pub ty: Type,
}
