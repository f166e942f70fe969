//! Substitutes for missing files, drawn by small shaders.

use super::PlaybackProblem;
use crate::playback::RenderedImage;
use shaderlint_exec::{
    Bytecode, CompileOptions, Draw, Image, ImageShape, Stop, Texels, compile, draw,
};
use shaderlint_ir::lower;
use shaderlint_port::{Input, InputKind, StandIn};
use shaderlint_semantic::analyze_alone;
use shaderlint_text::Role;
use std::sync::Arc;

/// The substitutes of a project, each drawn once.
pub(super) struct StandIns {
    threads: usize,
    made: Vec<(StandInKey, Arc<Image>)>,
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
}

impl StandIns {
    pub fn new(threads: usize) -> StandIns {
        StandIns {
            threads,
            made: Vec::new(),
        }
    }

    /// The image that replaces the file of an input.
    pub fn get(
        &mut self,
        stand_in: &StandIn,
        input: &Input,
    ) -> Result<Arc<Image>, PlaybackProblem> {
        let key = StandInKey::of(stand_in, input);
        if let Some((_, image)) = self.made.iter().find(|(made, _)| *made == key) {
            return Ok(Arc::clone(image));
        }
        let code = code_of(stand_in)?;
        let image = paint(&code, &key, 0.0, self.threads).ok().flatten();
        let image = Arc::new(image.ok_or(no_stand_in(stand_in))?);
        self.made.push((key, Arc::clone(&image)));
        Ok(image)
    }
}

/// A substitute for a video, drawn for each frame.
pub(super) struct Film {
    code: Bytecode,
    key: StandInKey,
    time: f64,
    image: Option<Arc<Image>>,
}

impl Film {
    pub fn new(stand_in: &StandIn, input: &Input) -> Result<Film, PlaybackProblem> {
        Ok(Film {
            code: code_of(stand_in)?,
            key: StandInKey::of(stand_in, input),
            time: 0.0,
            image: None,
        })
    }

    pub fn image(&self) -> Option<Arc<Image>> {
        self.image.clone()
    }

    pub fn time(&self) -> f64 {
        self.time
    }

    pub fn update(&mut self, time: f64, threads: usize) -> Result<(), Stop> {
        self.time = time;
        self.image = paint(&self.code, &self.key, time, threads)?.map(Arc::new);
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
    let [width, height, depth] = key.stand_in.size;
    let (shape, layers) = match key.kind {
        InputKind::Cubemap => (ImageShape::Cube, 6),
        InputKind::Volume => (ImageShape::Volume, depth),
        _ => (ImageShape::Flat, 1),
    };
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
