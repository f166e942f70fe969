//! Runs projects as the player does: all passes in order, with their channels and the results of
//! previous frames.

mod channel;
mod problem;
mod shader;
mod signal;
mod sound;
mod stand_in;
mod still;
mod target;

use super::image::RenderedImage;
use channel::Channel;
use shader::PassShader;
use shaderlint_engine::inputs::{Moment, Unfit};
use shaderlint_exec::{CompileOptions, Draw, DrawInputs, Drawn, Stop, draw};
use shaderlint_project::{Composed, Project};
use shaderlint_semantic::Pass;
use stand_in::SubstituteImage;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use target::{CUBE_SIDE, ImagePair};

pub use problem::PlaybackProblem;
pub use sound::SOUND_RATE;
pub use still::{Decode, Decoded};

/// A project that can be run.
pub struct Player {
    /// Width and height of the image in pixels.
    size: [u32; 2],
    threads: usize,
    /// The passes in the order of the project.
    passes: Vec<PlayedPass>,
    targets: Vec<ImagePair>,
    /// The images that replace files.
    stand_ins: Vec<SubstituteImage>,
    /// The image after the last frame.
    canvas: Vec<[f32; 4]>,
    /// Number of the next frame.
    next: u32,
    /// Notes about substitutes.
    pub notes: Vec<String>,
    /// A request to stop drawing.
    pub cancelled: Option<Arc<AtomicBool>>,
}

/// A pass that can be run.
struct PlayedPass {
    index: usize,
    kind: Pass,
    shader: PassShader,
    channels: Vec<Channel>,
    /// The render target; `None` for the image only.
    target: Option<usize>,
}

/// The result of a frame.
#[derive(Debug)]
pub struct Played {
    /// The image.
    pub image: RenderedImage,
    /// By pass that was drawn, except sound: its index in the project, and its draw. For a cube
    /// map, the last face.
    pub passes: Vec<(usize, Drawn)>,
}

/// Options for running a project.
#[derive(Clone, Copy, Debug)]
pub struct PlaybackOptions {
    /// Width and height of the image in pixels.
    pub size: [u32; 2],
    /// Number of threads.
    pub threads: usize,
    /// Compiler options of the observed passes; others are only drawn.
    pub compile: CompileOptions,
    /// The observed pass, by its index in the project; `None` for all.
    pub observed: Option<usize>,
    /// Decoder for embedded images.
    pub decode: Option<Decode>,
}

impl Player {
    /// Compiles a project. `composed` is its composed source.
    ///
    /// # Errors
    /// What cannot be run.
    pub fn new(
        project: &Project,
        composed: &Composed,
        options: &PlaybackOptions,
    ) -> Result<Player, PlaybackProblem> {
        let units = composed.units.iter().filter(|u| u.kind != Pass::Common);
        let mut player = Player {
            size: options.size,
            threads: options.threads.max(1),
            passes: Vec::new(),
            targets: Vec::new(),
            stand_ins: Vec::new(),
            canvas: vec![[0.0, 0.0, 0.0, 1.0]; area(options.size)],
            next: 0,
            notes: Vec::new(),
            cancelled: None,
        };
        for unit in units {
            let Some(pass) = project.passes.get(unit.pass) else {
                continue;
            };
            let compile = match options.observed {
                Some(observed) if observed != unit.pass => CompileOptions {
                    gpu_profile: options.compile.gpu_profile,
                    most: options.compile.most,
                    ..CompileOptions::default()
                },
                _ => options.compile,
            };
            let shader = PassShader::of(project, composed, unit, &compile)?;
            player.passes.push(PlayedPass {
                index: unit.pass,
                kind: pass.kind,
                shader,
                channels: Vec::new(),
                target: None,
            });
        }
        target::make(&mut player, project)?;
        channel::open(&mut player, project, options.decode)?;
        Ok(player)
    }

    /// Sets a uniform for all frames, in shaders that declare their own uniforms.
    ///
    /// # Errors
    /// Why no shader accepts it.
    pub fn set(&mut self, name: &str, scalars: &[f64]) -> Result<(), Unfit> {
        let shaders = self.passes.iter_mut().map(|pass| &mut pass.shader);
        let set = shaders.map(|shader| shader.set(name, scalars));
        let mut refused = Unfit::Unknown;
        let mut is_set = false;
        for one in set {
            match one {
                Ok(()) => is_set = true,
                Err(Unfit::Unknown) => {}
                Err(unfit) => refused = unfit,
            }
        }
        if is_set { Ok(()) } else { Err(refused) }
    }

