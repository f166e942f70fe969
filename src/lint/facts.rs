//! What rules ask for about a shader as a whole. Each answer is made at the first question.

use super::broken::Broken;
use super::march::{March, marches};
use super::trial::{Supplier, Tried};
use super::unseen::Unseen;
use super::words::count;
use shaderlint_diagnostic::Diagnostic;
use shaderlint_flow::defs::Defs;
use shaderlint_flow::ranges::{Giver, Interval, Query, Ranges, Reason, Side};
use shaderlint_flow::{
    Calls, Effects, Gradient, Jump, Live, Loops, Paths, Start, Uniformity, Work, Writes, gradients,
    is_same, jump, origin, trace,
};
use shaderlint_ir::{Module, OpId, OpKind, Provenance, Root, lower};
use shaderlint_semantic::{
    FunctionRef, Mentions, Program, Reachability, Scalar, Stage, Structure, Value, channel,
};
use shaderlint_syntax::ast::ExprId;
use shaderlint_text::Span;
use shaderlint_text::embed::Embedder;
use std::cell::OnceCell;
use std::sync::{Arc, OnceLock};

/// What is known of where a shader stands and runs, that its text does not say.
#[derive(Clone, Copy, Default)]
pub struct Around<'a> {
    /// The page or script that it stands in.
    pub embedder: Embedder,
    /// By channel: whether its texture has mipmaps, where that is known.
    pub mipmapped: [Option<bool>; 4],
    /// Who knows what it is given, where it may be run.
    pub supplier: Option<&'a dyn Supplier>,
}

/// A bias that takes the sharpest level of a texture for certain.
const SHARPEST: f32 = -8.0;

/// Answers that a shader alone gives, each made when it is first asked for. It can be kept as long as
/// the shader, and shared.
#[derive(Default, Debug)]
pub struct Known {
    module: OnceLock<Arc<Module>>,
    structure: OnceLock<Structure>,
    calls: OnceLock<Calls>,
    loops: OnceLock<Loops>,
    mentions: OnceLock<Mentions>,
    defs: OnceLock<Defs>,
    live: OnceLock<Live>,
    ranges: OnceLock<Ranges>,
    paths: OnceLock<Paths>,
    entry: OnceLock<Option<FunctionRef>>,
    effects: OnceLock<Effects>,
    writes: OnceLock<Writes>,
    reach: OnceLock<Reachability>,
    work: OnceLock<Work>,
    uniformity: OnceLock<Uniformity>,
    gradients: OnceLock<Vec<Gradient>>,
    marches: OnceLock<Vec<March>>,
}

impl Known {
    /// The middle form of the shader.
    pub fn module(&self, program: &Program) -> &Arc<Module> {
        self.module.get_or_init(|| Arc::new(lower(program)))
    }

    /// How many questions have been answered for good.
    fn answers(&self) -> usize {
        let all = [
            self.module.get().is_some(),
            self.structure.get().is_some(),
            self.calls.get().is_some(),
            self.loops.get().is_some(),
            self.mentions.get().is_some(),
            self.defs.get().is_some(),
            self.live.get().is_some(),
            self.ranges.get().is_some(),
            self.paths.get().is_some(),
            self.entry.get().is_some(),
            self.effects.get().is_some(),
            self.writes.get().is_some(),
            self.reach.get().is_some(),
            self.work.get().is_some(),
            self.uniformity.get().is_some(),
            self.gradients.get().is_some(),
            self.marches.get().is_some(),
        ];
        all.into_iter().filter(|is_known| *is_known).count()
    }
}

/// Answers about one shader.
pub struct Facts<'a> {
    program: &'a Program,
    known: Arc<Known>,
    unseen: OnceCell<Unseen<'a>>,
    pub(super) tried: Tried<'a>,
    /// What is known of where it runs.
    pub around: Around<'a>,
    /// What of the shader has errors.
    pub(super) broken: Broken<'a>,
}

impl<'a> Facts<'a> {
    /// Nothing is known of where the shader runs. `known` is of the same shader.
    pub fn of(program: &'a Program, known: &Arc<Known>) -> Facts<'a> {
        Facts {
            program,
            known: known.clone(),
            unseen: OnceCell::new(),
            tried: Tried::default(),
            around: Around::default(),
            broken: Broken::default(),
        }
    }

    /// Makes it know what the errors leave; what was found out without them does not count.
    pub(super) fn break_at(&mut self, errors: &[Diagnostic]) {
        self.broken = Broken::of(self.program, errors);
        if self.broken.any() {
            let module = self.known.module(self.program).clone();
            self.known = Arc::new(Known {
                module: module.into(),
                ..Known::default()
            });
        }
    }

    /// How many questions about the shader alone have been answered, here or before.
    pub fn answers(&self) -> usize {
        self.known.answers()
    }

    /// The shader.
    pub fn program(&self) -> &'a Program {
        self.program
    }

