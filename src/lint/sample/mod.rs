//! Sample runs of a shader: some pixels of the frame, at a few times.

mod bench;
mod culprit;
mod initial_value;
mod more_iterations;
mod open;
mod pixels;
mod verdict;

use super::facts::Facts;
use super::march::{Hit, MarchOutcome};
use rustc_hash::FxHashSet;
use shaderlint_exec::{
    CompileOptions, ErrorDirection, GpuProfile, LANES, Observations, Sampled, Watch,
};
use shaderlint_flow::{Uniformity, Varying};
use shaderlint_ir::{Module, OpId, Root};
use shaderlint_semantic::{Dialect, Pass, Program, VariableId};
use std::cell::{Cell, OnceCell, RefCell};

pub use bench::{Bench, Round, SIZE, SampleLimit, colors};
pub use culprit::{Culprit, report_broken};
pub use more_iterations::is_apart;
pub use pixels::{SampledPixel, is_too_bright, luminance, share};
pub use verdict::{OFTEN, UnreportedFault, Verdict};

use shaderlint_exec::{Bytecode, Draw};

/// The time and mouse state of a sampled frame.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Instant {
    /// Seconds since the start.
    pub time: f64,
    /// The mouse, if it was pressed.
    pub mouse: Option<Press>,
}

/// State of the mouse.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Press {
    /// Position in pixels from the lower left corner.
    pub at: [f64; 2],
    /// Whether the button is still down.
    pub is_down: bool,
}

/// The instants of a sample run: two without a mouse, and two later ones with it.
pub const INSTANTS: [Instant; 4] = [
    Instant::at(0.0),
    Instant::at(2.3),
    Instant {
        time: 10.7,
        mouse: Some(Press {
            at: [410.0, 420.0],
            is_down: true,
        }),
    },
    Instant {
        time: 43.1,
        mouse: Some(Press {
            at: [890.0, 300.0],
            is_down: false,
        }),
    },
];

/// Instants at which a claim is checked again before it is made: other times, and other places of the
/// mouse.
pub(crate) const LATER: [Instant; 16] = [
    Instant::at(0.7),
    Instant::pressed(1.4, [20.0, 20.0], true),
    Instant::at(4.1),
    Instant::pressed(6.3, [1260.0, 20.0], true),
    Instant::pressed(8.6, [640.0, 360.0], true),
    Instant::at(13.9),
    Instant::pressed(17.8, [20.0, 700.0], true),
    Instant::at(22.4),
    Instant::pressed(28.1, [1260.0, 700.0], true),
    Instant::pressed(34.7, [960.0, 540.0], false),
    Instant::at(52.6),
    Instant::pressed(61.3, [320.0, 180.0], true),
    Instant::at(77.2),
    Instant::pressed(96.9, [320.0, 540.0], true),
    Instant::at(133.7),
    Instant::pressed(211.5, [960.0, 180.0], true),
];

impl Instant {
    const fn pressed(time: f64, at: [f64; 2], is_down: bool) -> Instant {
        Instant {
            time,
            mouse: Some(Press { at, is_down }),
        }
    }

    /// A time in seconds, without a mouse.
    pub const fn at(time: f64) -> Instant {
        Instant { time, mouse: None }
    }
}

/// Supplies the inputs of a shader for a sample run.
pub trait Supplier {
    /// A draw with all known inputs; textures are empty, and unknown inputs are zero.
    fn draw<'c>(&self, code: &'c Bytecode, size: [u32; 2], instant: &Instant) -> Draw<'c>;

    /// Whether the value of a uniform or input is known.
    fn knows(&self, name: &str) -> bool;

    /// Whether a uniform counts the time since the start.
    fn is_time(&self, name: &str) -> bool;
}

/// The result of a sample run.
#[derive(Clone, Debug)]
pub struct SampleRun {
    /// Number of sampled pixels, over all instants.
    pub pixels: u64,
    /// The events of all pixels.
    pub seen: Observations,
    /// By instant of [`INSTANTS`].
    pub frames: Vec<SampleFrame>,
}

