//! Whether two shaders draw the same picture: the same register code proves it; else both are run and
//! every bit is compared.

use super::code::Code;
use super::draw::{Draw, Stop};
use super::render::{Sampled, quads_all_over, sample};

/// How many moments are compared.
const MOMENTS: usize = 8;
/// How many quads of each.
const QUADS: usize = 288;
/// The size of the picture in which shaders are compared.
pub const COMPARED_SIZE: [u32; 2] = [640, 360];

/// What is known of two shaders.
#[derive(Clone, PartialEq, Debug)]
pub enum Equality {
    /// The register code is the same, so that every picture is.
    Proved,
    /// As many pixels have the same bits.
    Seen {
        /// How many were compared.
        pixels: u64,
    },
    /// This pixel has not.
    Differs {
        /// `gl_FragCoord.xy`, less the half.
        pixel: [u32; 2],
        /// Number of the moment.
        moment: usize,
    },
    /// One of them takes too long to be compared.
    TooLong,
}

/// Compares two shaders. `draws` makes a draw of either at a moment, which are numbered from 0: with
/// the same uniforms, textures and inputs, over a picture of [`COMPARED_SIZE`]. `fuel` is how many
/// instructions may be run for it, and what is left of them afterwards.
pub fn equality<'c>(
    [a, b]: [&'c Code; 2],
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
        pixels => Equality::Seen { pixels },
    }
}

/// Runs quads with the fuel that is left.
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

impl Code {
    /// Whether it is the same code for the same uniforms and samplers. Names of inputs of the stage
    /// count, those of outputs do not.
    fn is_same(&self, other: &Code) -> bool {
        self.body == other.body
            && self.prologue == other.prologue
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
