//! Analyses of a whole shader for rules. Each is computed on first use.

use super::broken::{Broken, Obstacles};
use super::inactive_words::InactiveWords;
use super::march::{March, marches};
use super::sample::{SampleCache, Supplier};
use super::words::counts;
use rustc_hash::FxHashMap;
use shaderlint_detect::embed::Embedder;
use shaderlint_flow::ranges::{Giver, Interval, Query, Ranges, Reason, Side};
use shaderlint_flow::reaching_definitions::ReachingDefinitions;
use shaderlint_flow::{
    Calls, DefiniteAssignment, DistanceField, Effects, Gradient, Jump, Liveness, Loops, Start,
    Uniformity, Work, Writes, fields, gradients, is_same, jump, origin, trace,
};
use shaderlint_ir::{Module, OpId, OpKind, Provenance, Root, lower};
use shaderlint_semantic::{
    FunctionRef, Mentions, Program, Reachability, Scalar, Stage, Structure, Value, channel,
};
use shaderlint_syntax::Name;
use shaderlint_syntax::ast::ExprId;
use shaderlint_text::Span;
use std::cell::OnceCell;
use std::sync::{Arc, OnceLock};

/// Context of a shader that its text does not show.
#[derive(Clone, Copy, Default)]
pub struct ShaderContext<'a> {
    /// Facts from the page or script that contains the shader.
    pub embedder: Embedder,
    /// By channel: whether its texture has mipmaps; `None` where unknown.
    pub mipmapped: [Option<bool>; 4],
    /// Supplies the inputs of a sample run; `None` if the shader must not be run.
    pub supplier: Option<&'a dyn Supplier>,
    /// Whether a host adds code that may use what the shader declares.
    pub is_fragment: bool,
}

/// A bias that always selects the sharpest mipmap level.
const SHARPEST: f32 = -8.0;

/// Analyses that depend on the shader alone, each computed on first use. They can be cached with the
/// shader, and shared.
#[derive(Default, Debug)]
pub struct CachedFacts {
    module: OnceLock<Arc<Module>>,
    structure: OnceLock<Structure>,
    calls: OnceLock<Calls>,
    loops: OnceLock<Loops>,
    mentions: OnceLock<Mentions>,
    reaching_definitions: OnceLock<ReachingDefinitions>,
    liveness: OnceLock<Liveness>,
    ranges: OnceLock<Ranges>,
    definite_assignment: OnceLock<DefiniteAssignment>,
    entry: OnceLock<Option<FunctionRef>>,
    effects: OnceLock<Effects>,
    writes: OnceLock<Writes>,
    reach: OnceLock<Reachability>,
    work: OnceLock<Work>,
    uniformity: OnceLock<Uniformity>,
    gradients: OnceLock<Vec<Gradient>>,
    marches: OnceLock<Vec<March>>,
}

impl CachedFacts {
    /// The IR of the shader.
    pub fn module(&self, program: &Program) -> &Arc<Module> {
        self.module.get_or_init(|| Arc::new(lower(program)))
    }