    /// Whether a frame depends on previous frames.
    pub fn remembers(&self) -> bool {
        let order: Vec<usize> = self.order().collect();
        let reads_old = |at: usize, pass: usize| {
            let earlier = order.get(..at).unwrap_or_default();
            let is_new = |target: usize| {
                let mut drawn = earlier.iter().filter_map(|p| self.passes.get(*p));
                drawn.any(|p| p.target == Some(target))
            };
            let channels = self.passes.get(pass).map_or(&[][..], |p| &p.channels);
            let mut read = channels.iter().filter_map(Channel::target);
            read.any(|target| self.is_drawn(target) && !is_new(target))
        };
        let mut channels = self.passes.iter().flat_map(|p| &p.channels);
        if channels.any(Channel::remembers) {
            return true;
        }
        let mut passes = order.iter().enumerate();
        passes.any(|(at, pass)| reads_old(at, *pass))
    }

    /// Whether a pass draws to a target.
    fn is_drawn(&self, target: usize) -> bool {
        self.passes.iter().any(|p| p.target == Some(target))
    }

    /// The passes of a frame in drawing order.
    fn order(&self) -> impl Iterator<Item = usize> {
        let kinds = [Pass::Buffer, Pass::Cubemap, Pass::Image];
        kinds.into_iter().flat_map(|kind| {
            let all = self.passes.iter().enumerate();
            all.filter(move |(_, p)| p.kind == kind).map(|(i, _)| i)
        })
    }

    /// Draws a frame. If it depends on previous frames, these are drawn first: as many as its
    /// number, with times spread evenly. `progress` is called before each frame.
    ///
    /// # Errors
    /// Why a draw was stopped.
    pub fn play_to(
        &mut self,
        moment: &Moment,
        progress: &mut dyn FnMut(u32),
    ) -> Result<Played, Stop> {
        self.approach(moment, progress)?;
        self.frame(moment)
    }

    /// Prepares the draw of a pass, given by its index in the project, in a frame; `None` if the pass is
    /// not drawn as an image. Frames and passes that it depends on are drawn first, as
    /// [`Player::play_to`] does.
    ///
    /// # Errors
    /// Why a draw before it was stopped.
    pub fn prepared(
        &mut self,
        moment: &Moment,
        pass: usize,
        progress: &mut dyn FnMut(u32),
    ) -> Result<Option<DrawInputs>, Stop> {
        self.approach(moment, progress)?;
        self.begin(moment, true)?;
        let mut inputs = None;
        for at in self.order().collect::<Vec<_>>() {
            let found = self.passes.get(at).filter(|p| p.index == pass);
            if let Some(found) = found.filter(|p| p.kind != Pass::Cubemap) {
                let prepared = self.prepare(found, self.size_of(found), moment);
                inputs = Some(prepared.into_inputs());
                break;
            }
            self.draw_pass(at, moment)?;
        }
        // The frame is not complete.
        self.restart();
        Ok(inputs)
    }

    /// What [`Player::prepared`] returns, but with images of other passes and of files' substitutes that are
    /// not drawn yet.
    ///
    /// # Errors
    /// Why a draw of an input was stopped.
    pub fn undrawn(&mut self, moment: &Moment, pass: usize) -> Result<Option<DrawInputs>, Stop> {
        self.begin(moment, false)?;
        let mut passes = self.passes.iter();
        let found = passes.find(|p| p.index == pass && p.kind != Pass::Cubemap);
        let inputs = found.map(|found| {
            let prepared = self.prepare(found, self.size_of(found), moment);
            prepared.into_inputs()
        });
        self.restart();
        Ok(inputs)
    }

    /// Whether [`Player::prepared`] draws anything.
    pub fn depends(&self, moment: &Moment, pass: usize) -> bool {
        let first = self.order().next().and_then(|at| self.passes.get(at));
        let is_first = first.is_some_and(|first| first.index == pass);
        let is_painted = self.stand_ins.iter().all(SubstituteImage::is_painted);
        let has_film = self
            .passes
            .iter()
            .any(|p| p.channels.iter().any(Channel::is_film));
        !is_first || !is_painted || has_film || moment.frame > 0 && self.remembers()
    }

    /// Draws the frames that a frame depends on.
    fn approach(&mut self, moment: &Moment, progress: &mut dyn FnMut(u32)) -> Result<(), Stop> {
        if self.remembers() {
            if self.next > moment.frame {
                self.restart();
            }
            for frame in self.next..moment.frame {
                progress(frame);
                let time = moment.time * f64::from(frame) / f64::from(moment.frame);
                let earlier = Moment {
                    time,
                    frame,
                    ..moment.clone()
                };
                self.frame(&earlier)?;
            }
        }
        progress(moment.frame);
        Ok(())
    }

