//! Prepares a shader for drawing, and sets its uniforms.

use super::place::{position, span};
use super::setting::{ObservedRays, ShotSetting, UniformText};
use super::{show, uniforms};
use shaderlint_diagnostic::count;
use shaderlint_engine::inputs::{Moment, Scene, Unfit};
use shaderlint_exec::{
    Bytecode, CompileOptions, DrawInputs, Drawn, OutputSlot, PixelTrace, RayProbe, Refusal,
    Sampled, Stop, Watch, draw, sample, trace,
};
use shaderlint_ir::Module;
use shaderlint_lint::march::slope_probe;
use shaderlint_lint::{CachedFacts, Facts};
use shaderlint_play::{PlaybackOptions, Player};
use shaderlint_project::{Composed, PassRole, PassUnit, Project, Wrapper, missing};
use shaderlint_semantic::{Pass, Program, Stage, Storage};
use shaderlint_text::Sources;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, OnceLock};

/// A shader without errors.
pub struct Loaded {
    /// Name in messages.
    pub name: String,
    /// The passes of the shader.
    pub project: Project,
    /// The composed sources of the passes and their analyses.
    pub composed: Composed,
}

/// A pass that is ready to draw.
pub struct Shot {
    /// The player of the pass.
    play: Playback,
    /// The IR of the pass.
    pub module: Arc<Module>,
    /// Cached analyses of the pass.
    pub known: Arc<CachedFacts>,
    /// Index of the compile unit.
    pub unit: usize,
    /// Index of the pass in the project.
    pass: usize,
    /// Size of the image in pixels.
    pub size: [u32; 2],
    threads: usize,
    /// Whether the last outputs are those of a ray probe.
    observes_rays: bool,
}

/// What draws a pass.
enum Playback {
    /// The pass reads no other pass and no texture.
    Alone(Box<Scene>),
    /// The pass is drawn with the other passes of its project and its textures.
    Project(Box<Player>),
}

impl Shot {
    /// The bytecode of the pass.
    pub fn code(&self) -> &Bytecode {
        static NOTHING: OnceLock<Bytecode> = OnceLock::new();
        match &self.play {
            Playback::Alone(scene) => &scene.code,
            Playback::Project(player) => player
                .code(self.pass)
                .unwrap_or_else(|| NOTHING.get_or_init(Bytecode::default)),
        }
    }

    /// Draws a frame. `progress` is called before each frame that it depends on, with its number.
    ///
    /// # Errors
    /// A message about a run that was stopped.
    pub fn drawn(
        &mut self,
        moment: &Moment,
        progress: &mut dyn FnMut(u32),
    ) -> Result<Drawn, String> {
        match &mut self.play {
            Playback::Alone(scene) => {
                let own = scene.draw(self.size, moment);
                draw(&own, self.threads).map_err(|stop| stopped(&stop))
            }
            Playback::Project(player) => {
                let played = player.play_to(moment, progress);
                let played = played.map_err(|stop| stopped(&stop))?;
                let mut passes = played.passes.into_iter();
                let own = passes.find(|(number, _)| *number == self.pass);
                own.map(|(_, drawn)| drawn)
                    .ok_or_else(|| "the pass has no output".to_string())
            }
        }
    }

    /// Prepares the draw of a frame, of [`Shot::code`]. `progress` is called before each frame that it
    /// depends on, with its number.
    ///
    /// # Errors
    /// A message about a run that was stopped before.
    pub fn prepared(
        &mut self,
        moment: &Moment,
        progress: &mut dyn FnMut(u32),
    ) -> Result<DrawInputs, String> {
        match &mut self.play {
            Playback::Alone(scene) => Ok(scene.draw(self.size, moment).into_inputs()),
            Playback::Project(player) => {
                let inputs = player.prepared(moment, self.pass, progress);
                let inputs = inputs.map_err(|stop| stopped(&stop))?;
                inputs.ok_or_else(|| "the pass is not drawn as an image".to_string())
            }
        }
    }

    /// What [`Shot::prepared`] returns, but with images of other passes that are not drawn yet.
    ///
    /// # Errors
    /// A message about a run that was stopped before.
    pub fn undrawn(&mut self, moment: &Moment) -> Result<DrawInputs, String> {
        match &mut self.play {
            Playback::Alone(scene) => Ok(scene.draw(self.size, moment).into_inputs()),
            Playback::Project(player) => {
                let inputs = player.undrawn(moment, self.pass);
                let inputs = inputs.map_err(|stop| stopped(&stop))?;
                inputs.ok_or_else(|| "the pass is not drawn as an image".to_string())
            }
        }
    }

    /// Whether other passes or frames are drawn before a frame of the pass.
    pub fn depends(&self, moment: &Moment) -> bool {
        match &self.play {
            Playback::Alone(_) => false,
            Playback::Project(player) => player.depends(moment, self.pass),
        }
    }

    /// Draws stop when this flag is set.
    pub fn stop_on(&mut self, flag: Arc<AtomicBool>) {
        if let Playback::Project(player) = &mut self.play {
            player.cancelled = Some(flag);
        }
    }