    /// Number of analyses computed so far.
    fn answers(&self) -> usize {
        let all = [
            self.module.get().is_some(),
            self.structure.get().is_some(),
            self.calls.get().is_some(),
            self.loops.get().is_some(),
            self.mentions.get().is_some(),
            self.reaching_definitions.get().is_some(),
            self.liveness.get().is_some(),
            self.ranges.get().is_some(),
            self.definite_assignment.get().is_some(),
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

/// The analyses of one shader, and its context.
pub struct Facts<'a> {
    program: &'a Program,
    known: Arc<CachedFacts>,
    inactive_words: OnceCell<InactiveWords<'a>>,
    word_counts: OnceCell<FxHashMap<&'a str, u32>>,
    pub(super) samples: SampleCache<'a>,
    /// Context of the shader.
    pub around: ShaderContext<'a>,
    /// The items with errors.
    pub(super) broken: Broken<'a>,
}

impl<'a> Facts<'a> {
    /// Facts without context. `known` must be of the same shader.
    pub fn of(program: &'a Program, known: &Arc<CachedFacts>) -> Facts<'a> {
        Facts {
            program,
            known: known.clone(),
            inactive_words: OnceCell::new(),
            word_counts: OnceCell::new(),
            samples: SampleCache::default(),
            around: ShaderContext::default(),
            broken: Broken::default(),
        }
    }

    /// Marks the items with errors, and discards analyses computed without regard to them.
    pub(super) fn break_at(&mut self, obstacles: Obstacles) {
        self.broken = Broken::of(self.program, obstacles);
        if self.broken.any() {
            let module = self.known.module(self.program).clone();
            self.known = Arc::new(CachedFacts {
                module: module.into(),
                ..CachedFacts::default()
            });
        }
    }

    /// Number of cached analyses, computed here or before.
    pub fn answers(&self) -> usize {
        self.known.answers()
    }

    /// The shader.
    pub fn program(&self) -> &'a Program {
        self.program
    }

    /// The IR of the shader.
    pub fn module(&self) -> &Module {
        self.known.module(self.program)
    }

    /// Parents of expressions and statements.
    pub fn structure(&self) -> &Structure {
        self.known
            .structure
            .get_or_init(|| Structure::of(self.program))
    }

    /// The calls and the call graph.
    pub fn calls(&self) -> &Calls {
        self.known.calls.get_or_init(|| Calls::of(self.module()))
    }

    /// The loops and their iteration counts.
    pub fn loops(&self) -> &Loops {
        self.known.loops.get_or_init(|| Loops::of(self.ranges()))
    }

    /// The uses of each variable.
    pub fn mentions(&self) -> &Mentions {
        self.known
            .mentions
            .get_or_init(|| Mentions::of(self.program))
    }

    /// The writes of each variable, and which variables are read.
    pub fn writes(&self) -> &Writes {
        self.known
            .writes
            .get_or_init(|| Writes::of(self.program, self.module(), self.mentions()))
    }

    /// The cost of each function.
    pub fn work(&self) -> &Work {
        self.known.work.get_or_init(|| {
            let iterations = self.loops().iterations();
            let iterations = |l: &shaderlint_ir::Loop| iterations.get(&l.stmt).copied().flatten();
            Work::of(self.module(), self.calls(), iterations)
        })
    }

    /// Which values differ between pixels; none outside of complete fragment shaders.
    pub fn uniformity(&self) -> &Uniformity {
        self.known.uniformity.get_or_init(|| {
            let has_pixels = self.program.stage == Stage::Fragment && self.entry().is_some();
            match has_pixels {
                true => Uniformity::of(self.module()),
                false => Uniformity::default(),
            }
        })
    }

    /// The calls with implicit derivatives in divergent control flow.
    pub fn gradients(&self) -> &[Gradient] {
        self.known.gradients.get_or_init(|| {
            let mut found = gradients(self.module(), self.calls(), || self.uniformity());
            found.retain(|gradient| self.chooses_level(gradient.call));
            found
        })
    }

    /// Whether the derivatives of a call matter: a texture without mipmaps has only one level, and a
    /// large negative bias always selects the sharpest.
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
        self.known
            .marches
            .get_or_init(|| marches(self.ranges(), (self.loops(), self.calls()), self.entry()))
    }

    /// The distance fields that the marching loops move by.
    pub fn fields(&self) -> Vec<DistanceField> {
        fields(self.ranges(), self.marches().iter().map(|march| &march.ray))
    }

    /// Definite assignment on the paths through each function.
    pub fn definite_assignment(&self) -> &DefiniteAssignment {
        self.known.definite_assignment.get_or_init(|| {
            let shader = (self.program, self.module());
            DefiniteAssignment::of(shader, self.calls(), self.mentions(), &|| self.ranges())
        })
    }

    /// Reaching definitions.
    pub fn reaching_definitions(&self) -> &ReachingDefinitions {
        self.known
            .reaching_definitions
            .get_or_init(|| ReachingDefinitions::of(self.program, self.module(), self.calls()))
    }

    /// Liveness: which writes are read.
    pub fn liveness(&self) -> &Liveness {
        self.known
            .liveness
            .get_or_init(|| Liveness::of(self.module(), self.reaching_definitions()))
    }

    /// Value ranges.
    pub fn ranges(&self) -> Query<'_> {
        Query {
            program: self.program,
            module: self.module(),
            defs: self.reaching_definitions(),
            ranges: self.known.ranges.get_or_init(|| {
                let mut ranges = Ranges::default();
                if self.broken.any() {
                    ranges.forget(self.program, |name| self.broken.has(name));
                }
                ranges
            }),
        }
    }

    /// The value ranges of the components of a scalar or vector.
    pub fn range(&self, expr: ExprId) -> impl Iterator<Item = Interval> {
        self.ranges().expr(expr)
    }