    /// The shader's middle form.
    pub fn module(&self) -> &Module {
        self.known.module(self.program)
    }

    /// Which node stands in which.
    pub fn structure(&self) -> &Structure {
        self.known
            .structure
            .get_or_init(|| Structure::of(self.program))
    }

    /// Who calls whom.
    pub fn calls(&self) -> &Calls {
        self.known.calls.get_or_init(|| Calls::of(self.module()))
    }

    /// The loops.
    pub fn loops(&self) -> &Loops {
        self.known.loops.get_or_init(|| Loops::of(self.ranges()))
    }

    /// Where variables are named.
    pub fn mentions(&self) -> &Mentions {
        self.known
            .mentions
            .get_or_init(|| Mentions::of(self.program))
    }

    /// Where variables are written to, and which are read.
    pub fn writes(&self) -> &Writes {
        self.known
            .writes
            .get_or_init(|| Writes::of(self.program, self.module(), self.mentions()))
    }

    /// How much the functions do.
    pub fn work(&self) -> &Work {
        self.known.work.get_or_init(|| {
            let turns = self.loops().turns();
            let turns = |l: &shaderlint_ir::Loop| turns.get(&l.stmt).copied().flatten();
            Work::of(self.module(), self.calls(), turns)
        })
    }

    /// What differs from pixel to pixel; nothing does where nothing draws pixels.
    pub fn uniformity(&self) -> &Uniformity {
        self.known.uniformity.get_or_init(|| {
            let has_pixels = self.program.stage == Stage::Fragment && self.entry().is_some();
            match has_pixels {
                true => Uniformity::of(self.module()),
                false => Uniformity::default(),
            }
        })
    }

    /// The calls that take derivatives where neighbouring pixels may have parted.
    pub fn gradients(&self) -> &[Gradient] {
        self.known.gradients.get_or_init(|| {
            let mut found = gradients(self.module(), self.calls(), || self.uniformity());
            found.retain(|gradient| self.chooses_level(gradient.call));
            found
        })
    }

    /// Whether anything hangs on the derivatives that a call takes: without mipmaps a texture has one
    /// level to choose, and a bias may take the sharpest for certain.
    pub fn chooses_level(&self, call: OpId) -> bool {
        let module = self.module();
        let OpKind::Builtin(function, list) = module.op(call).kind else {
            return true;
        };
        let [sampler, _, rest @ ..] = module.operands(list) else {
            return true;
        };
        if !function.kind().is_texture() {
            return true;
        }
        let bias = rest.last().map(|op| module.constant(*op));
        let is_sharp = |bias: &[Value]| matches!(bias, [Value::Float(b)] if *b <= SHARPEST);
        match module.provenance(*sampler) {
            _ if bias.is_some_and(is_sharp) => false,
            Provenance::Expr(sampler) => self.may_have_mipmaps(sampler),
            _ => true,
        }
    }

    /// The loops that march along a ray.
    pub fn marches(&self) -> &[March] {
        self.known.marches.get_or_init(|| {
            let (shader, loops) = ((self.program, self.module()), (self.loops(), self.calls()));
            marches(shader, loops, self.defs(), self.entry())
        })
    }

    /// What has a value when, on the paths through the functions.
    pub fn paths(&self) -> &Paths {
        self.known.paths.get_or_init(|| {
            let shader = (self.program, self.module());
            Paths::of(shader, self.calls(), self.mentions(), &|| self.ranges())
        })
    }

    /// Which write each read sees.
    pub fn defs(&self) -> &Defs {
        self.known
            .defs
            .get_or_init(|| Defs::of(self.program, self.module(), self.calls()))
    }

    /// Which writes are ever read.
    pub fn live(&self) -> &Live {
        self.known
            .live
            .get_or_init(|| Live::of(self.module(), self.defs()))
    }