    /// Clears all render targets.
    pub fn restart(&mut self) {
        self.targets.iter_mut().for_each(ImagePair::clear);
        self.canvas.fill([0.0, 0.0, 0.0, 1.0]);
        self.next = 0;
    }

    /// Draws the next frame.
    ///
    /// # Errors
    /// Why a draw was stopped.
    pub fn frame(&mut self, moment: &Moment) -> Result<Played, Stop> {
        self.begin(moment, true)?;
        let mut passes = Vec::new();
        for at in self.order().collect::<Vec<_>>() {
            passes.extend(self.draw_pass(at, moment)?);
        }
        self.next = moment.frame.saturating_add(1);
        Ok(Played {
            image: RenderedImage {
                size: self.size,
                pixels: self.canvas.clone(),
            },
            passes,
        })
    }

    /// Prepares what changes once per frame. `paints` is whether images are painted that replace files.
    fn begin(&mut self, moment: &Moment, paints: bool) -> Result<(), Stop> {
        if moment.frame == 0 {
            self.restart();
        }
        channel::update(self, moment, paints)
    }

    /// Draws a pass. Returns its index in the project, and its draw.
    fn draw_pass(&mut self, at: usize, moment: &Moment) -> Result<Option<(usize, Drawn)>, Stop> {
        match self.passes.get(at).map(|pass| pass.kind) {
            None => Ok(None),
            Some(Pass::Cubemap) => self.draw_cube(at, moment),
            Some(_) => self.draw_flat(at, moment),
        }
    }

    /// The size of the image of a pass.
    fn size_of(&self, pass: &PlayedPass) -> [u32; 2] {
        let target = pass.target.and_then(|target| self.targets.get(target));
        target.map_or(self.size, |pair| pair.side)
    }

    /// A draw of a pass with all its inputs.
    fn prepare<'p>(&self, pass: &'p PlayedPass, size: [u32; 2], moment: &Moment) -> Draw<'p> {
        let mut draw = pass.shader.draw(size, moment);
        let given: Vec<_> = pass
            .channels
            .iter()
            .map(|channel| (channel, channel.read(self, pass.kind)))
            .collect();
        channel::bind(&mut draw, &pass.shader, &given);
        draw.cancelled.clone_from(&self.cancelled);
        draw
    }

    fn draw_flat(&mut self, at: usize, moment: &Moment) -> Result<Option<(usize, Drawn)>, Stop> {
        let Some(pass) = self.passes.get(at) else {
            return Ok(None);
        };
        let drawn = draw(
            &self.prepare(pass, self.size_of(pass), moment),
            self.threads,
        )?;
        let image = RenderedImage::of(pass.shader.code(), &drawn, 0);
        let (index, kind, target) = (pass.index, pass.kind, pass.target);
        if kind == Pass::Image {
            // Discarded pixels keep the previous colour.
            let shown = self.canvas.iter_mut().zip(&image.pixels);
            for ((old, new), is_covered) in shown.zip(&drawn.covered) {
                if *is_covered {
                    *old = *new;
                }
            }
        }
        if let Some(target) = target.and_then(|target| self.targets.get_mut(target)) {
            target.take(image.pixels, &drawn.covered);
        }
        Ok(Some((index, drawn)))
    }

    fn draw_cube(&mut self, at: usize, moment: &Moment) -> Result<Option<(usize, Drawn)>, Stop> {
        let Some(pass) = self.passes.get(at) else {
            return Ok(None);
        };
        let mut prepared = self.prepare(pass, [CUBE_SIDE; 2], moment);
        let side = f64::from(CUBE_SIDE);
        prepared.set("unViewport", &[0.0, 0.0, side, side]);
        let (mut pixels, mut covered) = (Vec::new(), Vec::new());
        let mut last = None;
        for corners in &target::CUBE_CORNERS {
            // The eye is at the origin.
            let mut lanes = corners.to_vec();
            lanes.extend([0.0; 3]);
            prepared.set("unCorners", &lanes);
            let drawn = draw(&prepared, self.threads)?;
            pixels.extend(RenderedImage::of(pass.shader.code(), &drawn, 0).pixels);
            covered.extend_from_slice(&drawn.covered);
            last = Some((pass.index, drawn));
        }
        let target = pass.target;
        if let Some(target) = target.and_then(|target| self.targets.get_mut(target)) {
            target.take(pixels, &covered);
        }
        Ok(last)
    }

    /// The bytecode of a pass, by its index in the project.
    pub fn code(&self, pass: usize) -> Option<&shaderlint_exec::Bytecode> {
        let pass = self.passes.iter().find(|p| p.index == pass)?;
        Some(pass.shader.code())
    }
}

/// Number of pixels of an image.
fn area(size: [u32; 2]) -> usize {
    size.iter().map(|side| *side as usize).product()
}