/// The samples of one instant.
#[derive(Clone, Debug)]
pub struct SampleFrame {
    /// Time and mouse state.
    pub instant: Instant,
    /// The sampled pixels.
    pub sampled: Sampled,
    /// By pixel: the red, green and blue channels of the first output.
    pub colors: Vec<[f32; 3]>,
}

impl SampleRun {
    /// Nothing, at the instants of a sample run.
    fn empty() -> SampleRun {
        SampleRun {
            pixels: 0,
            seen: Observations::default(),
            frames: Vec::new(),
        }
    }

    /// Adds more pixels at the same instants.
    fn add(&mut self, more: SampleRun) {
        self.pixels += more.pixels;
        self.seen.add(more.seen);
        if self.frames.is_empty() {
            self.frames = more.frames;
            return;
        }
        for (own, more) in self.frames.iter_mut().zip(more.frames) {
            own.sampled.add(more.sampled);
            own.colors.extend(more.colors);
        }
    }

    /// Instructions per pixel, as for one lane.
    fn price(&self) -> u64 {
        let spent: u64 = self.frames.iter().map(|frame| frame.sampled.spent).sum();
        (spent * LANES as u64).checked_div(self.pixels).unwrap_or(0)
    }

    /// What was sampled, as a note of a finding.
    pub fn sampled_note(&self) -> String {
        let times = self.frames.iter().map(|s| s.instant.time.to_string());
        let times: Vec<String> = times.collect();
        let times = match times.as_slice() {
            [first @ .., last] if !first.is_empty() => format!("{} and {last}", first.join(", ")),
            other => other.join(", "),
        };
        let [width, height] = SIZE;
        let pixels = shaderlint_text::number::grouped(self.pixels);
        format!("sampled {pixels} pixels of a {width}x{height} frame at {times} s")
    }
}

/// The GPU profiles on which a finding must hold: with the largest rounding error in both directions.
const GPU_PROFILES: [GpuProfile; 3] = [
    GpuProfile::Inexact(ErrorDirection::Out),
    GpuProfile::Inexact(ErrorDirection::In),
    GpuProfile::Mobile,
];

/// Number of quads per instant of the first run that watches comparisons.
const COMPARED: usize = 24;

/// Cached results of the sample runs of a shader.
#[derive(Default)]
pub(crate) struct SampleCache<'a> {
    pub supplier: Option<&'a dyn Supplier>,
    pub limit: SampleLimit,
    bench: OnceCell<Option<Bench>>,
    rounds: [OnceCell<Option<SampleRun>>; Round::COUNT],
    gpu_profiles: [OnceCell<Option<SampleRun>>; GPU_PROFILES.len()],
    unknown: OnceCell<Uniformity>,
    is_image_known: OnceCell<bool>,
    pub hits: OnceCell<Vec<Hit>>,
    pub stuck: OnceCell<Vec<MarchOutcome>>,
    pub moving: OnceCell<Uniformity>,
    later: OnceCell<Option<SampleRun>>,
    compared: OnceCell<Option<SampleRun>>,
    /// Operations that other rules have reported.
    reported: RefCell<FxHashSet<OpId>>,
    /// Whether a rule has reported that nothing is visible.
    is_blank: Cell<bool>,
}

impl<'a> Facts<'a> {
    /// How the shader is sampled; `None` if its inputs are unknown, it would take too long, or sampling is
    /// off.
    pub fn bench(&self) -> Option<(&Bench, &'a dyn Supplier)> {
        let supplier = self.samples.supplier?;
        let bench = self.samples.bench.get_or_init(|| Bench::of(self));
        bench.as_ref().map(|bench| (bench, supplier))
    }

    /// The sample run of the shader, with all pixels: what a claim is made of.
    pub fn sample_run(&self) -> Option<&SampleRun> {
        self.round(Round::Last)
    }

