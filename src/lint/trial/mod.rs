//! What runs of a shader show: some pixels of its picture, at a few instants. It tells what was seen,
//! and of no other pixels.

mod bench;
mod culprit;
mod hit;
mod longer;
mod picture;
mod verdict;

use super::facts::Facts;
use rustc_hash::FxHashSet;
use shaderlint_exec::{CompileOptions, Lean, Persona, Sampled, Seen, Watch};
use shaderlint_flow::{Uniformity, Varying};
use shaderlint_ir::{Module, OpId, Root};
use shaderlint_semantic::{Dialect, Pass, Program, VariableId};
use std::cell::{Cell, OnceCell, RefCell};

pub use bench::{Bench, SIZE, TrialLimit, colors};
pub use culprit::{Culprit, percent, report_broken};
pub use hit::Hit;
pub use longer::is_apart;
pub use picture::{SampledPixel, is_too_bright, luminance, share};
pub use verdict::{Untold, Verdict};

use shaderlint_exec::{Code, Draw};

/// When a picture is looked at.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Instant {
    /// Seconds since the start.
    pub time: f64,
    /// The mouse, where it has come.
    pub mouse: Option<Press>,
}

/// The mouse over the picture.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Press {
    /// Where it is, in pixels from the left and from below.
    pub at: [f64; 2],
    /// Whether its button is held down still.
    pub is_down: bool,
}

/// The instants of a trial: the first frame, one soon after it, and later ones with a mouse.
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

impl Instant {
    /// A time, no mouse near.
    pub const fn at(time: f64) -> Instant {
        Instant { time, mouse: None }
    }
}

/// Who knows what a shader is given when it runs.
pub trait Supplier {
    /// A draw with all that is known; textures are empty, and what is not known is zero.
    fn draw<'c>(&self, code: &'c Code, size: [u32; 2], instant: &Instant) -> Draw<'c>;

    /// Whether a uniform or an input holds the same wherever the shader is drawn.
    fn knows(&self, name: &str) -> bool;
}

/// What was seen of a shader.
#[derive(Clone, Debug)]
pub struct Trial {
    /// How many pixels ran.
    pub pixels: u64,
    /// What was seen in all of them.
    pub seen: Seen,
    /// By instant of [`INSTANTS`].
    pub shots: Vec<TrialShot>,
}

/// What was seen at an instant.
#[derive(Clone, Debug)]
pub struct TrialShot {
    /// The instant.
    pub instant: Instant,
    /// The pixels.
    pub sampled: Sampled,
    /// By pixel: what the shader gives, as far as it is shown.
    pub colors: Vec<[f32; 3]>,
}

impl Trial {
    /// What was run, as a note of a finding: findings say no more than that.
    pub fn told(&self) -> String {
        let times = self.shots.iter().map(|s| s.instant.time.to_string());
        let times: Vec<String> = times.collect();
        let times = match times.as_slice() {
            [first @ .., last] if !first.is_empty() => format!("{} and {last}", first.join(", ")),
            other => other.join(", "),
        };
        let [width, height] = SIZE;
        let pixels = self.pixels;
        format!("seen in a run of {pixels} pixels of {width}x{height}, at {times} s")
    }
}

/// The GPUs that a finding has to hold on: as inexact as they may be, to both sides.
const PERSONAS: [Persona; 3] = [
    Persona::Inexact(Lean::Out),
    Persona::Inexact(Lean::In),
    Persona::Mobile,
];

/// What is kept of the trials of a shader.
#[derive(Default)]
pub(crate) struct Tried<'a> {
    pub supplier: Option<&'a dyn Supplier>,
    pub limit: TrialLimit,
    bench: OnceCell<Option<Bench>>,
    unwatched: OnceCell<Option<Code>>,
    usual: OnceCell<Option<Trial>>,
    personas: [OnceCell<Option<Trial>>; PERSONAS.len()],
    unknown: OnceCell<Uniformity>,
    hits: OnceCell<Vec<Hit>>,
    /// Operations of which other rules have told.
    told: RefCell<FxHashSet<OpId>>,
    /// Whether a rule has told why nothing can be seen.
    is_blank: Cell<bool>,
}

impl<'a> Facts<'a> {
    /// How the shader is run; `None` where it is not: nobody knows what it is given, it would take
    /// too long, or nobody wants it.
    pub fn bench(&self) -> Option<(&Bench, &'a dyn Supplier)> {
        let supplier = self.tried.supplier?;
        let bench = self.tried.bench.get_or_init(|| Bench::of(self, supplier));
        bench.as_ref().map(|bench| (bench, supplier))
    }

    /// What a run of the shader showed.
    pub fn trial(&self) -> Option<&Trial> {
        let run = || {
            let (bench, supplier) = self.bench()?;
            bench.run(bench.watched(), supplier, bench.quads)
        };
        self.tried.usual.get_or_init(run).as_ref()
    }

