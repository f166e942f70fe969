//! Substitutes for missing files, drawn by small shaders.

use super::PlaybackProblem;
use crate::RenderedImage;
use shaderlint_exec::{
    Bytecode, CompileOptions, Draw, Image, ImageShape, Stop, Texels, compile, draw,
};
use shaderlint_explain::analyze_alone;
use shaderlint_ir::lower;
use shaderlint_project::{Input, InputKind, StandIn};
use shaderlint_text::Role;
use std::sync::Arc;

/// A substitute for a file. It is black until it is painted.
pub(super) struct SubstituteImage {
    code: Bytecode,
    key: StandInKey,
    image: Arc<Image>,
    is_painted: bool,
}

/// The inputs that determine a substitute.
#[derive(Clone, PartialEq)]
struct StandInKey {
    stand_in: StandIn,
    kind: InputKind,
    vflip: bool,
    has_levels: bool,
}

impl StandInKey {
    fn of(stand_in: &StandIn, input: &Input) -> StandInKey {
        StandInKey {
            stand_in: *stand_in,
            kind: input.kind,
            vflip: input.sampler.vflip,
            has_levels: input.sampler.has_mipmaps(),
        }
    }

    /// The shape of the image, and its width, height and number of layers.
    const fn shape(&self) -> (ImageShape, [u32; 3]) {
        let [width, height, depth] = self.stand_in.size;
        match self.kind {
            InputKind::Cubemap => (ImageShape::Cube, [width, height, 6]),
            InputKind::Volume => (ImageShape::Volume, [width, height, depth]),
            _ => (ImageShape::Flat, [width, height, 1]),
        }
    }

    /// A black image of the shape.
    fn black(&self) -> Option<Image> {
        let (shape, size) = self.shape();
        let count = size.iter().map(|n| *n as usize).product();
        Image::new(shape, size, Texels::Unorm8(vec![[0; 4]; count])).ok()
    }
}

impl SubstituteImage {
    /// The index of the substitute for the file of an input in `known`, to which it is added.
    pub fn index(
        known: &mut Vec<SubstituteImage>,
        stand_in: &StandIn,
        input: &Input,
    ) -> Result<usize, PlaybackProblem> {
        let key = StandInKey::of(stand_in, input);
        if let Some(at) = known.iter().position(|one| one.key == key) {
            return Ok(at);
        }
        known.push(SubstituteImage {
            code: code_of(stand_in)?,
            image: Arc::new(key.black().ok_or(no_stand_in(stand_in))?),
            key,
            is_painted: false,
        });
        Ok(known.len() - 1)
    }

    pub fn image(&self) -> Arc<Image> {
        self.image.clone()
    }

    pub const fn is_painted(&self) -> bool {
        self.is_painted
    }

    /// Paints it, once.
    pub fn paint(&mut self, threads: usize) -> Result<(), Stop> {
        if !self.is_painted {
            if let Some(image) = paint(&self.code, &self.key, 0.0, threads)? {
                self.image = Arc::new(image);
            }
            self.is_painted = true;
        }
        Ok(())
    }
}

/// A substitute for a video, drawn for each frame.
pub(super) struct Film {
    code: Bytecode,
    key: StandInKey,
    time: f64,
    image: Arc<Image>,
}

impl Film {
    pub fn new(stand_in: &StandIn, input: &Input) -> Result<Film, PlaybackProblem> {
        let key = StandInKey::of(stand_in, input);
        Ok(Film {
            code: code_of(stand_in)?,
            image: Arc::new(key.black().ok_or(no_stand_in(stand_in))?),
            key,
            time: 0.0,
        })
    }

    pub fn image(&self) -> Arc<Image> {
        self.image.clone()
    }

    /// Goes to a time, without its image.
    pub fn seek(&mut self, time: f64) {
        self.time = time;
    }

    pub fn time(&self) -> f64 {
        self.time
    }

    pub fn update(&mut self, time: f64, threads: usize) -> Result<(), Stop> {
        self.time = time;
        if let Some(image) = paint(&self.code, &self.key, time, threads)? {
            self.image = Arc::new(image);
        }
        Ok(())
    }
}

const fn no_stand_in(stand_in: &StandIn) -> PlaybackProblem {
    PlaybackProblem::StandIn {
        generator: stand_in.generator.name,
    }
}

fn code_of(stand_in: &StandIn) -> Result<Bytecode, PlaybackProblem> {
    let checked = analyze_alone(stand_in.generator.fragment(), Role::Prelude);
    let checked = checked.ok_or(no_stand_in(stand_in))?;
    let module = lower(&checked.program);
    let code = compile(&checked.program, &module, &CompileOptions::default());
    code.map_err(|_| no_stand_in(stand_in))
}

/// Draws all layers of a substitute.
fn paint(
    code: &Bytecode,
    key: &StandInKey,
    time: f64,
    threads: usize,
) -> Result<Option<Image>, Stop> {
    let (shape, [width, height, layers]) = key.shape();
    let mut one = Draw::new(code, [width, height]);
    one.set("size", &[f64::from(width), f64::from(height)]);
    one.set("flip", &[f64::from(u8::from(key.vflip))]);
    one.set("time", &[time]);
    let mut colors = Vec::new();
    for layer in 0..layers {
        one.set("layer", &[f64::from(layer)]);
        let drawn = draw(&one, threads)?;
        colors.extend(RenderedImage::of(code, &drawn, 0).pixels);
    }
    if key.stand_in.is_gray {
        for [_, green, blue, alpha] in &mut colors {
            (*green, *blue, *alpha) = (0.0, 0.0, 1.0);
        }
    }
    let texels = Texels::of_colors(&colors);
    let image = Image::new(shape, [width, height, layers], texels).ok();
    Ok(image.map(|image| match key.has_levels {
        true => image.with_levels(),
        false => image,
    }))
}