    /// Records up to `most` steps of a pixel.
    ///
    /// # Errors
    /// A message about a pixel outside the image, or about a run that was stopped before.
    pub fn traced(
        &mut self,
        moment: &Moment,
        (pixel, most): ([u32; 2], usize),
        progress: &mut dyn FnMut(u32),
    ) -> Result<PixelTrace, String> {
        let [[x, y], [width, height]] = [pixel, self.size];
        if x >= width || y >= height {
            return Err(format!(
                "the pixel {x},{y} is outside the image of {width}x{height}"
            ));
        }
        let inputs = self.prepared(moment, progress)?;
        Ok(trace(&inputs.with(self.code()), pixel, most))
    }

    /// Draws some quads of a frame, given by their lower left pixels.
    ///
    /// # Errors
    /// A message about a run that was stopped.
    pub fn sampled(
        &mut self,
        moment: &Moment,
        quads: &[[u32; 2]],
        progress: &mut dyn FnMut(u32),
    ) -> Result<Sampled, String> {
        let inputs = self.prepared(moment, progress)?;
        sample(&inputs.with(self.code()), quads).map_err(|stop| stopped(&stop))
    }

    /// The outputs of the pass.
    pub fn outputs(&self) -> &[OutputSlot] {
        let all = &self.code().outputs;
        let probed = match self.observes_rays {
            true => RayProbe::OUTPUTS,
            false => 0,
        };
        all.get(..all.len().saturating_sub(probed)).unwrap_or(all)
    }

    /// Notes about inputs that were missing or replaced.
    pub fn notes(&self, project: &Project) -> Vec<String> {
        let mut notes = project.notes.clone();
        let quoted = |names: &[&str]| format!("`{}`", names.join("`, `"));
        match &self.play {
            Playback::Alone(scene) => {
                let zeros = scene.zeros();
                if !zeros.is_empty() {
                    notes.push(format!(
                        "these uniforms are not set and default to 0: {}; set them with --uniforms",
                        quoted(&zeros)
                    ));
                }
                let guessed: Vec<&str> = scene
                    .given
                    .bound
                    .guessed
                    .iter()
                    .map(String::as_str)
                    .collect();
                if !guessed.is_empty() {
                    notes.push(format!(
                        "these varyings have no vertex shader and default to the position in the image: {}",
                        quoted(&guessed)
                    ));
                }
            }
            Playback::Project(player) => {
                let missing = missing(project).into_iter();
                notes.extend(missing.map(|m| format!("{}: {}; {}", m.place, m.what, m.stand_in)));
                notes.extend(player.notes.iter().cloned());
            }
        }
        notes
    }

    /// Sets a uniform for all frames.
    fn set(&mut self, name: &str, scalars: &[f64]) -> Result<(), Unfit> {
        match &mut self.play {
            Playback::Alone(scene) => scene.set(name, scalars),
            Playback::Project(player) => player.set(name, scalars),
        }
    }
}

/// The message about a run that was stopped.
fn stopped(stop: &Stop) -> String {
    format!("stopped: {stop}")
}

impl Loaded {
    /// The checked program of the pass.
    pub fn program(&self, shot: &Shot) -> Option<&Program> {
        let unit = self.composed.units.get(shot.unit)?;
        Some(&self.composed.analysis(unit).program)
    }
}

/// Prepares the pass that is shown.
///
/// # Errors
/// A message about what cannot be drawn.
pub fn shot(loaded: &Loaded, setting: &ShotSetting) -> Result<Shot, String> {
    let Loaded { name, composed, .. } = loaded;
    let (at, unit) = chosen(loaded, setting.pass)?;
    let program = &composed.analysis(unit).program;
    let pass = loaded.project.passes.get(unit.pass);
    if unit.stage != Stage::Fragment || pass.is_some_and(|p| p.draw.has_vertices) {
        return Err(format!(
            "{name}: shaders that draw with a vertex shader are not supported"
        ));
    }
    let known = Arc::<CachedFacts>::default();
    let module = known.module(program).clone();
    let probe = match setting.show {
        Some(show) => Some(show::probe(show, composed, unit, program, &module)?),
        None => None,
    };
    let rays = match setting.rays {
        ObservedRays::Nothing => None,
        ObservedRays::Camera => Some(camera_rays(program, &known)?),
        ObservedRays::Probe(probe) => Some(probe),
    };
    let compile = CompileOptions {
        rays,
        watch: setting.watch,
        cost: setting.watch != Watch::Nothing,
        probe,
        trace: setting.trace,
        ..CompileOptions::default()
    };
    let (size, threads) = (setting.size, setting.threads);
    let play = match alone(loaded, unit, &module, &compile)? {
        Some(scene) => Playback::Alone(Box::new(scene)),
        None => {
            let options = PlaybackOptions {
                size,
                threads,
                compile,
                observed: Some(unit.pass),
                decode: setting.decode,
            };
            let player = Player::new(&loaded.project, composed, &options);
            Playback::Project(Box::new(player.map_err(|e| format!("{name}: {e}"))?))
        }
    };
    let mut shot = Shot {
        play,
        module,
        known,
        unit: at,
        pass: unit.pass,
        size,
        threads,
        observes_rays: rays.is_some(),
    };
    if let Some(uniforms) = setting.uniforms {
        set_uniforms(&mut shot, program, uniforms)?;
    }
    Ok(shot)
}

