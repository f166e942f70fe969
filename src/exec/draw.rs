//! A draw call: bytecode with uniforms, textures and inputs, over a rectangle of pixels.

use super::bytecode::{Bytecode, InputSlot, UniformSlot};
use super::image::Texture;
use shaderlint_semantic::Scalar;
use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Default fuel per group of pixels.
const FUEL: u64 = 50_000_000;

/// The state of a draw call.
pub struct Draw<'c> {
    /// The compiled shader.
    pub code: &'c Bytecode,
    /// Width and height of the image in pixels.
    pub size: [u32; 2],
    /// Fuel: the number of instructions that each group of pixels may execute more than once.
    pub fuel: u64,
    /// The number of instructions that all groups of one thread may execute together.
    pub budget: u64,
    /// A request to stop drawing.
    pub cancelled: Option<Arc<AtomicBool>>,
    /// The uniforms, followed by the large constants.
    pub(super) memory: Vec<u32>,
    /// The bound textures, by sampler.
    pub(super) textures: Vec<Option<Texture>>,
    /// The planes of each scalar, by input.
    pub(super) inputs: Vec<Vec<Plane>>,
    /// By input: the bits of each scalar by case, for inputs that depend on the case.
    pub(super) by_case: Vec<Option<Vec<Vec<u32>>>>,
}

/// What a draw call consists of besides its code.
#[derive(Clone)]
pub struct DrawInputs {
    size: [u32; 2],
    fuel: u64,
    budget: u64,
    memory: Vec<u32>,
    textures: Vec<Option<Texture>>,
    inputs: Vec<Vec<Plane>>,
    by_case: Vec<Option<Vec<Vec<u32>>>>,
}

impl DrawInputs {
    /// The draw call, of the code that it was made with.
    pub fn with<'c>(&self, code: &'c Bytecode) -> Draw<'c> {
        Draw {
            code,
            size: self.size,
            fuel: self.fuel,
            budget: self.budget,
            cancelled: None,
            memory: self.memory.clone(),
            textures: self.textures.clone(),
            inputs: self.inputs.clone(),
            by_case: self.by_case.clone(),
        }
    }

    /// Takes over the uniforms and textures of a draw of similar code, by their names and types. The
    /// inputs are those of `code`, the others those of `from_code`.
    pub fn take_over(&mut self, code: &Bytecode, from: &DrawInputs, from_code: &Bytecode) {
        for slot in &code.uniforms {
            let mut known = from_code.uniforms.iter();
            let Some(old) = known.find(|old| old.name == slot.name && old.ty == slot.ty) else {
                continue;
            };
            let count = (slot.ty.element().components() * slot.ty.array.max(1)) as usize;
            let (at, from_at) = (slot.at as usize, old.at as usize);
            let words = from.memory.get(from_at..from_at + count);
            if let (Some(to), Some(words)) = (self.memory.get_mut(at..at + count), words) {
                to.copy_from_slice(words);
            }
        }
        for (slot, texture) in code.samplers.iter().zip(&mut self.textures) {
            let old = from_code.samplers.iter().position(|old| old == slot);
            if let Some(bound) = old.and_then(|old| from.textures.get(old)) {
                texture.clone_from(bound);
            }
        }
        self.inputs.clone_from(&from.inputs);
        (self.size, self.fuel, self.budget) = (from.size, from.fuel, from.budget);
    }
}

/// A linear input: the value at `gl_FragCoord` 0, and its increments per pixel to the right and up.
type Plane = [f32; 3];

/// Why a run was aborted.
#[derive(Clone, PartialEq, Debug)]
pub enum Stop {
    /// A group of pixels used up its fuel, or the thread its budget.
    OutOfFuel {
        /// The first pixel of the group.
        pixel: [u32; 2],
    },
    /// Its result is no longer needed.
    Cancelled,
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Stop::OutOfFuel { pixel: [x, y] } => {
                write!(
                    f,
                    "the pixels around ({x}, {y}) exceeded the operation limit"
                )
            }
            Stop::Cancelled => f.write_str("the run was cancelled"),
        }
    }
}

