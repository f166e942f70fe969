//! A draw: register code with its uniforms, textures and inputs, over a rectangle of pixels.

use super::code::Code;
use super::image::Texture;
use super::seen::Seen;

/// Operations of one pixel after which a run stops, unless it is told otherwise.
const FUEL: u64 = 50_000_000;

/// What a shader is run with.
pub struct Draw<'c> {
    /// The shader.
    pub code: &'c Code,
    /// The size of the picture in pixels.
    pub size: [u32; 2],
    /// How many operations each group of pixels may take.
    pub fuel: u64,
}

/// What a draw gave. Rows of pixels begin at the bottom, as `gl_FragCoord` counts.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The size in pixels.
    pub size: [u32; 2],
    /// By output, by pixel: its scalars as bits, the first four of them.
    pub outputs: Vec<Vec<[u32; 4]>>,
    /// By pixel: whether it was drawn, and not discarded.
    pub covered: Vec<bool>,
    /// By pixel: how many operations it took part in.
    pub cost: Vec<u32>,
    /// What was seen on the way.
    pub seen: Seen,
}

/// What was run of a picture: four pixels for each quad, in the order of lanes.
#[derive(Clone, Debug)]
pub struct Sampled {
    /// The pixels.
    pub pixels: Vec<[u32; 2]>,
    /// By output, by pixel: its scalars as bits, the first four of them.
    pub outputs: Vec<Vec<[u32; 4]>>,
    /// By pixel: whether it was drawn, and not discarded.
    pub covered: Vec<bool>,
    /// By pixel: how many operations it took part in.
    pub cost: Vec<u32>,
    /// What was seen on the way.
    pub seen: Seen,
}

/// Why a run ended before its end.
#[derive(Clone, PartialEq, Debug)]
pub enum Stop {
    /// A group of pixels took all the operations that it may take.
    OutOfFuel {
        /// The first of its pixels.
        pixel: [u32; 2],
    },
}

impl<'c> Draw<'c> {
    /// A draw with all uniforms zero and no textures.
    pub fn new(code: &'c Code, size: [u32; 2]) -> Draw<'c> {
        Draw {
            code,
            size,
            fuel: FUEL,
        }
    }

    /// Sets a uniform: its scalars, those of a matrix column by column, those of an array element by
    /// element; `name[i]` sets one element. Whether there is such a uniform with that many scalars.
    pub fn set(&mut self, _name: &str, _scalars: &[f64]) -> bool {
        false
    }

    /// Sets what a sampler looks up. Whether there is such a sampler.
    pub fn bind(&mut self, _name: &str, _texture: Texture) -> bool {
        false
    }

    /// Sets what an input is at each pixel: by scalar a number, and how it grows with each pixel to
    /// the right and up, from `gl_FragCoord` 0. Whether there is such an input.
    pub fn input(&mut self, _name: &str, _planes: &[[f32; 3]]) -> bool {
        false
    }
}

/// Draws all pixels, with this many threads.
///
/// # Errors
/// Why the run ended before its end.
pub fn draw(draw: &Draw<'_>, _threads: usize) -> Result<Drawn, Stop> {
    let count = draw.size.iter().map(|n| *n as usize).product();
    Ok(Drawn {
        size: draw.size,
        outputs: Vec::new(),
        covered: vec![false; count],
        cost: vec![0; count],
        seen: Seen::default(),
    })
}

/// Runs the quads whose lower left pixels, of even coordinates, are given.
///
/// # Errors
/// Why the run ended before its end.
pub fn sample(_draw: &Draw<'_>, quads: &[[u32; 2]]) -> Result<Sampled, Stop> {
    let count = quads.len() * 4;
    Ok(Sampled {
        pixels: Vec::new(),
        outputs: Vec::new(),
        covered: vec![false; count],
        cost: vec![0; count],
        seen: Seen::default(),
    })
}