/// The probe of the first loop that follows rays from the camera by a distance.
///
/// # Errors
/// A message if there is none.
fn camera_rays(program: &Program, known: &Arc<CachedFacts>) -> Result<RayProbe, String> {
    let facts = Facts::of(program, known);
    let mut marches = facts.marches().iter().filter(|m| m.ray.start.is_some());
    marches.find_map(slope_probe).ok_or_else(|| {
        "--heatmap slope: no loop follows rays from the camera by a distance".to_string()
    })
}

/// The scene of a shader that has one pass and no samplers; `None` for others.
fn alone(
    loaded: &Loaded,
    unit: &PassUnit,
    module: &Module,
    options: &CompileOptions,
) -> Result<Option<Scene>, String> {
    let Loaded {
        name,
        project,
        composed,
        ..
    } = loaded;
    if composed.units.len() > 1 || unit.kind != Pass::Image {
        return Ok(None);
    }
    let program = &composed.analysis(unit).program;
    let scene = match (unit.wrapper, project.passes.get(unit.pass)) {
        (Wrapper::Own, Some(pass)) => Scene::bound(program, module, pass.bound.clone(), options),
        _ => Scene::of(program, project.host, module, options),
    };
    let mut scene = scene.map_err(|refusal| refused(&composed.sources, program, name, &refusal))?;
    let described = project.controls.iter().take(project.described);
    scene.set_controls(&described.cloned().collect::<Vec<_>>());
    Ok(scene.code.samplers.is_empty().then_some(scene))
}

/// The pass to show: the given one, the one whose file was opened, or the image pass.
fn chosen<'a>(loaded: &'a Loaded, asked: Option<&str>) -> Result<(usize, &'a PassUnit), String> {
    let passes = &loaded.project.passes;
    let slug = |unit: &PassUnit| passes.get(unit.pass).map_or("", |p| p.slug());
    let is_drawn = |role: &PassRole| matches!(role.kind(), Pass::Buffer | Pass::Cubemap);
    let opened = loaded.project.opened.filter(is_drawn);
    let asked = asked.or(opened.map(PassRole::name));
    let mut units = loaded.composed.units.iter().enumerate();
    let found = match asked {
        Some(asked) => units.find(|(_, unit)| slug(unit) == asked),
        None => units.find(|(_, unit)| unit.kind == Pass::Image),
    };
    found.ok_or_else(|| {
        let all: Vec<&str> = loaded.composed.units.iter().map(slug).collect();
        let requested = asked.unwrap_or("image");
        let name = &loaded.name;
        format!(
            "{name}: the project has no pass `{requested}`; it has {}",
            all.join(", ")
        )
    })
}

/// Sets the uniforms of a JSON file.
fn set_uniforms(
    shot: &mut Shot,
    program: &Program,
    UniformText { name: shown, text }: UniformText<'_>,
) -> Result<(), String> {
    let wrong = |(line, column): (usize, usize), message: String| {
        format!("{shown}:{line}:{column}: {message}")
    };
    let assigned = uniforms::read(text).map_err(|bad| wrong(bad.at, bad.message))?;
    for given in assigned {
        let unfit = match shot.set(&given.name, &given.scalars) {
            Ok(()) => continue,
            Err(unfit) => unfit,
        };
        let name = &given.name;
        let reason = match unfit {
            Unfit::Unknown => {
                let near = near(name, program);
                format!("unknown uniform `{name}`{near}")
            }
            Unfit::Sampler => format!("`{name}` is a sampler and cannot be set to a number"),
            Unfit::Count { takes, .. } => {
                let takes = count(takes, "number");
                format!("`{name}` expects {takes}, found {}", given.scalars.len())
            }
        };
        return Err(wrong(given.at, reason));
    }
    Ok(())
}

/// A suggestion for an unknown uniform.
fn near(name: &str, program: &Program) -> String {
    let uniforms = program.variables.iter();
    let uniforms = uniforms.filter(|v| v.storage == Storage::Uniform);
    let names = uniforms.map(|v| program.names.text(v.name));
    let distances = names.map(|n| (strsim::damerau_levenshtein(n, name), n));
    let near = distances.filter(|(distance, _)| *distance <= 2).min();
    near.map_or(String::new(), |(_, n)| format!("; did you mean `{n}`?"))
}

/// The message about a construct that cannot be run.
pub(super) fn refused(
    sources: &Sources,
    program: &Program,
    name: &str,
    refusal: &Refusal,
) -> String {
    let at = span(program, refusal.at).and_then(|span| position(sources, span));
    let at = at.unwrap_or_else(|| name.to_string());
    format!("{at}: unsupported: {}", refusal.what)
}