    /// The sample run up to a round. Only what the first rounds leave open is worth the last.
    pub fn round(&self, round: Round) -> Option<&SampleRun> {
        let [first, second, last] = &self.samples.rounds;
        let extend = |before: Option<&SampleRun>| {
            let (bench, supplier) = self.bench()?;
            let quads = bench.quads(round, before)?;
            match before {
                Some(before) => bench.extend(before, supplier, quads, round),
                None => bench.extend(&SampleRun::empty(), supplier, quads, round),
            }
        };
        let run = match round {
            Round::First => first.get_or_init(|| extend(None)),
            Round::Second => second.get_or_init(|| extend(Some(self.round(Round::First)?))),
            Round::Last => last.get_or_init(|| extend(Some(self.round(Round::Second)?))),
        };
        run.as_ref()
    }

    /// Whether the image is known, and the first pixels do not refute a claim about it.
    pub fn may_look(&self, test: impl FnOnce(&SampleRun) -> bool) -> bool {
        self.is_image_known() && self.round(Round::First).is_some_and(test)
    }

    /// Whether a test holds for the sample run, and on all GPU profiles.
    pub fn is_seen(&self, mut test: impl FnMut(&SampleRun) -> bool) -> bool {
        if !self.sample_run().is_some_and(&mut test) {
            return false;
        }
        let mut others = GPU_PROFILES.iter().zip(&self.samples.gpu_profiles);
        others.all(|(gpu_profile, slot)| {
            let run = || self.smaller(Watch::Faults, *gpu_profile);
            slot.get_or_init(run).as_ref().is_none_or(&mut test)
        })
    }

    /// Smaller sample runs that watch for these events, exact and on each GPU profile; `None` for those that
    /// take too long.
    pub fn smaller_runs(&self, watch: Watch) -> impl Iterator<Item = Option<SampleRun>> {
        let others = GPU_PROFILES.into_iter();
        let all = std::iter::once(GpuProfile::Exact).chain(others);
        all.map(move |gpu_profile| self.smaller(watch, gpu_profile))
    }

    fn smaller(&self, watch: Watch, gpu_profile: GpuProfile) -> Option<SampleRun> {
        let (bench, supplier) = self.bench()?;
        let options = CompileOptions {
            watch,
            gpu_profile,
            ..CompileOptions::default()
        };
        let quads = self.fewer_quads()?;
        bench.run(&self.compiled(&options)?, supplier, quads)
    }

    /// Half of the quads of the sample run, per instant.
    pub(crate) fn fewer_quads(&self) -> Option<usize> {
        let (bench, _) = self.bench()?;
        let quads = bench.quads(Round::Last, self.round(Round::First))?;
        Some(quads.div_ceil(2))
    }

    /// A small run at later instants that watches for these events.
    pub fn later_run(&self, watch: Watch) -> Option<SampleRun> {
        let (bench, supplier) = self.bench()?;
        let options = CompileOptions {
            watch,
            ..CompileOptions::default()
        };
        let quads = self.fewer_quads()?;
        bench.run_at(&LATER, &self.compiled(&options)?, supplier, (quads, 0))
    }

    /// Whether a test holds at later instants, with other places of the mouse.
    pub fn is_seen_later(&self, test: impl FnMut(&SampleRun) -> bool) -> bool {
        let run = || self.later_run(Watch::Faults);
        let later = self.samples.later.get_or_init(run);
        later.as_ref().is_some_and(test)
    }

    /// A run of few pixels that watches comparisons.
    pub fn compared(&self) -> Option<&SampleRun> {
        let run = || {
            let options = CompileOptions {
                watch: Watch::Comparisons,
                ..CompileOptions::default()
            };
            // What a small run tells is asked only if the shader can be run further.
            self.fewer_quads()?;
            let (bench, supplier) = self.bench()?;
            bench.run(&self.compiled(&options)?, supplier, COMPARED)
        };
        self.samples.compared.get_or_init(run).as_ref()
    }

    /// The bytecode of the shader; `None` if it cannot be run, or is too large.
    pub fn compiled(&self, options: &CompileOptions) -> Option<Bytecode> {
        let options = CompileOptions {
            most: self.samples.limit.instructions(),
            ..*options
        };
        shaderlint_exec::compile(self.program(), self.module(), &options).ok()
    }