    /// Whether something was seen, and would be on every other GPU.
    pub fn is_seen(&self, mut test: impl FnMut(&Trial) -> bool) -> bool {
        if !self.trial().is_some_and(&mut test) {
            return false;
        }
        let mut others = PERSONAS.iter().zip(&self.tried.personas);
        others.all(|(persona, slot)| {
            let run = || self.smaller(Watch::Faults, *persona);
            slot.get_or_init(run).as_ref().is_none_or(&mut test)
        })
    }

    /// What smaller runs of the shader show, here and on every other GPU, where this is watched;
    /// `None` of those that take too long.
    pub fn smaller_runs(&self, watch: Watch) -> impl Iterator<Item = Option<Trial>> {
        let others = PERSONAS.into_iter();
        let all = std::iter::once(Persona::Exact).chain(others);
        all.map(move |persona| self.smaller(watch, persona))
    }

    fn smaller(&self, watch: Watch, persona: Persona) -> Option<Trial> {
        let (bench, supplier) = self.bench()?;
        let options = CompileOptions {
            watch,
            persona,
            ..CompileOptions::default()
        };
        let code = self.compiled(&options)?;
        bench.run(&code, supplier, bench.quads.div_ceil(4))
    }

    /// The shader as register code that watches nothing.
    pub fn unwatched(&self) -> Option<&Code> {
        let compile = || self.compiled(&CompileOptions::default());
        self.tried.unwatched.get_or_init(compile).as_ref()
    }

    /// The shader as register code; `None` where it cannot be run, or grows too large.
    pub fn compiled(&self, options: &CompileOptions) -> Option<Code> {
        let options = CompileOptions {
            most: self.tried.limit.instructions(),
            ..*options
        };
        shaderlint_exec::compile(self.program(), self.module(), &options).ok()
    }

    /// What hangs on textures, and on other things that nobody knows.
    fn unknown(&self) -> &Uniformity {
        self.tried.unknown.get_or_init(|| {
            let (program, module) = (self.program(), self.module());
            Uniformity::spread(module, |_| {
                let supplier = self.tried.supplier;
                let all = unknown(program, module, |name| {
                    supplier.is_some_and(|s| s.knows(name))
                });
                all.map(Varying::Variable).collect()
            })
        })
    }

    /// Whether the value of an operation, and whether it runs at all, hangs on nothing that nobody
    /// knows.
    pub fn is_known(&self, op: OpId) -> bool {
        let unknown = self.unknown();
        !unknown.varies(Varying::Value(op)) && !unknown.is_divergent(op)
    }

    /// The trial, where its colours are a picture, which hangs on nothing that nobody knows.
    pub fn picture(&self) -> Option<&Trial> {
        let trial = self.trial()?;
        let is_shown = match self.program().dialect {
            Dialect::ShaderToy(pass) => pass == Pass::Image,
            _ => true,
        };
        let outputs = self.outputs();
        let unknown = self.unknown();
        let mut given = outputs.iter().map(|v| Varying::Variable(*v));
        let is_known = is_shown && outputs.len() == 1 && !given.any(|v| unknown.varies(v));
        is_known.then_some(trial)
    }

    /// Whether the picture hangs on the place of the pixel.
    pub fn is_computed(&self) -> bool {
        let uniformity = self.uniformity();
        let mut outputs = self.outputs().into_iter();
        outputs.any(|v| uniformity.varies(Varying::Variable(v)))
    }

    /// What the shader gives: what its entry hands back to the player, or the outputs of the stage.
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
        // The language has more outputs than a shader writes to.
        let ids = given.map(|(_, id)| VariableId(id));
        let written = |id: &VariableId| self.program().variable(*id).is_some_and(|v| v.written);
        ids.filter(written).collect()
    }

    /// Where the shader decides whether a ray has hit something.
    pub fn hits(&self) -> &[Hit] {
        self.tried.hits.get_or_init(|| hit::hits(self))
    }

    /// Notes that a rule tells of what an operation does.
    pub fn tell(&self, op: Option<OpId>) {
        self.tried.told.borrow_mut().extend(op);
    }

    /// Notes that a rule tells why nothing can be seen.
    pub fn tell_blank(&self) {
        self.tried.is_blank.set(true);
    }

    /// Whether a rule has told why nothing can be seen, so that no other need wonder.
    pub fn is_blank(&self) -> bool {
        self.tried.is_blank.get()
    }

    /// Whether a rule has told of an operation.
    pub fn is_told(&self, op: OpId) -> bool {
        self.tried.told.borrow().contains(&op)
    }
}

/// The uniforms, textures and inputs that nobody knows.
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