    /// What numbers values may be.
    pub fn ranges(&self) -> Query<'_> {
        Query {
            program: self.program,
            module: self.module(),
            defs: self.defs(),
            ranges: self.known.ranges.get_or_init(|| {
                let mut ranges = Ranges::default();
                if self.broken.any() {
                    ranges.forget(self.program, |name| self.broken.has(name));
                }
                ranges
            }),
        }
    }

    /// What numbers the components of a number or vector may be.
    pub fn range(&self, expr: ExprId) -> impl Iterator<Item = Interval> {
        self.ranges().expr(expr)
    }

    /// Where an end of the range of one of an expression's components comes from, and in which words.
    pub fn reason(&self, expr: ExprId, range: &Interval, side: Side) -> Option<(Span, String)> {
        let op = self.module().op_of(expr)?;
        let query = self.ranges();
        let lane = (0..).zip(query.expr(expr)).find(|(_, r)| r == range)?.0;
        let reason = query.reason(op, lane, side)?;
        let extent = self.module().provenance(reason.op);
        let place = self.program.span(extent.extent(&self.program.tree)?);
        Some((place, self.in_words(&reason)?))
    }

    fn in_words(&self, reason: &Reason) -> Option<String> {
        let module = self.module();
        let of = match module.op(reason.op).kind {
            OpKind::Binary(op, left, _) if op.compares() => left,
            _ => reason.op,
        };
        let is_integer = module.ty(of).scalar_kind().is_some_and(Scalar::is_integer);
        let range = match is_integer {
            true => reason.range.of_integer(),
            false => reason.range.to_string(),
        };
        Some(match reason.giver {
            _ if reason.range.is_any() && !reason.range.takes_both_signs() => return None,
            Giver::Builtin(function) => format!("`{}` gives {range}", function.name()),
            Giver::Constant | Giver::Operation => format!("this is {range}"),
            Giver::Condition(true) => format!("this condition leaves {range}"),
            Giver::Condition(false) => format!("where this does not hold, {range} is left"),
            Giver::Loop => format!("the loop counts {range}"),
            Giver::Host(id) => {
                let variable = self.program.variable(id)?;
                let name = self.program.names.text(variable.name);
                format!("`{name}` is {range}")
            }
        })
    }

    /// Whether two expressions give the same value, as far as a short look tells.
    pub fn is_same(&self, a: ExprId, b: ExprId) -> bool {
        let module = self.module();
        let both = module.op_of(a).zip(module.op_of(b));
        both.is_some_and(|(a, b)| self.is_same_value(a, b))
    }

    /// Whether two operations give the same value, as far as a short look tells.
    pub fn is_same_value(&self, a: OpId, b: OpId) -> bool {
        is_same(self.module(), self.defs(), a, b)
    }

    /// What makes a lane of a value jump between neighbouring pixels.
    pub fn jump(&self, op: OpId, lane: u32) -> Option<Jump> {
        jump(self.ranges(), self.uniformity(), (op, lane))
    }

    /// Whether the texture that an expression names may have mipmaps.
    pub fn may_have_mipmaps(&self, sampler: ExprId) -> bool {
        let named = self.program.variable_of(sampler);
        let name = named
            .and_then(|id| self.program.variable(id))
            .map(|v| v.name);
        let number = name.and_then(|name| channel(self.program.names.text(name)));
        let known = self.around.mipmapped;
        match number.and_then(|number| known.get(number as usize)) {
            Some(known) => *known != Some(false),
            // A parameter: any of them.
            None => known.iter().all(Option::is_none) || known.contains(&Some(true)),
        }
    }

    /// Calls `visit` with what a lane of a value was made of, as [`trace`] does.
    pub fn trace(&self, op: OpId, lane: u32, visit: impl FnMut(Start) -> bool) -> bool {
        trace(self.module(), self.defs(), (op, lane), visit)
    }

    /// What a lane of a value is, copies taken back.
    pub fn origin(&self, op: OpId, lane: u32) -> Option<Start> {
        origin(self.module(), self.defs(), op, lane)
    }

    /// Whether a lane is that of a variable which the host or the language fills in under this name.
    pub fn is_given(&self, origin: Option<Start>, name: &str) -> bool {
        let Some(Start::Given(variable, _)) = origin else {
            return false;
        };
        let found = self.program.variable(variable);
        let root = self.module().variable(variable).map(|v| v.root);
        matches!(root, Some(Root::Uniform | Root::Input))
            && found.is_some_and(|v| self.program.names.text(v.name) == name)
    }

    /// The function that draws: `mainImage` and its kin, or `main`.
    pub fn entry(&self) -> Option<FunctionRef> {
        *self.known.entry.get_or_init(|| self.program.entry())
    }

    /// Which expressions and functions do more than give a value.
    pub fn effects(&self) -> &Effects {
        self.known.effects.get_or_init(|| {
            let (module, structure) = (self.module(), self.structure());
            Effects::of(self.program, module, structure, self.calls(), self.writes())
        })
    }

    /// Behind which statements nothing runs.
    pub fn reach(&self) -> &Reachability {
        self.known
            .reach
            .get_or_init(|| Reachability::of(self.program))
    }

    /// The words that the compiler does not see.
    pub fn unseen(&self) -> &Unseen<'a> {
        self.unseen
            .get_or_init(|| Unseen::of(self.program, &self.broken))
    }

    /// How often a word stands in the user's files, comments aside.
    pub fn count(&self, word: &str) -> usize {
        count(self.program, word)
    }

    /// Addresses of the last file, which is nobody's else: what it declares is used in it or not at
    /// all. A file before it, such as ShaderToy's Common, belongs to other passes too. `None` where
    /// nothing runs, because the text is a part that others make use of.
    pub fn own_file(&self) -> Option<Span> {
        self.entry()?;
        let end = self.program.tokens.tokens.last()?.span.start;
        Some(self.program.sources.file_at(end)?.span())
    }
}