    /// What depends on textures and other unknown inputs.
    fn unknown(&self) -> &Uniformity {
        self.samples.unknown.get_or_init(|| {
            let (program, module) = (self.program(), self.module());
            Uniformity::spread(module, |_| {
                let supplier = self.samples.supplier;
                let all = unknown(program, module, |name| {
                    supplier.is_some_and(|s| s.knows(name))
                });
                all.map(Varying::Variable).collect()
            })
        })
    }

    /// Whether neither the value of an operation nor its execution depends on unknown inputs.
    pub fn is_known(&self, op: OpId) -> bool {
        let unknown = self.unknown();
        !unknown.varies(Varying::Value(op)) && !unknown.is_divergent(op)
    }

    /// The sample run, if its colours are shown as an image and do not depend on unknown inputs.
    pub fn sampled_image(&self) -> Option<&SampleRun> {
        match self.is_image_known() {
            true => self.sample_run(),
            false => None,
        }
    }

    /// Whether shaders are run, the outputs are shown as an image, and they do not depend on unknown inputs.
    pub fn is_image_known(&self) -> bool {
        let is_known = &self.samples.is_image_known;
        *is_known.get_or_init(|| self.knows_image())
    }

    fn knows_image(&self) -> bool {
        let is_shown = match self.program().dialect {
            Dialect::ShaderToy(pass) => pass == Pass::Image,
            _ => true,
        };
        let is_off = self.samples.supplier.is_none() || self.samples.limit.pixels == 0;
        if !is_shown || is_off {
            return false;
        }
        let outputs = self.outputs();
        let mut given = outputs.iter().map(|v| Varying::Variable(*v));
        outputs.len() == 1 && !given.any(|v| self.unknown().varies(v))
    }

    /// Whether the image depends on the pixel coordinates.
    pub fn is_computed(&self) -> bool {
        let uniformity = self.uniformity();
        let mut outputs = self.outputs().into_iter();
        outputs.any(|v| uniformity.varies(Varying::Variable(v)))
    }

    /// The outputs: the `out` parameters of the entry function, or the written outputs of the stage.
    pub fn outputs(&self) -> Vec<VariableId> {
        let module = self.module();
        let entry = self.entry();
        let known = entry.and_then(|f| module.function(f));
        let parameters = known.map_or(&[][..], |f| module.parameters(f)).iter();
        let is_out = |id: &VariableId| {
            let root = module.variable(*id).map(|v| v.root);
            matches!(root, Some(Root::ParameterOut | Root::ParameterInout))
        };
        let handed: Vec<VariableId> = parameters.copied().filter(is_out).collect();
        if !handed.is_empty() {
            return handed;
        }
        let variables = module.variables.iter().zip(0..);
        let given = variables.filter(|(v, _)| v.root == Root::Output);
        // Built-in outputs count only if the shader writes to them.
        let ids = given.map(|(_, id)| VariableId(id));
        let written = |id: &VariableId| self.program().variable(*id).is_some_and(|v| v.written);
        ids.filter(written).collect()
    }

    /// Records that a rule has reported an operation.
    pub fn mark_reported(&self, op: Option<OpId>) {
        self.samples.reported.borrow_mut().extend(op);
    }

    /// Records that a rule has reported that nothing is visible.
    pub fn mark_blank(&self) {
        self.samples.is_blank.set(true);
    }

    /// Whether a rule has reported that nothing is visible, so that others do not repeat it.
    pub fn is_blank(&self) -> bool {
        self.samples.is_blank.get()
    }

    /// Whether a rule has reported an operation.
    pub fn is_reported(&self, op: OpId) -> bool {
        self.samples.reported.borrow().contains(&op)
    }
}

/// The uniforms, textures and inputs with unknown values.
fn unknown<'m>(
    program: &'m Program,
    module: &'m Module,
    knows: impl Fn(&str) -> bool + 'm,
) -> impl Iterator<Item = VariableId> + 'm {
    let variables = module.variables.iter().zip(0..);
    let given = variables.filter(|(v, _)| matches!(v.root, Root::Uniform | Root::Input));
    let ids = given.map(|(_, id)| VariableId(id));
    ids.filter(move |id| {
        let name = program.variable(*id).map(|v| program.names.text(v.name));
        !name.is_some_and(&knows)
    })
}