    /// The span that determines one end of the range of a component, and a label for it.
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
            Giver::Builtin(function) => format!("`{}` returns {range}", function.name()),
            Giver::Constant | Giver::Operation => match reason.range.single() {
                Some(_) => format!("this is {range}"),
                None => format!("range: {range}"),
            },
            Giver::Condition(true) => format!("if true, the range is {range}"),
            Giver::Condition(false) => format!("if false, the range is {range}"),
            Giver::Loop => format!("loop counter range: {range}"),
            Giver::Host(id) => {
                let variable = self.program.variable(id)?;
                let name = self.program.names.text(variable.name);
                format!("range of `{name}`: {range}")
            }
        })
    }

    /// Whether a bounded comparison shows that two expressions have the same value.
    pub fn is_same(&self, a: ExprId, b: ExprId) -> bool {
        let module = self.module();
        let both = module.op_of(a).zip(module.op_of(b));
        both.is_some_and(|(a, b)| self.is_same_value(a, b))
    }

    /// Whether a bounded comparison shows that two operations have the same value.
    pub fn is_same_value(&self, a: OpId, b: OpId) -> bool {
        is_same(self.module(), self.reaching_definitions(), a, b)
    }

    /// What makes a component of a value discontinuous between neighbouring pixels.
    pub fn jump(&self, op: OpId, lane: u32) -> Option<Jump> {
        jump(self.ranges(), self.uniformity(), (op, lane))
    }

    /// Whether a uniform counts the time since the start.
    pub fn is_time(&self, uniform: Name) -> bool {
        let name = self.program.names.text(uniform);
        let supplier = self.around.supplier;
        supplier.is_some_and(|supplier| supplier.is_time(name))
    }

    /// Whether every page of the host sets a uniform.
    pub fn is_set_by_host(&self, uniform: Name) -> bool {
        let name = self.program.names.text(uniform);
        let supplier = self.around.supplier;
        supplier.is_some_and(|supplier| supplier.knows(name))
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
            // A parameter: may be any of them.
            None => known.iter().all(Option::is_none) || known.contains(&Some(true)),
        }
    }

    /// Calls `visit` with the sources of a component, as [`trace`] does.
    pub fn trace(&self, op: OpId, lane: u32, visit: impl FnMut(Start) -> bool) -> bool {
        trace(
            self.module(),
            self.reaching_definitions(),
            (op, lane),
            visit,
        )
    }

    /// The source of a component, followed through copies.
    pub fn origin(&self, op: OpId, lane: u32) -> Option<Start> {
        origin(self.module(), self.reaching_definitions(), op, lane)
    }

    /// Whether a component is from a uniform or input of this name.
    pub fn is_given(&self, origin: Option<Start>, name: &str) -> bool {
        let Some(Start::Given(variable, _)) = origin else {
            return false;
        };
        let found = self.program.variable(variable);
        let root = self.module().variable(variable).map(|v| v.root);
        matches!(root, Some(Root::Uniform | Root::Input))
            && found.is_some_and(|v| self.program.names.text(v.name) == name)
    }

    /// The entry function: `mainImage` and similar, or `main`.
    pub fn entry(&self) -> Option<FunctionRef> {
        *self.known.entry.get_or_init(|| self.program.entry())
    }

    /// Which expressions and functions have side effects.
    pub fn effects(&self) -> &Effects {
        self.known.effects.get_or_init(|| {
            let (module, structure) = (self.module(), self.structure());
            Effects::of(self.program, module, structure, self.calls(), self.writes())
        })
    }

    /// After which statements control flow does not continue.
    pub fn reach(&self) -> &Reachability {
        self.known
            .reach
            .get_or_init(|| Reachability::of(self.program))
    }

    /// The words in excluded or unused code.
    pub fn inactive_words(&self) -> &InactiveWords<'a> {
        self.inactive_words
            .get_or_init(|| InactiveWords::of(self.program, &self.broken))
    }

    /// Number of occurrences of a word in the user's files, without comments.
    pub fn count(&self, word: &str) -> u32 {
        let counts = self.word_counts.get_or_init(|| counts(self.program));
        counts.get(word).copied().unwrap_or(0)
    }

    /// Addresses of the last file: its declarations can be used in it only. An earlier file, such as
    /// ShaderToy's Common, may be used by other passes. `None` for a fragment and for a text without an entry
    /// function, which others may include.
    pub fn own_file(&self) -> Option<Span> {
        self.entry().filter(|_| !self.around.is_fragment)?;
        let end = self.program.tokens.tokens.last()?.span.start;
        Some(self.program.sources.file_at(end)?.span())
    }
}
