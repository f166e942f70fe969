//! Equality of two shaders: identical bytecode proves that they draw the same image; otherwise both
//! are run and their outputs compared bit by bit.

use super::bytecode::Bytecode;
use super::draw::{Draw, Stop};
use super::render::{Sampled, quads_all_over, sample};

/// Number of frames compared.
const MOMENTS: usize = 8;
/// Number of quads sampled per frame.
const QUADS: usize = 288;
/// Width and height of the image in which shaders are compared.
pub const COMPARED_SIZE: [u32; 2] = [640, 360];

/// The result of a comparison of two shaders.
#[derive(Clone, PartialEq, Debug)]
pub enum Equality {
    /// The bytecode is identical, so all images are.
    Proved,
    /// All sampled pixels are identical.
    SampledEqual {
        /// The number of pixels compared.
        pixels: u64,
    },
    /// A pixel differs.
    Differs {
        /// `gl_FragCoord.xy` minus 0.5.
        pixel: [u32; 2],
        /// Index of the frame, from 0.
        moment: usize,
    },
    /// Not enough fuel to compare a single frame.
    TooLong,
}

/// Compares two shaders. `draws` makes the draw calls of both at a frame (0, 1, ...), with equal
/// uniforms, textures and inputs, over an image of [`COMPARED_SIZE`]. `fuel` is the number of
/// instructions that may be executed; the remaining fuel is written back.
pub fn equality<'c>(
    [a, b]: [&'c Bytecode; 2],
    fuel: &mut u64,
    draws: &dyn Fn(usize) -> [Draw<'c>; 2],
) -> Equality {
    if a.is_same(b) {
        return Equality::Proved;
    }
    let mut pixels = 0;
    for moment in 0..MOMENTS {
        let quads = quads_all_over(COMPARED_SIZE, QUADS, moment as u32);
        let [a, b] = draws(moment).map(|draw| run(draw, &quads, fuel));
        let (Ok(a), Ok(b)) = (a, b) else {
            break;
        };
        if let Some(pixel) = first_difference(&a, &b) {
            return Equality::Differs { pixel, moment };
        }
        pixels += a.pixels.len() as u64;
    }
    match pixels {
        0 => Equality::TooLong,
        pixels => Equality::SampledEqual { pixels },
    }
}

/// Samples quads with the remaining fuel.
fn run(mut draw: Draw<'_>, quads: &[[u32; 2]], fuel: &mut u64) -> Result<Sampled, Stop> {
    draw.budget = *fuel;
    let sampled = sample(&draw, quads);
    let spent = sampled.as_ref().map_or(*fuel, |s| s.spent);
    *fuel = fuel.saturating_sub(spent);
    sampled
}

fn first_difference(a: &Sampled, b: &Sampled) -> Option<[u32; 2]> {
    let differs = |at: &usize| {
        let is_covered = a.covered.get(*at) == Some(&true);
        if a.covered.get(*at) != b.covered.get(*at) || a.outputs.len() != b.outputs.len() {
            return true;
        }
        let mut outputs = a.outputs.iter().zip(&b.outputs);
        is_covered && outputs.any(|(a, b)| a.get(*at) != b.get(*at))
    };
    let at = (0..a.pixels.len()).find(differs)?;
    a.pixels.get(at).copied()
}

impl Bytecode {
    /// Whether the bytecode is identical for the same uniforms and samplers. Names of stage inputs
    /// must match, but not names of outputs.
    fn is_same(&self, other: &Bytecode) -> bool {
        self.body == other.body
            && self.uniform_prologue == other.uniform_prologue
            && self.constants == other.constants
            && self.tables == other.tables
            && self.arrays == other.arrays
            && self.lookups == other.lookups
            && self.uniforms == other.uniforms
            && self.samplers == other.samplers
            && self.inputs == other.inputs
            && self.outputs.len() == other.outputs.len()
            && self
                .outputs
                .iter()
                .zip(&other.outputs)
                .all(|(a, b)| a.regs == b.regs)
    }
}