impl<'c> Draw<'c> {
    /// A draw call with all uniforms zero and no textures.
    pub fn new(code: &'c Bytecode, size: [u32; 2]) -> Draw<'c> {
        let mut memory = vec![0; code.uniform_words as usize];
        memory.extend_from_slice(&code.tables);
        let planes = |slot: &InputSlot| match slot.name.as_str() {
            "gl_FragCoord" => vec![
                [0.0, 1.0, 0.0],
                [0.0, 0.0, 1.0],
                [0.5, 0.0, 0.0],
                [1.0, 0.0, 0.0],
            ],
            "gl_FrontFacing" => vec![[1.0, 0.0, 0.0]],
            _ => vec![[0.0; 3]; slot.regs.len()],
        };
        Draw {
            code,
            size,
            fuel: FUEL,
            budget: u64::MAX,
            cancelled: None,
            memory,
            textures: vec![None; code.samplers.len()],
            inputs: code.inputs.iter().map(planes).collect(),
            by_case: vec![None; code.inputs.len()],
        }
    }

    /// Whether the draw has to stop.
    pub(super) fn is_cancelled(&self) -> bool {
        let flag = self.cancelled.as_ref();
        flag.is_some_and(|flag| flag.load(Ordering::Relaxed))
    }

    /// The draw call without its code.
    pub fn into_inputs(self) -> DrawInputs {
        DrawInputs {
            size: self.size,
            fuel: self.fuel,
            budget: self.budget,
            memory: self.memory,
            textures: self.textures,
            inputs: self.inputs,
            by_case: self.by_case,
        }
    }

    /// Sets a uniform to `scalars`, with matrices in column-major order and array elements in
    /// sequence; `name[i]` sets the elements from index `i` on. Returns whether the uniform exists
    /// and has this many scalars.
    pub fn set(&mut self, name: &str, scalars: &[f64]) -> bool {
        let (base, first) = match name.strip_suffix(']').and_then(|n| n.rsplit_once('[')) {
            Some((base, number)) => (base, number.parse::<usize>().ok()),
            None => (name, Some(0)),
        };
        let slot = self.code.uniforms.iter().find(|u| u.name == name);
        let slot = slot.or_else(|| self.code.uniforms.iter().find(|u| u.name == base));
        let (Some(slot), Some(first)) = (slot, first) else {
            return false;
        };
        let first = if slot.name == name { 0 } else { first };
        let element = slot.ty.element().components() as usize;
        let count = element * slot.ty.array.max(1) as usize;
        let from = first.saturating_mul(element);
        let is_complete = scalars.len().is_multiple_of(element.max(1)) && !scalars.is_empty();
        if !is_complete || from.saturating_add(scalars.len()) > count {
            return false;
        }
        let kind = slot.ty.element().scalar_kind();
        let at = slot.at as usize + from;
        let words = self.memory.get_mut(at..at + scalars.len());
        for (word, scalar) in words.into_iter().flatten().zip(scalars) {
            *word = match kind {
                Some(Scalar::Bool) => {
                    if *scalar != 0.0 {
                        u32::MAX
                    } else {
                        0
                    }
                }
                Some(Scalar::Int) => *scalar as i32 as u32,
                Some(Scalar::Uint) => *scalar as i64 as u32,
                Some(Scalar::Float) | None => (*scalar as f32).to_bits(),
            };
        }
        true
    }

    /// The uniforms whose values differ from those of another draw call of the same code.
    pub fn differences(&self, other: &Draw<'_>) -> impl Iterator<Item = &'c UniformSlot> {
        let words = |draw: &[u32], slot: &UniformSlot| {
            let count = slot.ty.element().components() * slot.ty.array.max(1);
            let words = draw.get(slot.at as usize..(slot.at + count) as usize);
            words.map(<[u32]>::to_vec)
        };
        let slots = self.code.uniforms.iter();
        slots.filter(move |slot| words(&self.memory, slot) != words(&other.memory, slot))
    }

    /// Binds a texture to a sampler. Returns whether the sampler exists and its type fits.
    pub fn bind(&mut self, name: &str, texture: Texture) -> bool {
        let mut found = false;
        for (slot, place) in self.code.samplers.iter().zip(&mut self.textures) {
            if slot.name == name && texture.fits(slot.sampler) {
                *place = Some(texture.clone());
                found = true;
            }
        }
        found
    }

    /// Sets an input by case: for each scalar, its bits in all cases. Returns whether the input exists.
    /// Runs without cases have the values of the first case.
    pub fn input_by_case(&mut self, name: &str, bits: Vec<Vec<u32>>) -> bool {
        let mut slots = self.code.inputs.iter().zip(&mut self.by_case);
        match slots.find(|(slot, _)| slot.name == name) {
            Some((slot, place)) if bits.len() == slot.regs.len() => {
                *place = Some(bits);
                true
            }
            _ => false,
        }
    }

    /// Sets an input, one plane per scalar: the value at `gl_FragCoord` 0, and the increments per
    /// pixel to the right and up. Returns whether the input exists.
    pub fn input(&mut self, name: &str, planes: &[Plane]) -> bool {
        let mut slots = self.code.inputs.iter().zip(&mut self.inputs);
        match slots.find(|(slot, _)| slot.name == name) {
            Some((slot, place)) if planes.len() == slot.regs.len() => {
                *place = planes.to_vec();
                true
            }
            _ => false,
        }
    }
}
